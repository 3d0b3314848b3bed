// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/repair_solids.hpp"

#include <algorithm>
#include <utility>

namespace dmp::geometry {

std::vector<std::string> repair_solids(Geometry& geometry, const std::vector<std::string>& names,
                                       const RepairLimits& limits) {
    std::vector<std::string> said;
    for (const std::string& name : names) {
        if (geometry.solid(name) != nullptr) continue;
        const auto set = std::ranges::find(geometry.surfaces, name, &SurfaceSet::name);
        if (set == geometry.surfaces.end()) continue;
        RepairedSurface repaired = repair_surface(set->surface, limits, "solid '" + name + "'", {geometry.file, 0, 0});
        for (const std::string& line : repaired.report.lines()) said.push_back(name + ": " + line);
        geometry.solids.push_back({name, std::move(repaired.surface)});
        geometry.surfaces.erase(set);
    }
    return said;
}

}  // namespace dmp::geometry
