// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/state/watch.hpp"

#include <cmath>
#include <limits>
#include <sstream>

namespace dmp {

namespace {

constexpr double lowest_density = 0.5, highest_density = 1.5;

double speed_of(const ParticleStore& particles, int i) {
    double square = 0;
    for (int axis = 0; axis < particles.dimension(); ++axis) {
        const double v = particles.data(Field::velocity, axis)[i];
        square += v * v;
    }
    return std::sqrt(square);
}

}  // namespace

std::optional<Watch::Finding> Watch::look(const ParticleStore& particles, const FluidExtremes& extremes) const {
    const bool fluid_is_well = extremes.largest_speed < sound_speed_ && extremes.density_low > lowest_density &&
                               extremes.density_high < highest_density;
    if (!fluid_is_well) {
        const double* density = particles.data(Field::density);
        const double* mass = particles.data(Field::mass);
        int worst = -1;
        double worst_speed = -1;
        for (const int i : particles.ids(ParticleKind::fluid)) {
            const double speed = speed_of(particles, i);
            if (!std::isfinite(speed) || !std::isfinite(density[i])) return describe(particles, i, "is not finite");
            const double relative = density[i] * set_.volume[i] / mass[i];
            if (relative <= lowest_density || relative >= highest_density)
                return describe(particles, i, "has a density outside 0.5 to 1.5 times the rest density");
            if (speed > worst_speed) {
                worst = i;
                worst_speed = speed;
            }
        }
        return describe(particles, worst, "is faster than sound");
    }
    for (const ParticleKind kind : {ParticleKind::fluid, ParticleKind::springs})
        for (const int i : particles.ids(kind)) {
            if (!std::isfinite(speed_of(particles, i))) return describe(particles, i, "is not finite");
            if (outside_box(particles, i)) return describe(particles, i, "has left the domain");
        }
    return std::nullopt;
}

Watch::Finding Watch::describe(const ParticleStore& particles, int i, const std::string& limit) const {
    std::ostringstream text;
    text << "particle " << i << " of '" << set_.parts[set_.part[i]].name << "' at (";
    for (int axis = 0; axis < particles.dimension(); ++axis)
        text << (axis > 0 ? ", " : "") << particles.data(Field::position, axis)[i] << " m";
    text << ") " << limit << ": speed " << speed_of(particles, i) << " m/s, sound speed " << sound_speed_
         << " m/s, density " << particles.data(Field::density)[i] << " kg/m^3";
    return {text.str(),
            "likely causes: flow.largest_speed is below what the drive produces (the sound speed follows it), "
            "accuracy.step_factor is too large, or a spring part is stiffer than accuracy.spring_step_factor allows. "
            "The last frame shows the state"};
}

bool Watch::outside_box(const ParticleStore& particles, int i) const {
    for (int axis = 0; axis < particles.dimension(); ++axis) {
        if (set_.periodic[axis]) continue;
        const double x = particles.data(Field::position, axis)[i];
        if (x < set_.box.low[axis] - support_ || x > set_.box.high[axis] + support_) return true;
    }
    return false;
}

std::size_t Watch::lost(const ParticleStore& particles, const ClusterList& list) const {
    std::size_t count = 0;
    for (const Cluster& cluster : list.clusters(ParticleKind::fluid))
        for (std::size_t k = 0; k < cluster.count; ++k) {
            const int i = cluster.member[k];
            double nearest = std::numeric_limits<double>::infinity(), in_front = 0;
            for (const int j : list.neighbours(cluster, ParticleKind::rigid)) {
                const int wall = particles.source(j);
                double square = 0, along_normal = 0;
                for (int axis = 0; axis < particles.dimension(); ++axis) {
                    const double d =
                        particles.data(Field::position, axis)[i] - particles.data(Field::position, axis)[j];
                    square += d * d;
                    along_normal += d * set_.wall_normal[wall][axis];
                }
                if (square >= nearest) continue;
                nearest = square;
                in_front = along_normal - set_.wall_distance[wall];
            }
            if (in_front < -set_.spacing || outside_box(particles, i)) ++count;
        }
    return count;
}

}  // namespace dmp
