// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/measure_columns.hpp"

#include <algorithm>

#include "base/unlisted_value.hpp"

namespace dmp::study {

MeasureColumns columns_of(MeasureKind kind) {
    using enum MeasureColumns::Count;
    switch (kind) {
        case MeasureKind::flux:
            return {one, "m^3/s"};
        case MeasureKind::gap:
            return {one, "m"};
        case MeasureKind::largest_speed:
            return {one, "m/s"};
        case MeasureKind::kinetic_energy:
            return {one, "J"};
        case MeasureKind::density:
            return {several, "1"};
        case MeasureKind::displacement:
            return {several, "m"};
        case MeasureKind::velocity:
            return {several, "m/s"};
        case MeasureKind::spin:
            return {several, "rad/s"};
        case MeasureKind::wall_force:
            return {several, "N"};
        case MeasureKind::amount:
        case MeasureKind::mean_concentration:
            return {one, ""};
        case MeasureKind::peclet:
            return {one, "1"};
        case MeasureKind::body:
        case MeasureKind::field:
        case MeasureKind::solid_field:
        case MeasureKind::line:
        case MeasureKind::mode:
        case MeasureKind::profile:
        case MeasureKind::aggregate:
        case MeasureKind::contact:
            return {several, ""};
        case MeasureKind::detached:
            return {depends, "1"};
        case MeasureKind::probe:
        case MeasureKind::spread:
        case MeasureKind::wall_flux:
        case MeasureKind::uptake:
            return {depends, ""};
    }
    unlisted_value(kind);
}

bool is_column_of(const Scene& scene, const std::string& measure, const std::string& column) {
    const auto begins = [&](const std::string& name) { return column == name || column.starts_with(name + "_"); };
    return begins(measure) && std::ranges::none_of(scene.measures, [&](const Measure& other) {
               return other.name->size() > measure.size() && begins(*other.name);
           });
}

std::string vector_of(const std::string& column) {
    const bool is_component = column.ends_with("_x") || column.ends_with("_y") || column.ends_with("_z");
    return is_component ? column.substr(0, column.size() - 1) : column;
}

bool counts_particles(const Scene& scene, const std::string& column) {
    return std::ranges::any_of(scene.measures, [&](const Measure& measure) {
        if (*measure.kind != MeasureKind::aggregate || !is_column_of(scene, *measure.name, column)) return false;
        const std::string ending = column.substr(measure.name->size());
        return ending != "_mass" && ending != "_pieces";
    });
}

}  // namespace dmp::study
