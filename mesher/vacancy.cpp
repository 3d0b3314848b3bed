// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/vacancy.hpp"

#include <algorithm>

namespace dmp::mesher {

Vacancy::Vacancy(const Geometry& geometry, const Scene& scene) {
    for (const Part* fluid : scene.parts_of(PartKind::fluid))
        fluids_.emplace_back(geometry.solid(fluid->name)->surface);
    for (const PartKind kind : {PartKind::rigid, PartKind::elastic})
        for (const Part* part : scene.parts_of(kind))
            if (const Solid* solid = geometry.solid(part->name)) bodies_.emplace_back(solid->surface);
}

int Vacancy::fluid_at(const Vec& point) const {
    const auto holds = [&](const WindingNumber& winding) { return winding.inside(point); };
    if (std::ranges::any_of(bodies_, holds)) return -1;
    const auto found = std::ranges::find_if(fluids_, holds);
    return found == fluids_.end() ? -1 : static_cast<int>(found - fluids_.begin());
}

}  // namespace dmp::mesher
