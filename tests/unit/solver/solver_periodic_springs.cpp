// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Solids of springs that go on through periodic sides, under a load that is a wave of the period's length.
#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>

#include "solver/simulation.hpp"
#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_periodic_springs_tests {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double period = 4, wavenumber = 2 * std::numbers::pi / period, per_particle = 1e-3, phase = 1;

/// A scene with one part and a load of 1 mN cos(k X - 1) on each of its particles along this axis, which settles.
Texts loaded(const std::string& part, const std::string& geometry, int axis, const std::string& more) {
    const std::string load = "\"1 mN * cos(1.5707963267948966 * X / (1 m) - 1)\"";
    const bool in_space = geometry.find("Box(") != std::string::npos;
    std::string force = "[0, " + load + (in_space ? ", 0]" : "]");
    if (axis == 0) force = "[" + load + (in_space ? ", 0, 0]" : ", 0]");
    return {std::string(in_space ? "schema = 1\ndimension = 3\n" : "schema = 1\n") + R"([geometry]
file = "channel.geo"
[particles]
spacing = "0.125 m"
[[part]]
name = "body"
kind = "elastic"
)" + part + R"([[force]]
name = "wave"
part = "body"
amount = "per_particle"
force = )" + force +
                R"(
[flow]
largest_speed = "1 m/s"
)" + more + R"([numerics]
sound_speed = "20 m/s"
[contact]
range = 0
[output]
every = "5 s"
fields = []
solid_fields = ["displacement"]
)",
            geometry};
}

class LastFrame : public FrameSink {
  public:
    void write(const Frame& frame) override { last = frame; }
    Frame last;
};

struct Wave {
    double amplitude = 0;   ///< [m]
    double rest = 0;        ///< largest difference of a particle from the wave, over its amplitude
    std::size_t count = 0;  ///< of particles
};

/// The wave in the displacements along an axis once all is at rest.
Wave wave_of(const Texts& texts, int axis) {
    const Meshed meshed = mesh_texts(texts);
    EXPECT_THAT(meshed.report.warnings, Not(Contains(HasSubstr("its springs end"))));
    LastFrame sink;
    RunOptions options;
    options.sink = &sink;
    Simulation(meshed.scene, meshed.particles, Resources(1)).run(options);
    const FrameGroup& solid = *std::ranges::find(sink.last.groups, "solid", &FrameGroup::name);
    const FrameField& field = *std::ranges::find(solid.fields, "displacement", &FrameField::name);
    Wave wave;
    wave.count = solid.id.size();
    const auto moved = [&](std::size_t k) { return static_cast<double>(field.values[3 * k + axis]); };
    const auto shape = [&](std::size_t k) {
        return std::cos(wavenumber * meshed.particles.position[static_cast<std::size_t>(solid.id[k])][0] - phase);
    };
    double mean = 0, squares = 0;
    for (std::size_t k = 0; k < wave.count; ++k) mean += moved(k) / static_cast<double>(wave.count);
    for (std::size_t k = 0; k < wave.count; ++k) {
        wave.amplitude += (moved(k) - mean) * shape(k);
        squares += shape(k) * shape(k);
    }
    wave.amplitude /= squares;
    for (std::size_t k = 0; k < wave.count; ++k)
        wave.rest = std::max(wave.rest, std::abs(moved(k) - mean - wave.amplitude * shape(k)) / wave.amplitude);
    return wave;
}

const std::string line = R"(Point(1) = {0, 0, 0};
Point(2) = {4, 0, 0};
Line(1) = {1, 2};
Physical Curve("body") = {1};
)";

/// EI = 1 N m^2, 1 kg/m: the wave's frequency is k^2 / s.
std::string strip(const std::string& more) {
    return R"(bending_stiffness = "1 N*m^2"
mass_per_length = "1 kg/m"
mass_damping = "5 1/s"
)" + more;
}

double deflection(double load, double bending, double shear) {
    const double k2 = wavenumber * wavenumber;
    return load / (bending * k2 * k2) + load / (shear * k2);
}

