// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <span>

#include "base/vec.hpp"

namespace dmp::postproc {

/// Writes triangles to a VTP text file for ParaView, for example those that cause an error. Corners in metres; each
/// triangle has its number as the cell value "triangle". Throws ResourceError if the file cannot be written.
void write_triangles(const std::filesystem::path& file, std::span<const Vec> corners,
                     std::span<const std::array<int, 3>> triangles);

}  // namespace dmp::postproc
