// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/monitor/void_monitor.hpp"

#include <algorithm>
#include <vector>

#include "base/number_text.hpp"
#include "models/sph/void_closing.hpp"
#include "solver/output/fluid_fields.hpp"

namespace dmp::solver {

std::optional<Warning> VoidMonitor::look(const ParticleStore& particles, const Ranks& ranks, double t, bool is_known) {
    if (!settings_.watches || particle_ >= 0) return {};
    struct Largest {
        double correction;
        std::int64_t particle, part;
        std::array<double, 3> place;
    };
    const ParticleGroup& fluid = particles.fluid();
    std::int64_t beside_void = 0;
    std::vector<Largest> largest;  // of this rank: one, or none
    const auto is_before = [](const Largest& a, const Largest& b) {
        return a.correction != b.correction ? a.correction > b.correction : a.particle < b.particle;
    };
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        const double correction = fluid.data(Field::mean_correction)[i];
        const bool is_beside = VoidClosing::is_beside_void(correction);
        beside_void += is_beside ? 1 : 0;
        if (!is_beside && !is_known) continue;
        const ParticleTag& tag = fluid.tags()[i];
        const Vec place = shown_place(fluid, particles.space(), i);
        const Largest here{correction, tag.id, tag.part, {place[0], place[1], place[2]}};
        if (largest.empty())
            largest.push_back(here);
        else if (is_before(here, largest.front()))
            largest.front() = here;
    }
    if (!is_known && ranks.sum(beside_void) < VoidClosing::fewest_particles) return {};
    largest = ranks.all_gather<Largest>(largest);
    if (largest.empty()) return {};
    const Largest& found = *std::ranges::min_element(largest, is_before);
    particle_ = found.particle;
    part_ = particles.space().parts[static_cast<std::size_t>(found.part)].name;
    time_ = t;
    place_ = found.place;
    return warning();
}

std::string VoidMonitor::text() const {
    if (particle_ < 0) return "";
    std::string place;
    for (int axis = 0; axis < scene_.dimension; ++axis)
        place += (axis > 0 ? ", " : "") + number_text(place_[axis], 4) + " m";
    return "a void opened in the fluid by " + number_text(time_, 4) + " s, at particle " + std::to_string(particle_) +
           " of '" + part_ + "' at (" + place + ")";
}

std::optional<Warning> VoidMonitor::warning() const {
    if (particle_ < 0) return {};
    Warning warning;
    warning.key = "particles.spacing";
    warning.location = scene_.particles.spacing.location;
    warning.problem = "of " + number_text(scene_.particles.spacing, 3) +
                      " m is too large, or the drive too strong: " + text() + ", which lacks neighbours on one side. " +
                      (settings_.closes ? "Suction closes it (docs/scheme.md, \"Voids\"); while it is open, pressures "
                                          "are not to be relied on"
                                        : "Pressures near there are wrong from then on; the density does not show it");
    warning.what_to_do = "look at the frames from then on, and compare with a smaller spacing";
    return warning;
}

void VoidMonitor::archive(Archive& file) {
    if (!settings_.watches) return;
    file("voids/particle", particle_);
    file("voids/part", part_);
    file("voids/time", time_);
    file("voids/place", place_);
}

}  // namespace dmp::solver
