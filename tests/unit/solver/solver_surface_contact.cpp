// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Elastic bodies that touch each other and walls as their drawn surfaces.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>

#include "models/contact/surface_contact.hpp"
#include "solver/contact/curve_piece.hpp"
#include "solver/simulation.hpp"
#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"

namespace dmp::tests::solver_surface_contact_tests {
namespace {

using testing::HasSubstr;

TEST(SurfaceContactLaw, is_the_slope_of_its_energy) {
    const SurfaceContactLaw law;
    constexpr double k = 3e6, step = 1e-9;
    for (const double gap : {-2e-4, -1e-5, 1e-5}) {
        const double slope =
            (SurfaceContactLaw::energy(k, gap + step) - SurfaceContactLaw::energy(k, gap - step)) / (2 * step);
        EXPECT_NEAR(law.pressure(k, gap, 5, 1), -slope, 1e-6 * k * 1e-4);
    }
}

TEST(SurfaceContactLaw, has_a_dashpot_that_never_pulls) {
    const SurfaceContactLaw law{0, 0.5};
    constexpr double k = 4e6, mass = 1;  // 2 zeta (k m)^1/2 = 2000 Pa s/m
    EXPECT_NEAR(law.pressure(k, -1e-3, -0.5, mass), 4000 + 1000, 1e-9);
    EXPECT_NEAR(law.pressure(k, -1e-3, 1, mass), 4000 - 2000, 1e-9);
    EXPECT_EQ(law.pressure(k, -1e-3, 3, mass), 0);
    EXPECT_EQ(law.pressure(k, 1e-3, -3, mass), 0);
}

TEST(SurfaceContactLaw, holds_up_to_the_friction_and_forgets_what_slid) {
    const SurfaceContactLaw law{0.3, 0};
    constexpr double k = 1e6, pressure = 100;  // k_t = 7e5: 30 Pa at 43 um
    Vec slip(2e-5, 0, 0);
    EXPECT_NEAR(law.traction(k, pressure, slip)[0], -14, 1e-9);
    EXPECT_EQ(slip[0], 2e-5);
    slip = Vec(0, 1e-3, 0);
    EXPECT_NEAR(law.traction(k, pressure, slip)[1], -30, 1e-9);
    EXPECT_NEAR(slip[1], 30 / 7e5, 1e-12);
}

TEST(CurvePiece, finds_the_nearest_point_of_all_that_it_has) {
    const CurvePiece piece{{Vec(0, 0, 0), Vec(0.5, 0.2, 0), Vec(1, 0, 0)}};
    for (const Vec& point : {Vec(0.3, 0.4, 0), Vec(0.7, -0.1, 0), Vec(0.52, 0.08, 0), Vec(-1, 0.3, 0), Vec(2, 0, 0)}) {
        double least = 1e9;
        for (int k = 0; k <= 20000; ++k) least = std::min(least, (piece.at(k / 20000.0) - point).norm());
        EXPECT_NEAR((piece.at(piece.nearest(point)) - point).norm(), least, 2e-8);
    }
    EXPECT_EQ(piece.nearest(Vec(-1, 0.3, 0)), 0);
    EXPECT_EQ(piece.nearest(Vec(2, 0, 0)), 1);
    EXPECT_NEAR(piece.normal(0.5)[1], -1, 1e-15);
}

constexpr double degree = std::numbers::pi / 180;

std::string number(double value) {
    std::ostringstream text;
    text << std::setprecision(15) << value;
    return text.str();
}

/// A block of 6 x 3 mm, drawn 2.13 mm above the lower side of a bar that is held there, or on the bar, in gravity of
/// 10 m/s^2 across the bar and of `pull` along it; all turned by an angle.
struct Slide {
    double turned = 0;  ///< [rad]
    double pull = 2;    ///< [m/s^2]
    double above = 0;   ///< the bar, at the start [mm]
    double friction = 0;
    std::string model = "cells";
    std::string more = "";
    std::string duration = "0.06 s";

