// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <utility>

#include "base/hdf5_file.hpp"
#include "base/seal.hpp"

namespace dmp {

/// Writes one sealed HDF5 file, whole or not at all: under another name until finish(), then in place of what was
/// there.
class SealedWriter {
  public:
    /// Throws ResourceError when the file cannot be made.
    SealedWriter(std::filesystem::path file, SealedKind kind);
    [[nodiscard]] Hdf5Writer& contents() { return contents_; }
    /// Closes, seals and gives the file its name; after it, the disk has it. Throws ResourceError; what was there under
    /// the name then stays.
    void finish();

  private:
    /// The file under its other name; removes it if it still has that.
    class Unfinished {
      public:
        explicit Unfinished(std::filesystem::path file) : file_(std::move(file)) {}
        ~Unfinished();
        Unfinished(const Unfinished&) = delete;
        Unfinished& operator=(const Unfinished&) = delete;
        [[nodiscard]] const std::filesystem::path& path() const { return file_; }

      private:
        std::filesystem::path file_;
    };

    std::filesystem::path file_;
    SealedKind kind_;
    Unfinished unfinished_;  // before the contents, which are closed before it goes
    Hdf5Writer contents_;
};

/// Reads one sealed HDF5 file, which is checked in full before HDF5 looks at it. Throws InputError as check_seal does.
class SealedReader {
  public:
    SealedReader(const std::filesystem::path& file, SealedKind kind);

    [[nodiscard]] const Hdf5Reader& contents() const { return contents_; }

  private:
    Hdf5Reader contents_;
};

}  // namespace dmp
