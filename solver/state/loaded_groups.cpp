// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/state/loaded_groups.hpp"

#include <algorithm>
#include <cmath>

#include "base/number_text.hpp"

namespace dmp::solver {

InputError unlike_any_run(const std::string& problem) {
    return {"the checkpoint holds what no run of dmp writes: " + problem, "Start the run anew in another folder."};
}

std::int64_t loaded_whole(double value, std::int64_t low, std::int64_t end, const std::string& what) {
    // Doubles hold whole numbers up to 2^53, and what is no number compares as false.
    if (!(value >= static_cast<double>(low) && value < static_cast<double>(end) && value == std::floor(value)))
        throw unlike_any_run(number_text(value) + " as " + what);
    return static_cast<std::int64_t>(value);
}

void check_finite(std::span<const double> values, const std::string& what) {
    if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
        throw unlike_any_run(what + " that is not finite");
}

namespace {

void check_field(Field field, std::span<const double> values) {
    constexpr double beyond_all_runs = 1e30;  // its powers of the laws are finite
    const bool is_an_amount = field == Field::mass || field == Field::volume || field == Field::density;
    for (const double value : values) {
        if (!std::isfinite(value)) throw unlike_any_run("a " + std::string(info(field).name) + " that is not finite");
        if (std::abs(value) > beyond_all_runs || (is_an_amount && value < 0) ||
            (field == Field::radius && !(value > 0)))
            throw unlike_any_run("a " + std::string(info(field).name) + " of " + number_text(value) + " " +
                                 std::string(info(field).unit));
    }
}

}  // namespace

void check_loaded(std::span<const ParticleGroup> groups, std::int64_t ids, std::size_t parts) {
    for (const ParticleGroup& group : groups) {
        for (std::size_t i = 0; i < group.owned(); ++i) {
            const ParticleTag& tag = group.tags()[i];
            if (tag.id < 0 || tag.id >= ids)
                throw unlike_any_run("particle " + std::to_string(tag.id) + ", which the run does not have");
            if (tag.part >= parts)
                throw unlike_any_run("a particle of part " + std::to_string(tag.part) +
                                     ", which the scene does not have");
        }
        for (const Field field : group.state())
            for (int axis = 0; axis < group.axes(field); ++axis)
                check_field(field, {group.data(field, axis), group.owned()});
    }
}

}  // namespace dmp::solver
