// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "bench/start.hpp"
#include "bench/uses.hpp"
#include "solver/parallel/resources.hpp"

namespace dmp::bench {

/// What dmp_bench is asked to measure.
struct Options {
    std::string name;  ///< of the case
    Channel channel;
    int threads = 1;                                                  ///< the engine's; the yardstick has one
    VectorUnit vector_unit = chosen_vector_unit(VectorUnit::widest);  ///< the engine's
    int steps = 100;              ///< of the engine in one repeat, and sweeps of the yardstick
    int repeat = 5;               ///< how often each is timed
    bool json = false;            ///< JSON instead of text
    bool yardstick_only = false;  ///< without the engine
    std::string particles_to;     ///< write the particles into this file and measure nothing; empty: measure
    std::string help;             ///< print this and end; empty: measure
};

/// What the command line asks for; argv[0] is the program's name.
/// Throws InputError: unknown option or case (with the nearest name), missing or malformed value.
Options read_options(std::span<const char* const> argv);

}  // namespace dmp::bench
