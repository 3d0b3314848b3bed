// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <span>

#include "base/vec.hpp"

namespace dmp::postproc {

/// A VTP file of triangles for ParaView, as text: those of a picture that are to blame for something, say. Corners in
/// metres; each triangle has its number as the cell value "triangle". Throws ResourceError when the disk does not take
/// it.
void write_triangles(const std::filesystem::path& file, std::span<const Vec> corners,
                     std::span<const std::array<int, 3>> triangles);

}  // namespace dmp::postproc
