// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/uses.hpp"
#include "postproc/pictures.hpp"
#include "scene/scene.hpp"

namespace dmp::cli {

/// What the scene says of its pictures.
[[nodiscard]] PictureOptions picture_options(const Scene& scene);

}  // namespace dmp::cli
