// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace dmp {

/// What follows a switch over all values of an enumeration that returns from each: reached only by a number that is
/// none of them. Such a switch has no `default:`, so that one without a new value does not compile (-Wswitch).
/// Throws std::logic_error.
template <class Enumeration>
[[noreturn]] void unlisted_value(Enumeration value) {
    throw std::logic_error("an enumeration has no value " + std::to_string(static_cast<long>(value)));
}

}  // namespace dmp
