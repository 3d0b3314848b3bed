// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/column_pressure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>

namespace dmp::solver {

namespace {

struct Range {
    double low, high;
    [[nodiscard]] double extent() const { return high - low; }
    [[nodiscard]] double largest() const { return std::max(-low, high); }
};

/// Values of a function of time in the run, and 0; only 0 if it depends on position, too.
Range values_of(const Expression& formula, double duration) {
    Range range{0, 0};
    if (formula.depends_on_position()) return range;
    for (int k = 0; k <= 64; ++k) {
        const double value = formula(duration * k / 64);
        range = {std::min(range.low, value), std::max(range.high, value)};
    }
    return range;
}

Range extent_of_fluid(const ParticleSet& set, int axis) {
    Range extent{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::fluid) continue;
        const double x = set.position[i][axis];
        extent = {std::min(extent.low, x - set.spacing / 2), std::max(extent.high, x + set.spacing / 2)};
    }
    return extent;
}

/// The fluid in layers of one spacing along an axis.
class Layers {
  public:
    /// `density` by part.
    Layers(const ParticleSet& set, const std::vector<double>& density, int axis) {
        const Range extent = extent_of_fluid(set, axis);
        const auto layers = static_cast<std::size_t>(std::max(1.0, std::round(extent.extent() / set.spacing)));
        thickness_ = extent.extent() / static_cast<double>(layers);
        density_.assign(layers, 0.0);
        holds_.assign(set.parts.size(), std::vector<bool>(layers, false));
        for (std::size_t i = 0; i < set.size(); ++i) {
            if (set.kind(i) != PartKind::fluid) continue;
            const auto part = static_cast<std::size_t>(set.part[i]);
            const std::size_t layer =
                std::min(layers - 1, static_cast<std::size_t>((set.position[i][axis] - extent.low) / thickness_));
            density_[layer] = std::max(density_[layer], density[part]);
            holds_[part][layer] = true;
        }
    }

    /// The largest pressure of each part's fluid under an acceleration along the axis, of either sign [m/s^2].
    [[nodiscard]] std::vector<double> pressures(double acceleration) const {
        std::vector<double> largest(holds_.size(), 0.0);
        double pressure = 0;
        for (std::size_t k = 0; k < density_.size(); ++k) {
            const std::size_t layer = acceleration > 0 ? k : density_.size() - 1 - k;
            pressure += density_[layer] * std::abs(acceleration) * thickness_;
            for (std::size_t part = 0; part < largest.size(); ++part)
                if (holds_[part][layer]) largest[part] = pressure;
        }
        return largest;
    }

  private:
    double thickness_ = 0;
    std::vector<double> density_;           ///< by layer, of its densest fluid
    std::vector<std::vector<bool>> holds_;  ///< by part and layer: the layer has some of it
};

/// Whether some solid does not run straight along the axis from one end of the period to the other: cells of two
/// spacings that have some of it do not form whole rows.
bool blocks_the_flow(const ParticleSet& set, int axis) {
    const double cell = 2 * set.spacing;
    std::optional<Vec> first;  // a quarter of a cell from an edge, so that rows of a lattice do not lie on edges
    std::map<std::array<std::int64_t, 2>, std::vector<bool>> rows;
    const double low = set.box.low[axis];
    const auto length = static_cast<std::size_t>(std::max(1.0, std::floor((set.box.high[axis] - low) / cell)));
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) == PartKind::fluid) continue;
        if (set.kind(i) == PartKind::elastic) return true;
        const auto& x = set.position[i];
        if (!first) first = x;
        const auto cell_of = [&](int across) {
            return static_cast<std::int64_t>(std::floor((x[across] - (*first)[across]) / cell + 0.25));
        };
        const std::array<std::int64_t, 2> row{cell_of((axis + 1) % 3), cell_of((axis + 2) % 3)};
        auto& cells = rows.try_emplace(row, length, false).first->second;
        const double along = (x[axis] - low) / (set.box.high[axis] - low) * static_cast<double>(length);
        cells[static_cast<std::size_t>(std::clamp(along, 0.0, static_cast<double>(length - 1)))] = true;
    }
    return std::ranges::any_of(rows, [](const auto& row) { return !std::ranges::all_of(row.second, std::identity{}); });
}

}  // namespace

std::vector<double> column_pressures(const Scene& scene, const ParticleSet& set) {
    std::vector<double> density(set.parts.size(), 0.0), pressures(set.parts.size(), 0.0);
    double densest = 0;
    for (std::size_t part = 0; part < set.parts.size(); ++part) {
        if (set.parts[part].kind != PartKind::fluid) continue;
        density[part] = scene.part_of_particles(set.parts[part].name).density;
        densest = std::max(densest, density[part]);
    }
    if (densest == 0) return pressures;
    for (int axis = 0; axis < set.dimension; ++axis) {
        const Range acceleration = values_of(scene.flow.acceleration[axis], scene.run.duration);
        const Range gradient = values_of((*scene.flow.pressure_gradient)[axis], scene.run.duration);
        if (acceleration.largest() == 0 && gradient.largest() == 0) continue;
        if (set.periodic[axis]) {
            if (!blocks_the_flow(set, axis)) continue;
            const double held =
                (densest * acceleration.largest() + gradient.largest()) * (set.box.high[axis] - set.box.low[axis]);
            for (std::size_t part = 0; part < pressures.size(); ++part)
                if (density[part] > 0) pressures[part] += held;
            continue;
        }
        const Layers layers(set, density, axis);
        const std::vector<double> up = layers.pressures(acceleration.high), down = layers.pressures(acceleration.low);
        for (std::size_t part = 0; part < pressures.size(); ++part) pressures[part] += std::max(up[part], down[part]);
    }
    return pressures;
}

}  // namespace dmp::solver
