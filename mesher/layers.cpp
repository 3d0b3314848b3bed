// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/layers.hpp"

#include <algorithm>
#include <limits>

namespace dmp::mesher {

namespace {

constexpr double stride = 0.25;  // of the walker [spacings]
/// Where it starts: a surface that cuts a lattice has particles of both sides within less than this.
constexpr double start = 1;
constexpr double search_radius = 3;
constexpr std::size_t most_positions = 100'000;
constexpr int none = -1;

}  // namespace

/// The part of the nearest particle within the radius [spacings], of those parts that `counts` lets through.
template <class Counts>
int LayerCount::nearest_part(const Vec& point, double radius, const Counts& counts) const {
    double nearest = std::numeric_limits<double>::infinity();
    int part = none;
    search_.for_each_near(point, radius * set_.spacing, [&](std::size_t j, double square, const Vec&) {
        if (square >= nearest || !counts(set_.part[j])) return;
        nearest = square;
        part = set_.part[j];
    });
    return part;
}

double LayerCount::asked_of(int part) const {
    const auto& info = set_.parts[static_cast<std::size_t>(part)];
    if (info.kind != PartKind::rigid) return layers_of_fluid;
    return scene_.part_of_particles(info.name).layers;
}

/// The part on the other side of a fluid's surface, at the walk's start; where nothing stands there, the nearest one.
int LayerCount::behind(const Vec& point, int fluid) const {
    const auto is_other = [fluid](int part) { return part != fluid; };
    const int near = nearest_part(point, 1, is_other);
    return near != none ? near : nearest_part(point, search_radius, is_other);
}

bool LayerCount::is_near_a_body(const Vec& point) const {
    const auto is_body = [&](int part) { return set_.parts[static_cast<std::size_t>(part)].kind == PartKind::elastic; };
    return nearest_part(point, 2, is_body) != none;
}

void LayerCount::walk(const Vec& from, const Vec& direction, int part) {
    // The largest holes of a lattice are sqrt(1/2) and sqrt(3)/2 spacings from its points.
    const double widest = set_.dimension == 3 ? 0.87 : 0.72;
    const auto [at, is_new] = walks_.try_emplace(part);
    Walks& walks = at->second;
    if (is_new) {
        walks.asked = walks.fewest = asked_of(part);
        walks.where = from;
    }
    double layers = 0;
    for (double far = start; far < walks.asked + 0.5 * stride; far += stride) {
        const Vec here = from + far * set_.spacing * direction;
        if (nearest_part(here, widest, [](int) { return true; }) != part) break;
        layers = far;
    }
    if (layers < walks.fewest) {
        walks.fewest = layers;
        walks.where = from;
    }
    walks.sum += layers;
    ++walks.count;
}

void LayerCount::add(const CadSurface& surface, int fluid) {
    const auto& samples = surface.samples();
    const std::size_t step = samples.size() / most_positions + 1;
    for (std::size_t k = 0; k < samples.size(); k += step) {
        const CadSurface::Sample& sample = samples[k];
        if (is_near_a_body(sample.point)) continue;
        walk(sample.point, -sample.normal, fluid);
        const int part = behind(sample.point + start * set_.spacing * sample.normal, fluid);
        if (part != none && set_.parts[static_cast<std::size_t>(part)].kind == PartKind::rigid)
            walk(sample.point, sample.normal, part);
    }
}

std::vector<MeshReport::LayerLine> LayerCount::lines() const {
    std::vector<MeshReport::LayerLine> lines;
    for (const auto& [part, walks] : walks_)
        lines.push_back({set_.parts[static_cast<std::size_t>(part)].name, walks.asked, walks.fewest,
                         walks.sum / static_cast<double>(walks.count), walks.where});
    return lines;
}

}  // namespace dmp::mesher
