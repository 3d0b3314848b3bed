// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "base/sealed_file.hpp"

namespace dmp::solver {

/// What checkpoints are sealed as; a change of their contents that an earlier dmp cannot read counts the version up.
inline constexpr SealedKind checkpoint_kind{"checkpoint", 1};

/// Writes one checkpoint, whole or not at all: contents() takes the arrays and texts, finish() seals the file and gives
/// it its name. Throws ResourceError. One process writes it.
class CheckpointWriter : public SealedWriter {
  public:
    explicit CheckpointWriter(const std::filesystem::path& file) : SealedWriter(file, checkpoint_kind) {}
};

/// Reads one checkpoint, checked in full before anything in it is believed. Throws InputError that says what it is:
/// not readable, no checkpoint, of a newer format, truncated, damaged.
class CheckpointReader : public SealedReader {
  public:
    explicit CheckpointReader(const std::filesystem::path& file) : SealedReader(file, checkpoint_kind) {}
};

}  // namespace dmp::solver
