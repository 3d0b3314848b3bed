// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace dmp::postproc {

/// An animated PNG (https://www.w3.org/TR/png-3/, 11.3.6): the images, which are PNG files of one size and kind, one
/// after the other, each for `milliseconds`, over and over. Programs that do not know it show the first one. Throws
/// std::invalid_argument if there are none, or one is no PNG or unlike the first.
[[nodiscard]] std::string animated_png(const std::vector<std::string>& images, int milliseconds);

}  // namespace dmp::postproc
