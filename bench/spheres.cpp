// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <ctime>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "bench/start.hpp"
#include "bench/uses.hpp"
#include "cli/failure.hpp"
#include "cli/terminal.hpp"
#include "solver/simulation.hpp"

// What spheres in contact cost: a dense bed and a carrier with its fines on a wall, the starts of LAMMPS' inputs
// dem_bulk and dem_carrier, made here.
namespace {

using namespace dmp;
using namespace dmp::bench;

Value<double> given(double value) { return {value, SourceLocation{"bench", 1, 1}}; }
Expression formula(const std::string& text) { return {text, text}; }

struct Start {
    Scene scene;
    ParticleSet set;

    int part(const std::string& name, PartKind kind, double youngs_modulus) {
        Part made;
        made.name = name;
        made.kind = kind;
        made.density = given(2500);
        made.youngs_modulus = given(youngs_modulus);
        made.poisson_ratio = given(0.3);
        scene.parts.push_back(made);
        set.parts.push_back({name, kind == PartKind::spheres ? PartKind::spheres : PartKind::rigid});
        return static_cast<int>(set.parts.size()) - 1;
    }
    void contact(double restitution, double friction) {
        ContactPair pair;
        pair.parts = Value<std::array<std::string, 2>>({"any", "any"}, SourceLocation{"bench", 2, 1});
        pair.restitution = given(restitution);
        pair.friction = given(friction);
        scene.contact_pairs.push_back(pair);
    }
    void sphere(int of_part, const Vec& position, double radius, double mass, const Vec& velocity) {
        set.position.push_back(position);
        set.velocity.push_back(velocity);
        set.angular_velocity.push_back(Vec::Zero());
        set.radius.push_back(radius);
        set.volume.push_back(4 * std::numbers::pi / 3 * radius * radius * radius);
        set.mass.push_back(mass);
        set.part.push_back(of_part);
        set.body.push_back(-1);
        set.fixed.push_back(0);
        set.seated.push_back(0);
        set.wall_normal.push_back(Vec::Zero());
        set.wall_distance.push_back(0);
    }
};

/// A face-centred lattice, radii spread by 5 %, as far apart as they are wide on average: about six contacts a sphere.
/// It is sheared under its weight between periodic sides.
Start bed(int cells) {
    Start made;
    const int bulk = made.part("bulk", PartKind::spheres, 1.4e6), floor = made.part("floor", PartKind::plane, 1.4e6);
    made.contact(0.9, 0.5);
    const double diameter = 1e-4, lattice = diameter * std::sqrt(2.0), side = cells * lattice;
    const std::vector<Vec> basis{{0.25, 0.25, 0}, {0.75, 0.75, 0}, {0.75, 0.25, 0.5}, {0.25, 0.75, 0.5}};
    std::uint64_t id = 0;
    for (int z = 0; z < cells; ++z)
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x)
                for (const Vec& of : basis) {
                    const double radius = 0.5 * diameter * (1 + 0.05 * bench::noise(1, id++, 0));
                    Vec position = lattice * (Vec(x, y, z) + of);
                    position[2] += 0.5 * diameter;
                    made.sphere(bulk, position, radius, 2500 * 4 * std::numbers::pi / 3 * std::pow(radius, 3),
                                {0.05 * (2 * position[2] / side - 1), 0, 0});
                }
    made.set.wall_planes.push_back({floor, Vec::Zero(), Vec::UnitZ()});
    made.set.periodic = {true, true, false};
    made.set.box = {Vec::Zero(), Vec(side, side, 1.3 * side)};
    made.scene.flow.acceleration[2] = formula("-9.81");
    made.scene.numerics.contact_step = given(5e-7);
    return made;
}

