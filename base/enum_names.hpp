// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

namespace dmp {

/// The names of an enumeration's values, as scenes and messages use them, by number. An enumeration whose values count
/// from 0 gets its names by a specialisation beside it:
///   template <> inline constexpr auto enum_names<Axis> = std::to_array<std::string_view>({"x", "y", "z"});
/// That each value has a name is checked when to_string or all_names is compiled.
template <class E>
inline constexpr std::array<std::string_view, 0> enum_names{};

namespace detail {

/// Whether the number is one of the enumeration's values: else the compiler writes it as a cast, "(E)7".
template <auto value>
constexpr bool is_enumerator() {
    const std::string_view text = __PRETTY_FUNCTION__;
    return text[text.find("value = ") + 8] != '(';
}

template <class E>
concept NamedEnum = enum_names<E>
.size() > 0;

template <NamedEnum E>
constexpr void check_names() {
    constexpr std::size_t count = enum_names<E>.size();
    static_assert(is_enumerator<static_cast<E>(count - 1)>(), "a name without a value");
    static_assert(!is_enumerator<static_cast<E>(count)>(), "a value without a name");
}

}  // namespace detail

template <detail::NamedEnum E>
constexpr std::string_view name_of(E value) {
    detail::check_names<E>();
    return enum_names<E>.at(static_cast<std::size_t>(value));
}

template <detail::NamedEnum E>
std::string to_string(E value) {
    return std::string(name_of(value));
}

}  // namespace dmp
