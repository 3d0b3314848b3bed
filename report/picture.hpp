// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace dmp::report {

/// A PNG file.
struct Picture {
    std::string name, bytes;
    unsigned width = 0, height = 0;  ///< [pixels]
};

/// None where it is no whole PNG file. Throws InputError where it cannot be read.
[[nodiscard]] std::optional<Picture> read_picture(const std::filesystem::path& file);

/// <img> with the picture in it.
[[nodiscard]] std::string image_element(const Picture& picture, const std::string& alternative_text);

}  // namespace dmp::report
