// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/state/watch.hpp"

#include <cmath>
#include <limits>
#include <sstream>

namespace dmp {

namespace {

constexpr double lowest_density = 0.5, highest_density = 1.5;

double speed_of(const ParticleGroup& group, std::size_t i) {
    double square = 0;
    for (int axis = 0; axis < group.dimension(); ++axis) {
        const double v = group.data(Field::velocity, axis)[i];
        square += v * v;
    }
    return std::sqrt(square);
}

}  // namespace

std::optional<Watch::Finding> Watch::look(const ParticleStore& particles, const FluidExtremes& extremes) const {
    const bool fluid_is_well = extremes.largest_speed < sound_speed_ && extremes.density_low > lowest_density &&
                               extremes.density_high < highest_density;
    if (!fluid_is_well) return worst_of_fluid(particles.fluid());
    for (const ParticleKind kind : {ParticleKind::fluid, ParticleKind::springs}) {
        const ParticleGroup& group = particles.of(kind);
        for (std::size_t i = 0; i < group.owned(); ++i) {
            if (!std::isfinite(speed_of(group, i))) return describe(group, i, "is not finite");
            if (outside_box(group, i)) return describe(group, i, "has left the domain");
        }
    }
    return std::nullopt;
}

std::optional<Watch::Finding> Watch::worst_of_fluid(const ParticleGroup& fluid) const {
    std::size_t worst = 0;
    double worst_speed = -1;
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        const double speed = speed_of(fluid, i), density = fluid.data(Field::density)[i];
        if (!std::isfinite(speed) || !std::isfinite(density)) return describe(fluid, i, "is not finite");
        const double relative = density / rest_density_[fluid.tags()[i].part];
        if (relative <= lowest_density || relative >= highest_density)
            return describe(fluid, i, "has a density outside 0.5 to 1.5 times the rest density");
        if (speed > worst_speed) {
            worst = i;
            worst_speed = speed;
        }
    }
    if (!(worst_speed >= sound_speed_)) return std::nullopt;  // another rank has it
    return describe(fluid, worst, "is faster than sound");
}

Watch::Finding Watch::describe(const ParticleGroup& group, std::size_t i, const std::string& limit) const {
    const ParticleTag& tag = group.tags()[i];
    std::ostringstream text;
    text << "particle " << tag.id << " of '" << space_.parts[tag.part].name << "' at (";
    for (int axis = 0; axis < group.dimension(); ++axis)
        text << (axis > 0 ? ", " : "") << group.data(Field::position, axis)[i] << " m";
    text << ") " << limit << ": speed " << speed_of(group, i) << " m/s, sound speed " << sound_speed_ << " m/s";
    if (group.has(Field::density)) text << ", density " << group.data(Field::density)[i] << " kg/m^3";
    return {text.str(), likely_causes(group, outside_box(group, i)) + "\nThe last frame shows the state"};
}

/// Those that this scene can have, the likeliest first.
std::string Watch::likely_causes(const ParticleGroup& group, bool left) const {
    std::vector<std::string> causes;
    const auto& accuracy = scene_.accuracy;
    const auto with = [](const std::string& key, double value) {
        std::ostringstream text;
        text << key << " = " << value;
        return text.str();
    };
    const bool subcycled =
        !scene_.parts_of(PartKind::springs).empty() && accuracy.spring_stepping.value == SpringStepping::subcycled;
    const std::string springs = with("accuracy.spring_step_factor", accuracy.spring_step_factor) +
                                " leaves the springs too large a step for how far they are strained";
    if (subcycled && group.kind() == ParticleKind::springs) causes.push_back(springs);
    if (left) causes.emplace_back("a wall there has a hole or is too thin");
    const double usual = decltype(Scene::accuracy)().step_factor;
    if (accuracy.step_factor > usual)
        causes.push_back(with("accuracy.step_factor", accuracy.step_factor) + " is too large; " +
                         with("the default", usual) + " is tried");
    causes.push_back(accuracy.sound_speed > 0
                         ? with("accuracy.sound_speed", accuracy.sound_speed) +
                               " m/s is not ten times the speed that the drive produces"
                         : with("flow.largest_speed", scene_.flow.largest_speed) +
                               " m/s is below what the drive produces (the sound speed follows it)");
    if (subcycled && group.kind() != ParticleKind::springs) causes.push_back(springs);
    std::string text = causes.size() > 1 ? "likely causes: " : "likely cause: ";
    for (std::size_t k = 0; k < causes.size(); ++k) text += (k > 0 ? "; or " : "") + causes[k];
    return text;
}

bool Watch::outside_box(const ParticleGroup& group, std::size_t i) const {
    for (int axis = 0; axis < group.dimension(); ++axis) {
        if (space_.periodic[axis]) continue;
        const double x = group.data(Field::position, axis)[i];
        if (x < space_.box.low[axis] - support_ || x > space_.box.high[axis] + support_) return true;
    }
    return false;
}

std::size_t Watch::lost(const ParticleStore& particles, const ClusterList& list) const {
    std::size_t count = 0;
    const ParticleGroup& fluid = particles.fluid();
    const ParticleGroup& walls = particles.of(ParticleKind::rigid);
    const auto clusters = list.clusters(ParticleKind::fluid);
    for (std::size_t c = 0; c < clusters.size(); ++c)
        for (std::int32_t i = clusters[c].first; i < clusters[c].first + clusters[c].count; ++i) {
            double nearest = std::numeric_limits<double>::infinity(), in_front = 0;
            for (const std::int32_t j : list.neighbours(ParticleKind::fluid, c, ParticleKind::rigid)) {
                double square = 0, along_normal = 0;
                for (int axis = 0; axis < particles.dimension(); ++axis) {
                    const double d = fluid.data(Field::position, axis)[i] - walls.data(Field::position, axis)[j];
                    square += d * d;
                    along_normal += d * walls.data(Field::wall_normal, axis)[j];
                }
                if (square >= nearest) continue;
                nearest = square;
                in_front = along_normal - walls.data(Field::wall_distance)[j];
            }
            if (in_front < -space_.spacing || outside_box(fluid, static_cast<std::size_t>(i))) ++count;
        }
    return count;
}

}  // namespace dmp
