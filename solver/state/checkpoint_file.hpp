// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "base/sealed_file.hpp"

namespace dmp::solver {

/// Kind and version in a checkpoint's seal; the version increases with each change that an earlier dmp cannot read.
inline constexpr SealedKind checkpoint_kind{"checkpoint", 1};

/// Writes one checkpoint, completely or not at all: contents() receives the arrays and texts, finish() seals the file
/// and renames it to its final name. Throws ResourceError. Used by one process.
class CheckpointWriter : public SealedWriter {
  public:
    explicit CheckpointWriter(const std::filesystem::path& file) : SealedWriter(file, checkpoint_kind) {}
};

/// Reads one checkpoint, after checking it completely. Throws an InputError with the reason: not readable, no
/// checkpoint, of a newer format, truncated, damaged.
class CheckpointReader : public SealedReader {
  public:
    explicit CheckpointReader(const std::filesystem::path& file) : SealedReader(file, checkpoint_kind) {}
};

}  // namespace dmp::solver