    /// With its points and lines numbered from 10 times its number on [mm].
    [[nodiscard]] std::string rectangle(int of, double x, double y, double width, double height) const {
        std::string text;
        for (int k = 0; k < 4; ++k) {
            const double at_x = x + (k == 1 || k == 2 ? width : 0), at_y = y + (k > 1 ? height : 0);
            text += "Point(" + std::to_string(10 * of + k) + ") = {" +
                    number(at_x * std::cos(turned) - at_y * std::sin(turned)) + "e-3, " +
                    number(at_x * std::sin(turned) + at_y * std::cos(turned)) + "e-3, 0};\n";
        }
        const std::string n = std::to_string(of);
        return text + "Line(" + n + "1) = {" + n + "0, " + n + "1};\nLine(" + n + "2) = {" + n + "1, " + n +
               "2};\nLine(" + n + "3) = {" + n + "2, " + n + "3};\nLine(" + n + "4) = {" + n + "3, " + n +
               "0};\nCurve Loop(" + n + ") = {" + n + "1, " + n + "2, " + n + "3, " + n + "4};\nPlane Surface(" + n +
               ") = {" + n + "};\n";
    }
    [[nodiscard]] Texts texts() const {
        const double c = std::cos(turned), s = std::sin(turned);
        const std::string solid =
            "kind = \"elastic\"\ndensity = \"1000 kg/m^3\"\nyoungs_modulus = \"10 MPa\"\npoisson_ratio = 0.25\nmodel = "
            "\"" +
            model + "\"\n";
        return {
            "schema = 1\ntitle = \"slide\"\ndimension = 2\n[geometry]\nfile = \"channel.geo\"\n[particles]\nspacing = "
            "\"0.5 mm\"\n[[part]]\nname = \"floor\"\nanchor = \"held\"\n" +
                solid + "[[part]]\nname = \"block\"\n" + solid + "[flow]\nacceleration = [\"" +
                number(10 * s + pull * c) + " m/s^2\", \"" + number(-10 * c + pull * s) +
                " m/s^2\"]\nlargest_speed = \"0.5 m/s\"\n[contact]\nfriction = " + number(friction) + "\n" + more +
                "[run]\nduration = \"" + duration + "\"\n[output]\nevery = \"" + duration +
                "\"\n[[measure]]\nname = \"b\"\nkind = \"body\"\npart = \"block\"\n",
            rectangle(1, 0, 0, 24, 2) + rectangle(2, 4.13, 2 + above, 6, 3) +
                "Physical Surface(\"floor\") = {1};\nPhysical Surface(\"block\") = {2};\nPhysical Curve(\"held\") = "
                "{11};\n"};
    }
};

/// What a run says of a body in its last row.
struct Ran {
    RunSummary summary;

