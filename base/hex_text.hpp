// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace dmp {

/// The last `digits` hexadecimal digits of a number, with zeros in front.
[[nodiscard]] inline std::string hex_text(std::uint64_t number, std::size_t digits = 16) {
    std::string text(digits, '0');
    for (auto digit = text.rbegin(); digit != text.rend(); ++digit, number /= 16)
        *digit = "0123456789abcdef"[number % 16];
    return text;
}

}  // namespace dmp