TEST(PeriodicSprings, a_strip_bends_under_a_wave_as_a_beam_without_ends) {
    for (const auto* kind : {"axial_stiffness = \"128 N\"\n", "axial_stiffness = \"1 kN\"\ncross_bonds = true\n"}) {
        const Texts texts = loaded(strip(kind), line, 1, "periodic = [\"x\"]\n[run]\nduration = \"5 s\"\n");
        const Meshed meshed = mesh_texts(texts);
        const auto& report = meshed.report.springs.at(0);
        ASSERT_EQ(meshed.particles.size(), 2U * 32);
        const Wave wave = wave_of(texts, 1);
        const double expected = deflection(2 * per_particle / 0.125, report.bending_stiffness, report.shear_stiffness);
        EXPECT_NEAR(wave.amplitude / expected, 1, 0.005) << kind;
        EXPECT_LT(wave.rest, 1e-3) << kind;
    }
}

/// Of 2 kPa and 32 kg/m^3: sound of 8 m/s.
const std::string material = R"(model = "springs"
youngs_modulus = "2 kPa"
poisson_ratio = 0.25
density = "32 kg/m^3"
mass_damping = "20 1/s"
)";

TEST(PeriodicSprings, an_area_stretches_under_a_wave_as_a_bar_without_ends) {
    const std::string area = polygon({{0, 0}, {4, 0}, {4, 0.25}, {0, 0.25}}, "body");
    const Wave wave = wave_of(loaded(material, area, 0, "periodic = [\"x\"]\n[run]\nduration = \"5 s\"\n"), 0);
    EXPECT_EQ(wave.count, 2U * 32);
    const double stiffness = 2000 / (1 - 1.0 / 16) * 0.25, load = 2 * per_particle / 0.125;
    EXPECT_NEAR(wave.amplitude / (load / (stiffness * wavenumber * wavenumber)), 1, 0.01);
    EXPECT_LT(wave.rest, 1e-3);
}

TEST(PeriodicSprings, a_volume_stretches_under_a_wave_as_a_bar_without_ends) {
    const std::string volume = R"(SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 4, 0.25, 0.25};
Physical Volume("body") = {1};
)";
    const Wave wave = wave_of(loaded(material, volume, 0, "periodic = [\"x\"]\n[run]\nduration = \"5 s\"\n"), 0);
    EXPECT_EQ(wave.count, 4U * 32);
    const double stiffness = 2000 * 0.0625, load = 4 * per_particle / 0.125;
    EXPECT_NEAR(wave.amplitude / (load / (stiffness * wavenumber * wavenumber)), 1, 0.01);
    EXPECT_LT(wave.rest, 1e-3);
}

TEST(PeriodicSprings, a_shell_through_two_periods_bends_under_a_wave_as_a_plate_without_edges) {
    const std::string sheet = R"(SetFactory("OpenCASCADE");
Point(1) = {0, 0, 0};
Point(2) = {4, 0, 0};
Point(3) = {4, 0, 1};
Point(4) = {0, 0, 1};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("body") = {1};
Box(1) = {1, -0.5, 0.25, 1, 0.25, 0.5};
Physical Volume("block") = {1};
)";
    const Texts texts = loaded(R"(youngs_modulus = "12 kPa"
thickness = "0.1 m"
poisson_ratio = 0.25
density = "10 kg/m^3"
mass_damping = "5 1/s"
[[part]]
name = "block"  # which makes the geometry one in 3-D
kind = "rigid"
enabled = false
)",
                               sheet, 1, "periodic = [\"x\", \"z\"]\n[run]\nduration = \"5 s\"\n");
    const Meshed meshed = mesh_texts(texts);
    const Wave wave = wave_of(texts, 1);
    const auto& shell = meshed.report.springs.at(0).shell->constants;
    const double load = per_particle * static_cast<double>(wave.count) / 4;
    const double expected = deflection(load, shell.bending_stiffness(), shell.shear_stiffness());
    // Seven or eight triangles across, which are not equilateral: 0.916.
    EXPECT_NEAR(wave.amplitude / expected, 1, 0.1);
    EXPECT_LT(wave.rest, 0.05);
}

}  // namespace
}  // namespace dmp::tests::solver_periodic_springs_tests
