// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/options.hpp"
#include "bench/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::bench {

/// The median of repeats with the extremes beside it, which say how far it can be trusted.
struct Spread {
    double median = 0, smallest = 0, largest = 0;
};
/// Of at least one value.
Spread spread_of(std::vector<double> values);

/// Pair sweeps that the engine makes in one step: forces, and density rates with the new velocities.
inline constexpr int sweeps_per_step = 2;

/// What the engine took. Times are those of all threads together: wall time times threads. Particles of walls count.
struct EngineTimes {
    Spread step;                           ///< a whole step, neighbour lists and all [ns per particle]
    std::map<std::string, Spread> stage;   ///< the same, by stage of the step and "rest"
    double processor = 0;                  ///< share of the time that its threads had a processor, median [-]
    long steps = 0;                        ///< in one repeat
    double step_seconds = 0;               ///< simulated in one step, on average
    std::size_t planned_bytes = 0;         ///< per particle, by the plan
    std::optional<double> resident_bytes;  ///< per particle, of the largest resident set above the start's; none: the
                                           ///< system does not tell
    double viscous_iterations = 0;         ///< of implicit viscosity in one step, on average
    double density_low = 0, density_high = 0;  ///< of the fluid, over density at rest, that the run was a sane one [-]
};

struct Measured {
    std::size_t fluid = 0, walls = 0;  ///< particles
    double pairs = 0;                  ///< pairs within the support per particle; each counts once [-]
    double pairs_listed = 0;           ///< the same in the yardstick's list
    Spread yardstick;                  ///< one sweep [ns per particle]
    double yardstick_processor = 0;    ///< share of the time that it had a processor, median [-]
    std::optional<EngineTimes> engine;

    [[nodiscard]] std::size_t particles() const { return fluid + walls; }
};

/// Times engine and yardstick in turns. Throws what the scene's reading and the engine throw.
Measured measure(const Options& options);

/// As text or JSON, as the options have it.
std::string report(const Options& options, const Measured& measured);

}  // namespace dmp::bench
