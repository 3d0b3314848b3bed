// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>

#include "base/allocation.hpp"
#include "base/errors.hpp"
#include "bench/measure.hpp"
#include "bench/options.hpp"
#include "bench/particle_file.hpp"
#include "cli/exit_codes.hpp"
#include "cli/failure.hpp"
#include "cli/terminal.hpp"

namespace {

void write_particles(const dmp::bench::Options& options) {
    std::ofstream file(options.particles_to, std::ios::binary);
    file << dmp::bench::particle_text(options.channel, dmp::bench::make_particles(options.channel)) << std::flush;
    if (!file)
        throw dmp::ResourceError("cannot write " + options.particles_to, "Check its folder and the room left there.");
}

int execute(const dmp::bench::Options& options) {
    if (!options.help.empty())
        dmp::cli::print(options.help);
    else if (!options.particles_to.empty())
        write_particles(options);
    else
        dmp::cli::print(report(options, measure(options)));
    return dmp::cli::exit_done;
}

}  // namespace

/// dmp_bench: the engine's speed on one start, beside the yardstick's.
int main(int argc, char** argv) {
    dmp::return_large_arrays();
    return dmp::cli::exit_code_of([&] {
        return execute(dmp::bench::read_options(std::span<const char* const>(argv, static_cast<std::size_t>(argc))));
    });
}
