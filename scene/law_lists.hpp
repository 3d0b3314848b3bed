// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/enum_names.hpp"

namespace dmp::scene {

/// The laws of a registry that have a property, as advice lists them: `"morris", "monaghan" or "cleary"`.
/// @tparam Law a models::Choice
/// @param property has template operator()<L>() for each law L of the registry and returns whether L has it
template <class Law, class Property>
std::string laws_with(const Property& property) {
    std::vector<std::string> names;
    for (std::size_t number = 0; number < Law::Registry::size; ++number)
        if (const Law law(number); law.visit(property)) names.push_back('"' + to_string(law) + '"');
    std::string text;
    for (std::size_t k = 0; k < names.size(); ++k)
        text += (k == 0 ? "" : k + 1 == names.size() ? " or " : ", ") + names[k];
    return text;
}

/// The adhesive ones of a registry of contact laws.
template <class Law>
std::string adhesive_laws() {
    return laws_with<Law>([]<class L>() { return L::adhesive; });
}

}  // namespace dmp::scene
