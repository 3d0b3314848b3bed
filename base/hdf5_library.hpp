// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What writing and reading HDF5 files share. Only the files that include this one know HDF5.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include <hdf5.h>

#include "base/hdf5_file.hpp"

namespace dmp::hdf5 {

/// Something HDF5 opened, closed with this object.
class Handle {
  public:
    Handle() = default;
    Handle(hid_t id, herr_t (*closer)(hid_t)) : id_(id), closer_(closer) {}
    ~Handle() { close(); }
    Handle(Handle&& other) noexcept
        : id_(std::exchange(other.id_, H5I_INVALID_HID)), closer_(std::exchange(other.closer_, nullptr)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(closer_, other.closer_);
        return *this;
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    [[nodiscard]] hid_t id() const { return id_; }
    /// Leaves it open for good, and returns what it was.
    hid_t release() { return std::exchange(id_, H5I_INVALID_HID); }
    /// Negative when something could not be written.
    herr_t close() {
        const hid_t id = release();
        return id >= 0 ? closer_(id) : 0;
    }

  private:
    hid_t id_ = H5I_INVALID_HID;
    herr_t (*closer_)(hid_t) = nullptr;
};

/// Before the first file: HDF5 is not to print its errors, which come with exceptions, nor to do anything at the exit.
void prepare();

/// Why the last call failed, in the system's words where it was a system call; forgets it.
std::string reason();

/// How elements lie in memory, and how in files: little-endian.
hid_t memory_type(Hdf5Type type);
hid_t file_type(Hdf5Type type);
/// What a datatype of a file is, whatever its byte order; texts only of fixed size.
Hdf5Type type_of(hid_t datatype);
/// "float64", "text", ...
const char* name_of(Hdf5Type type);

/// UTF-8 of `bytes` bytes, filled up with zeros. HDF5 knows no texts of size 0: those take 1.
Handle text_type(std::size_t bytes);

/// No locks on files: parallel file systems often have none, and dmp's files appear whole by renaming.
Handle file_access();

}  // namespace dmp::hdf5
