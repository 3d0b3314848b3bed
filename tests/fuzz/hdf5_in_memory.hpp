// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/hdf5_file.hpp"

namespace dmp::tests {

/// A dataset: numbers of one type, or one text.
struct StoredDataset {
    Hdf5Type type = Hdf5Type::other;
    std::vector<char> bytes;

    [[nodiscard]] std::size_t width() const;  ///< of an element [bytes]
    [[nodiscard]] std::size_t length() const { return type == Hdf5Type::text ? 1 : bytes.size() / width(); }
};
using StoredFile = std::map<std::string, StoredDataset>;

/// What stands in for the one HDF5 file there is: Hdf5Writer empties and fills it, Hdf5Reader reads it, whatever file
/// they are given. A program that links this has dmp's readers of contents without HDF5's of files.
StoredFile& stored_file();

}  // namespace dmp::tests