    [[nodiscard]] double last(const std::string& column) const {
        const auto found = std::ranges::find(summary.measures.names, column);
        if (found == summary.measures.names.end()) throw std::logic_error("no column " + column);
        return summary.measures.rows.back().at(static_cast<std::size_t>(found - summary.measures.names.begin()));
    }
};

Ran run(const Texts& texts) {
    const Meshed meshed = mesh_texts(texts);
    return {Simulation(meshed.scene, meshed.particles, Resources(1)).run({})};
}

double speed_along(const Ran& ran, double angle) {
    return ran.last("b_velocity_x") * std::cos(angle) + ran.last("b_velocity_y") * std::sin(angle);
}

TEST(SurfaceContact, slides_without_friction_on_any_lattice_also_when_it_bounces) {
    for (const std::string model : {"cells", "springs"})
        for (const double turned : {0.0, 17 * degree})
            for (const double above : {0.0, 0.3}) {
                const Ran ran = run(Slide{.turned = turned, .above = above, .model = model}.texts());
                // What bounces dents the floor and leaves waves in it.
                EXPECT_NEAR(speed_along(ran, turned), 2 * 0.06, (above > 0 ? 0.015 : 0.002) * 0.12)
                    << model << " " << turned << " " << above << " " << speed_along(ran, turned);
                ASSERT_TRUE(ran.summary.contact);
                EXPECT_LT(ran.summary.contact->depth, 0.1 * 0.5e-3);
                EXPECT_LT(ran.summary.momentum_residual, 1e-13);
            }
}

TEST(SurfaceContact, slides_or_sticks_as_coulomb_says) {
    for (const double turned : {0.0, 17 * degree}) {
        const Ran slides = run(Slide{.turned = turned, .pull = 5, .friction = 0.3}.texts());
        EXPECT_NEAR(speed_along(slides, turned), 2 * 0.06, 0.015 * 0.12) << turned;
        const Ran sticks = run(Slide{.turned = turned, .pull = 2, .friction = 0.3, .more = "damping = 0.2\n"}.texts());
        EXPECT_NEAR(speed_along(sticks, turned), 0, 0.002) << turned;
    }
}

/// Two discs that meet head-on, 0.5 mm beside each other: by a circle's normal they leave with +-0.0332 m/s across.
Texts meeting_discs(double shift, const std::string& modulus = "1 MPa") {
    const std::string disc =
        "kind = \"elastic\"\ndensity = \"1000 kg/m^3\"\nyoungs_modulus = \"" + modulus + "\"\npoisson_ratio = 0.25\n";
    return {
        "schema = 1\ntitle = \"discs\"\ndimension = 2\n[geometry]\nfile = \"channel.geo\"\n[particles]\nspacing = "
        "\"0.5 mm\"\n[[part]]\nname = \"a\"\ninitial_velocity = [\"0.2 m/s\", 0]\n" +
            disc + "[[part]]\nname = \"b\"\ninitial_velocity = [\"-0.2 m/s\", 0]\n" + disc +
            "[[part]]\nname = \"space\"\nkind = \"fluid\"\ndensity = \"1000 kg/m^3\"\nviscosity = \"1 mPa*s\"\nenabled "
            "= false\n[flow]\nperiodic = [\"x\", \"y\"]\nlargest_speed = \"0.5 m/s\"\n[run]\nduration = \"16 "
            "ms\"\n[output]\nevery = "
            "\"1 ms\"\n[[measure]]\nname = \"a\"\nkind = \"body\"\npart = \"a\"\n[[measure]]\nname = \"b\"\nkind = "
            "\"body\"\npart = \"b\"\n",
        "SetFactory(\"OpenCASCADE\");\nDisk(1) = {" + number(6 + shift) + "e-3, 9e-3, 0, 3e-3};\nDisk(2) = {" +
            number(13 + shift) +
            "e-3, 9.5e-3, 0, 3e-3};\nRectangle(3) = {0, 0, 0, 20e-3, 20e-3};\nBooleanFragments{Surface{3}; "
            "Delete;}{Surface{1, 2}; "
            "Delete;}\nPhysical Surface(\"a\") = {1};\nPhysical Surface(\"b\") = {2};\nPhysical Surface(\"space\") = "
            "{3};\n"};
}

TEST(SurfaceContact, lets_smooth_discs_pass_without_spin) {
    const Ran ran = run(meeting_discs(0));
    const auto& rows = ran.summary.measures.rows;
    const auto angle = static_cast<std::size_t>(std::ranges::find(ran.summary.measures.names, "a_angle") -
                                                ran.summary.measures.names.begin());
    const double spin = (rows.back()[angle] - rows[rows.size() - 4][angle]) / 3e-3;
    EXPECT_LT(std::abs(spin), 1);  // rad/s
    const double across = ran.last("a_velocity_y"), along = ran.last("a_velocity_x");
    EXPECT_NEAR(across, -0.0332, 0.03 * 0.0332);
    EXPECT_NEAR(std::hypot(across, along), 0.2, 0.015 * 0.2);  // some goes into swinging
    EXPECT_LT(std::abs(ran.summary.end.momentum[0]), 1e-14);
    EXPECT_LT(std::abs(ran.summary.end.momentum[1]), 1e-14);
}

TEST(SurfaceContact, refuses_bodies_that_are_drawn_into_each_other_with_the_place) {
    const Meshed meshed = mesh_texts(Slide{.above = -0.12}.texts());
    try {
        Simulation(meshed.scene, meshed.particles, Resources(1));
        FAIL() << "nothing said";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("overlap at the start, by 0.12 mm at ("));
        EXPECT_THAT(error.what(), HasSubstr("'block'"));
    }
}

TEST(SurfaceContact, names_bad_input) {
    EXPECT_THAT(fault_of(Slide{.friction = -0.1}.texts()), HasSubstr("friction"));
    EXPECT_THAT(fault_of(Slide{.friction = 0.3, .more = "between = \"particles\"\n"}.texts()),
                HasSubstr("contact.friction is of surfaces"));
    EXPECT_THAT(fault_of(Slide{.more = "stiffness = \"-1 Pa/m\"\n"}.texts()), HasSubstr("stiffness"));
    EXPECT_THAT(fault_of(Slide{.more = "between = \"nothing\"\n"}.texts()), HasSubstr("'surfaces'"));
}

}  // namespace
}  // namespace dmp::tests::solver_surface_contact_tests
