// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/picture.hpp"

#include <string_view>

#include <fmt/format.h>

#include "base/safe_file.hpp"
#include "report/html.hpp"

namespace dmp::report {

namespace {

unsigned big_endian(std::string_view bytes) {
    unsigned value = 0;
    for (const char c : bytes.substr(0, 4)) value = value << 8 | static_cast<unsigned char>(c);
    return value;
}

}  // namespace

std::optional<Picture> read_picture(const std::filesystem::path& file) {
    constexpr std::string_view begin("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    Picture found{file.filename().string(), read_file(file)};
    const std::string_view bytes = found.bytes;
    if (bytes.size() < 33 || !bytes.starts_with(begin) || bytes.find("IEND") == std::string_view::npos) return {};
    found.width = big_endian(bytes.substr(16));
    found.height = big_endian(bytes.substr(20));
    return found;
}

std::string image_element(const Picture& picture, const std::string& alternative_text) {
    return fmt::format("<img src=\"data:image/png;base64,{}\" width=\"{}\" height=\"{}\" alt=\"{}\">",
                       base64(picture.bytes), picture.width, picture.height, escaped(alternative_text));
}

}  // namespace dmp::report
