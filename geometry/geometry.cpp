// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/geometry.hpp"

#include <algorithm>
#include <set>

namespace dmp::geometry {

namespace {

template <class Named>
const Named* find_named(const std::vector<Named>& all, const std::string& name) {
    const auto found = std::ranges::find(all, name, &Named::name);
    return found == all.end() ? nullptr : &*found;
}

}  // namespace

const Region* Geometry::region(const std::string& name) const { return find_named(regions, name); }

const CurveSet* Geometry::curve_set(const std::string& name) const { return find_named(curves, name); }

const Solid* Geometry::solid(const std::string& name) const { return find_named(solids, name); }

const SurfaceSet* Geometry::surface_set(const std::string& name) const { return find_named(surfaces, name); }

double Solid::volume() const { return surface.enclosed_volume(); }

std::vector<std::string> Geometry::names() const {
    std::set<std::string> all;
    for (const auto& region : regions) all.insert(region.name);
    for (const auto& set : curves) all.insert(set.name);
    for (const auto& solid : solids) all.insert(solid.name);
    for (const auto& set : surfaces) all.insert(set.name);
    for (const auto& [name, positions] : points) all.insert(name);
    return {all.begin(), all.end()};
}

}  // namespace dmp::geometry