/// A carrier of 0.1 mm with 882 fines around it that meets a wall at 10 m/s.
Start carrier() {
    Start made;
    const int inner = made.part("carrier", PartKind::spheres, 2.15e9),
              fines = made.part("fines", PartKind::spheres, 2.15e9), wall = made.part("wall", PartKind::plane, 2.15e9);
    made.contact(0.9, 0.5);
    ContactPair& pair = made.scene.contact_pairs.front();
    pair.adhesion = AdhesionLaw::of<BradleyAdhesion>();
    pair.work_of_adhesion = given(0.0173);
    pair.equilibrium_distance = given(4e-10);
    pair.adhesion_cutoff = given(2e-8);
    const double large = 50e-6, small = 2.5e-6, golden = std::numbers::pi * (3 - std::sqrt(5.0));
    const Vec centre(0, 0, large + 2 * small + 0.05e-6), velocity(0, 0, -10);
    made.sphere(inner, centre, large, 1.31e-9, velocity);
    for (int k = 0; k < 882; ++k) {
        const double z = 1 - 2 * (k + 0.5) / 882, r = std::sqrt(1 - z * z);
        made.sphere(fines, centre + (large + small - 1e-9) * Vec(r * std::cos(golden * k), r * std::sin(golden * k), z),
                    small, 8.44e-14, velocity);
    }
    made.set.wall_planes.push_back({wall, Vec::Zero(), Vec::UnitZ()});
    made.set.box = {Vec::Constant(-2e-4), Vec::Constant(2e-4)};
    made.scene.run.until_steady = given(2e-7);
    return made;
}

double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void measure(const std::string& name, Start made, double until) {
    made.scene.dimension = 3;
    made.set.dimension = 3;
    made.scene.run.duration = given(until);
    made.scene.output.every = given(until);
    Simulation simulation(made.scene, made.set, 1);
    RunOptions options;
    options.until = until / 4;
    if (*made.scene.run.until_steady == 0) simulation.run(options);
    options.until = until;
    const double before = processor_seconds();
    const RunSummary summary = simulation.run(options);
    const double seconds = processor_seconds() - before;
    const auto steps = static_cast<double>(summary.steps - summary.first_step);
    const auto particle_steps = steps * static_cast<double>(made.set.size());
    std::string text =
        name + ": " + std::to_string(made.set.size()) + " spheres, " + std::to_string(summary.spheres->contacts) +
        " contacts, " + std::to_string(static_cast<long>(steps)) + " steps in " + std::to_string(seconds) +
        " s of one processor: " + std::to_string(1e9 * seconds / particle_steps) + " ns, " +
        std::to_string(particle_steps / seconds / 1e6) + "e6 particle-steps/s, on " + std::string(summary.vector_unit) +
        "; still since " + std::to_string(1e6 * summary.spheres->still_since) + " us\n";
    for (const auto& [stage, time] : summary.seconds_by_stage)
        text += "  " + stage + ": " + std::to_string(1e9 * time / particle_steps) + " ns of wall time\n";
    cli::print(text);
}

/// A line with the sides of the periodic box, then one for each sphere: radius, place, velocity.
void print_particles(const ParticleSet& set) {
    const auto three = [](const Vec& v) { return fmt::format("{} {} {}", v[0], v[1], v[2]); };
    std::string text = three(set.box.high) + "\n";
    for (std::size_t i = 0; i < set.size(); ++i)
        text += fmt::format("{} {} {}\n", set.radius[i], three(set.position[i]), three(set.velocity[i]));
    cli::print(text);
}

}  // namespace

/// dmp_bench_spheres [bed|carrier|particles-of-bed]
int main(int argc, char** argv) {
    return cli::exit_code_of([&] {
        const std::string which = argc > 1 ? argv[1] : "";
        if (argc > 2 || (argc > 1 && which != "bed" && which != "carrier" && which != "particles-of-bed"))
            throw InputError({}, "dmp_bench_spheres measures one of bed and carrier, or both without a word",
                             "usage: dmp_bench_spheres [bed|carrier|particles-of-bed]");
        if (which == "particles-of-bed") {
            print_particles(bed(29).set);
            return 0;
        }
        if (which != "carrier") measure("bed", bed(29), 4e-4);
        if (which != "bed") measure("carrier", carrier(), 1e-4);
        return 0;
    });
}
