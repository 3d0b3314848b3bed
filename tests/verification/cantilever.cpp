// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A strip of two rows of nodes, clamped at one end: what it bends, stretches and swings like, against beams.
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::cantilever_tests {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double clamped_free = 1.8751040687;  // of cos(x) cosh(x) = -1

/// Displacements of the strip's nodes in the last frame; over time its share of the first shape of a clamped beam.
class Swing : public FrameSink {
  public:
    explicit Swing(double length) : length_(length) {}
    void write(const Frame& frame) override {
        const FrameGroup& nodes = required_group(frame, "solid");
        const std::vector<float>& moved = required_field(nodes, "displacement").values;
        double sum = 0;
        end = {};
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            const double x = nodes.position[3 * k] - moved[3 * k];
            sum += shape(x / length_) * moved[3 * k + 1];
            if (x > (1 - 1e-6) * length_)
                for (std::size_t axis = 0; axis < 2; ++axis) end.at(axis) += moved[3 * k + axis] / 2;
        }
        of_time.emplace_back(frame.time, sum);
    }
    /// Mean time between two crossings of rest in one direction, from a time on.
    [[nodiscard]] double period(double from) const {
        std::vector<double> crossings;
        for (std::size_t k = 1; k < of_time.size(); ++k) {
            const auto [before, last] = of_time[k - 1];
            const auto [now, next] = of_time[k];
            if (before >= from && last < 0 && next >= 0)
                crossings.push_back(before + (now - before) * last / (last - next));
        }
        EXPECT_GE(crossings.size(), 4U);
        return (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
    }
    std::array<double, 2> end{};  ///< of the free end [m]
    std::vector<std::pair<double, double>> of_time;

  private:
    static double shape(double x) {
        const double b = clamped_free;
        const double ratio = (std::cosh(b) + std::cos(b)) / (std::sinh(b) + std::sin(b));
        return std::cosh(b * x) - std::cos(b * x) - ratio * (std::sinh(b * x) - std::sin(b * x));
    }
    double length_;
};

/// A strip of cells as long as high, a, with k_b = 1000 N/m, k_a = `hinge` k_b a^2, or diagonals of k_b, and what such
/// a lattice is as a beam (docs/elastic.md).
struct Lattice {
    int cells;
    double hinge;  ///< 0: diagonals

    static constexpr double length = 0.02, bond = 1000, mass_per_length = 1;
    [[nodiscard]] double cell() const { return length / cells; }
    [[nodiscard]] double axial() const { return (hinge > 0 ? 4 : 5) * bond * cell(); }
    [[nodiscard]] double bending() const { return (1 + 2 * hinge) * bond * std::pow(cell(), 3); }
    [[nodiscard]] double shear() const { return (hinge > 0 ? 8 * hinge : 2) * bond * cell(); }
    /// Of the first vibration: a beam's, slowed down by shear (Dunkerley), by the rotation of its columns and by masses
    /// that stand at points, with the shape's INT w'^2 L^2 = 4.648 INT w^2 and 2 w w' L / 12 = 0.918 INT w^2 / L at its
    /// end.
    [[nodiscard]] double frequency() const {
        const double slope = 4.648 * std::pow(cell() / 2 / length, 2), points = 0.918 / std::pow(cells, 2);
        const double slower = std::pow(clamped_free, 4) * bending() / shear() / std::pow(length * pi / 2, 2);
        return clamped_free * clamped_free / (length * length) *
               std::sqrt(bending() / mass_per_length / (1 + slope + points + slower));
    }
    /// Of the first stretching vibration.
    [[nodiscard]] double stretching_frequency() const {
        return pi / (2 * length) * std::sqrt(axial() / mass_per_length);
    }
    [[nodiscard]] std::string name() const {
        std::ostringstream text;
        text << cells << " cells";
        hinge > 0 ? text << ", k_a / (k_b a^2) = " << hinge : text << " with diagonals";
        return text.str();
    }
    /// The case with this lattice and steps of dt.
    [[nodiscard]] std::vector<std::string> overrides(double dt) const {
        const double thickness = std::sqrt(12 * bending() / axial());
        return {"geometry.parameters={ length = \"20 mm\" }",
                set_to("particles.spacing", cell(), "m"),
                set_to("part.strip.youngs_modulus", axial() / thickness, "Pa"),
                set_to("part.strip.thickness", thickness, "m"),
                "part.strip.poisson_ratio=0",
                "part.strip.lower_axial_stiffness=false",
                set_to("part.strip.mass_per_length", mass_per_length, "kg/m"),
                std::string("part.strip.cross_bonds=") + (hinge > 0 ? "false" : "true"),
                set_to("numerics.sound_speed", 0.9 * cell() / dt, "m/s")};
    }
    /// A force on the free end, along x or y, that comes in its own time and stays until `until`.
    [[nodiscard]] std::vector<std::string> force(int axis, double newton, double until) const {
        const std::string formula = "x > " + quantity(length - cell() / 2, "m") + " ? " + quantity(newton / 2, "N") +
                                    " * (1 - cos(pi * min(t / " + quantity(until, "s") + ", 0.5) * 2)) / 2 : 0";
        return {"force.bend.force=[" + (axis == 0 ? '"' + formula + "\", 0]" : "0, \"" + formula + "\"]"),
                set_to("force.bend.until", until, "s")};
    }
};

/// Where the free end comes to rest under a force along an axis.
struct Rest {
    double moved;
    RunSummary run;
};
Rest come_to_rest(const Lattice& lattice, int axis, double newton) {
    const double omega = axis == 0 ? lattice.stretching_frequency() : lattice.frequency(), time = 60 / omega;
    std::vector<std::string> overrides = lattice.overrides(0.06 / omega);
    for (const std::string& more : lattice.force(axis, newton, time)) overrides.push_back(more);
    // Damped by 0.7 of what is critical for the slowest vibration.
    overrides.push_back(
        set_to("part.strip.drag", 2 * 0.7 * omega * Lattice::mass_per_length * lattice.cell() / 2, "kg/s"));
    overrides.push_back(set_to("output.every", time, "s"));
    Swing last(Lattice::length);
    const RunSummary run = run_case("verification/cantilever", overrides, time, &last, 1);
    return {last.end.at(static_cast<std::size_t>(axis)), run};
}

class Cantilever : public testing::TestWithParam<double> {};

// Held at one end, pulled at the other by P: P L / EA along it, P L^3 / (3 EI) (1 - 1 / (4 n^2)) + P L / GA across it,
// of n cells, which bend by the moment in their middles.
TEST_P(Cantilever, StretchesBendsAndShears) {
    const Lattice slender{64, GetParam()}, stout{6, GetParam()};
    const double length = Lattice::length;
    const auto bent = [&](const Lattice& lattice, double load) {
        return load * std::pow(length, 3) / (3 * lattice.bending()) * (1 - 0.25 / (lattice.cells * lattice.cells));
    };
    const auto sheared = [&](const Lattice& lattice, double load) { return load * length / lattice.shear(); };
    const auto load_of = [&](const Lattice& lattice) {  // a thousandth of the length
        return 1e-3 * length / (bent(lattice, 1) + sheared(lattice, 1));
    };
    const double pull = 1e-4 * slender.axial(), load = load_of(slender), stout_load = load_of(stout);
    const Rest stretched = come_to_rest(slender, 0, pull), across = come_to_rest(slender, 1, load),
               short_one = come_to_rest(stout, 1, stout_load);
    Record record("cantilever", slender.name(), across.run);
    record.percent("EA", pull * length / stretched.moved / slender.axial() - 1, 0.002);
    record.percent("EI", bent(slender, load) / (across.moved - sheared(slender, load)) - 1, 0.002);
    record.percent("GA, of 6 cells", sheared(stout, stout_load) / (short_one.moved - bent(stout, stout_load)) - 1,
                   0.002);
    const auto springs = std::find_if(across.run.limits.begin(), across.run.limits.end(),
                                      [](const StepLimit& limit) { return limit.model.starts_with("elastic"); });
    ASSERT_NE(springs, across.run.limits.end());
    const double dt = across.run.simulated_s / static_cast<double>(across.run.steps);
    record.at_least("stiffness over the largest that an explicit step could stand", std::pow(dt / springs->dt, 2), 1e4);
}

INSTANTIATE_TEST_SUITE_P(Lattices, Cantilever, testing::Values(0.05, 0.5, 5, 0));

/// Bent slowly, let go, and followed through five swings.
void expect_period(const std::string& setting, const std::vector<std::string>& overrides, double length, double period,
                   double released) {
    std::vector<std::string> all = overrides;
    all.push_back(set_to("output.every", period / 100, "s"));
    Swing swing(length);
    const RunSummary run = run_case("verification/cantilever", all, released + 5.5 * period, &swing, 1);
    Record record("cantilever", setting, run);
    record.percent("frequency of its swings", period / swing.period(released) - 1, 0.002);
}

TEST(Cantilever, SwingsAtItsFirstFrequency) {
    for (const Lattice& lattice : {Lattice{20, 0.5}, Lattice{64, 0.5}, Lattice{64, 0}}) {
        const double period = 2 * pi / lattice.frequency(), released = 6 * period;
        const double load = 0.01 * 3 * lattice.bending() / std::pow(Lattice::length, 2);
        std::vector<std::string> overrides = lattice.overrides(period / 200);
        for (const std::string& more : lattice.force(1, load, released)) overrides.push_back(more);
        expect_period(lattice.name() + ", swinging", overrides, Lattice::length, period, released);
    }
}

// Gray, Monaghan & Swift (Comput. Methods Appl. Mech. Eng. 190 (2001) 6641): 200 mm x 20 mm, 2 MPa, nu = 0.3975, 1000
// kg/m^3. A thin plate swings with omega = 1.8751^2 / L^2 sqrt(E h^2 / (12 rho (1 - nu^2))), T = 0.25403 s.
TEST(Cantilever, IsTheOscillatingPlate) {
    constexpr double length = 0.2, height = 0.02, modulus = 2e6, poisson = 0.3975, density = 1000;
    const double omega = clamped_free * clamped_free / (length * length) *
                         std::sqrt(modulus * height * height / (12 * density * (1 - poisson * poisson)));
    expect_period("the plate as it stands", {}, length, 2 * pi / omega, 0.8);
}

}  // namespace
}  // namespace dmp::tests::cantilever_tests
