// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

#include "base/unlisted_value.hpp"
#include "scene/choices.hpp"

namespace dmp::scene {

/// What a measure is of: which scenes may have it, and which part of the solver takes it. `any`: whatever moves in the
/// scene; `solids`: elastic ones, or what turned solid.
enum class MeasureSubject { any, flow, solids, species, spheres };

constexpr MeasureSubject subject_of(MeasureKind kind) {
    switch (kind) {
        case MeasureKind::largest_speed:
        case MeasureKind::kinetic_energy:
            return MeasureSubject::any;
        case MeasureKind::flux:
        case MeasureKind::density:
        case MeasureKind::probe:
        case MeasureKind::line:
        case MeasureKind::mode:
        case MeasureKind::field:
            return MeasureSubject::flow;
        case MeasureKind::gap:
        case MeasureKind::aggregate:
        case MeasureKind::displacement:
        case MeasureKind::body:
        case MeasureKind::solid_field:
        case MeasureKind::contact:
            return MeasureSubject::solids;
        case MeasureKind::amount:
        case MeasureKind::mean_concentration:
        case MeasureKind::profile:
        case MeasureKind::spread:
        case MeasureKind::wall_flux:
        case MeasureKind::peclet:
        case MeasureKind::uptake:
            return MeasureSubject::species;
        case MeasureKind::velocity:
        case MeasureKind::spin:
        case MeasureKind::wall_force:
        case MeasureKind::detached:
            return MeasureSubject::spheres;
    }
    unlisted_value(kind);
}

/// Whether a measure reads a field of the fluid.
constexpr bool reads_a_field(MeasureKind kind) {
    return kind == MeasureKind::probe || kind == MeasureKind::line || kind == MeasureKind::mode ||
           kind == MeasureKind::field;
}

/// Whether a measure is of an elastic part alone.
constexpr bool is_of_elastic_part(MeasureKind kind) {
    return kind == MeasureKind::gap || kind == MeasureKind::displacement || kind == MeasureKind::body ||
           kind == MeasureKind::solid_field || kind == MeasureKind::contact;
}

/// Whether a measure is of a species. A probe of concentrations is of the fluid.
constexpr bool is_of_species(MeasureKind kind) { return subject_of(kind) == MeasureSubject::species; }

/// Names of the kinds of measures of a subject, in the order of their values.
inline std::vector<std::string> measures_of(MeasureSubject subject) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < enum_names<MeasureKind>.size(); ++k)
        if (const auto kind = static_cast<MeasureKind>(k); subject_of(kind) == subject)
            names.push_back(to_string(kind));
    return names;
}

/// Whether `rows`, each with a member `kind`, are one for each kind of measure of these subjects, and no more.
template <class Rows>
constexpr bool has_row_for_each(const Rows& rows, std::initializer_list<MeasureSubject> subjects) {
    for (std::size_t k = 0; k < enum_names<MeasureKind>.size(); ++k) {
        const auto kind = static_cast<MeasureKind>(k);
        const bool wanted = std::ranges::find(subjects, subject_of(kind)) != subjects.end();
        if (std::ranges::count_if(rows, [&](const auto& row) { return row.kind == kind; }) != (wanted ? 1 : 0))
            return false;
    }
    return true;
}

}  // namespace dmp::scene
