// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "models/dem/contact_law.hpp"

namespace dmp::solver {

/// All laws that are compiled, by number.
inline constexpr std::size_t contact_models = std::size_t{2} * 3 * 3;

constexpr ContactModel contact_model(std::size_t number) {
    return {static_cast<TangentialHistory>(number % 2), static_cast<RollingFriction>(number / 2 % 3),
            static_cast<Adhesion>(number / 6)};
}

constexpr std::size_t number_of(const ContactModel& model) {
    return static_cast<std::size_t>(model.history) + 2 * static_cast<std::size_t>(model.rolling) +
           6 * static_cast<std::size_t>(model.adhesion);
}

}  // namespace dmp::solver
