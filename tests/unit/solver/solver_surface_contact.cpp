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
    bool measures_contact = true;

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
                "\"\n[[measure]]\nname = \"b\"\nkind = \"body\"\npart = \"block\"\n" +
                (measures_contact
                     ? "[[measure]]\nname = \"c\"\nkind = \"contact\"\npart = \"block\"\nagainst = \"floor\"\n"
                     : ""),
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
        const Vec force(sticks.last("c_force_x"), sticks.last("c_force_y"), 0);
        const Vec along(std::cos(turned), std::sin(turned), 0), up(-along[1], along[0], 0);
        EXPECT_GT(force.dot(up), 0) << turned;
        EXPECT_LE(std::abs(force.dot(along)), (0.3 + 1e-6) * force.dot(up)) << turned;
    }
}

/// Two discs that meet head-on, 0.5 mm beside each other: by a circle's normal they leave with +-0.0332 m/s across.
Texts meeting_discs() {
    const std::string disc =
        "kind = \"elastic\"\ndensity = \"1000 kg/m^3\"\nyoungs_modulus = \"1 MPa\"\npoisson_ratio = 0.25\n";
    return {
        "schema = 1\ntitle = \"discs\"\ndimension = 2\n[geometry]\nfile = \"channel.geo\"\n[particles]\nspacing = "
        "\"0.25 mm\"\n[[part]]\nname = \"a\"\ninitial_velocity = [\"0.2 m/s\", 0]\n" +
            disc + "[[part]]\nname = \"b\"\ninitial_velocity = [\"-0.2 m/s\", 0]\n" + disc +
            "[[part]]\nname = \"space\"\nkind = \"fluid\"\ndensity = \"1000 kg/m^3\"\nviscosity = \"1 mPa*s\"\nenabled "
            "= false\n[flow]\nperiodic = [\"x\", \"y\"]\nlargest_speed = \"0.5 m/s\"\n[run]\nduration = \"16 "
            "ms\"\n[output]\nevery = "
            "\"1 ms\"\n[[measure]]\nname = \"a\"\nkind = \"body\"\npart = \"a\"\n[[measure]]\nname = \"b\"\nkind = "
            "\"body\"\npart = \"b\"\n",
        "SetFactory(\"OpenCASCADE\");\nDisk(1) = {6e-3, 9e-3, 0, 3e-3};\nDisk(2) = {13e-3, 9.5e-3, 0, "
        "3e-3};\nRectangle(3) = {0, 0, 0, 20e-3, 20e-3};\nBooleanFragments{Surface{3}; "
        "Delete;}{Surface{1, 2}; "
        "Delete;}\nPhysical Surface(\"a\") = {1};\nPhysical Surface(\"b\") = {2};\nPhysical Surface(\"space\") = "
        "{3};\n"};
}

TEST(SurfaceContact, lets_smooth_discs_pass_without_spin) {
    const Ran ran = run(meeting_discs());
    const auto& rows = ran.summary.measures.rows;
    const auto angle = static_cast<std::size_t>(std::ranges::find(ran.summary.measures.names, "a_angle") -
                                                ran.summary.measures.names.begin());
    const double spin = (rows.back()[angle] - rows[rows.size() - 4][angle]) / 3e-3;
    EXPECT_LT(std::abs(spin), 1);  // rad/s
    const double across = ran.last("a_velocity_y"), along = ran.last("a_velocity_x");
    EXPECT_NEAR(across, -0.0332, 0.02 * 0.0332);
    EXPECT_NEAR(std::hypot(across, along), 0.2, 0.025 * 0.2);  // some goes into swinging
    EXPECT_LT(std::abs(ran.summary.end.momentum[0]), 1e-14);
    EXPECT_LT(std::abs(ran.summary.end.momentum[1]), 1e-14);
}

/// An embolus 2.4 mm across that a flow carries against a rigid post, both off the middle of the channel.
Texts embolus_at_post(const std::string& modulus, double speed, const std::string& more) {
    return {
        "schema = 1\ntitle = \"post\"\ndimension = 2\n[geometry]\nfile = \"channel.geo\"\nunit = \"1 "
        "mm\"\n[particles]\nspacing = \"0.3 mm\"\n[[part]]\nname = \"blood\"\nkind = \"fluid\"\ndensity = "
        "\"1060 kg/m^3\"\nviscosity = \"3.5 mPa*s\"\n[[part]]\nname = \"embolus\"\nkind = "
        "\"elastic\"\nyoungs_modulus = \"" +
            modulus +
            "\"\npoisson_ratio = 0.3\ndensity = \"1060 kg/m^3\"\nelastic_law = "
            "\"neo_hookean\"\ninitial_velocity = [\"" +
            number(speed) +
            " m/s\", 0]\n[[part]]\nname = \"wall\"\nkind = \"rigid\"\n[[part]]\nname = \"post\"\nkind = "
            "\"rigid\"\n[flow]\nperiodic = [\"x\"]\npressure_gradient = [\"-300 Pa/m\", 0]\ninitial_velocity = "
            "[\"" +
            number(speed) + " m/s\", 0]\nlargest_speed = \"" + number(3 * speed) + " m/s\"\n[run]\nduration = \"" +
            number(8e-3 / speed) + " s\"\n[output]\nevery = \"" + number(0.4e-3 / speed) +
            " s\"\n[[measure]]\nname = \"hit\"\nkind = \"contact\"\npart = \"embolus\"\nagainst = "
            "\"post\"\n" +
            more,
        "Point(1) = {0, -3, 0};\nPoint(2) = {20, -3, 0};\nPoint(3) = {20, 3, 0};\nPoint(4) = {0, 3, 0};\nLine(1) = "
        "{1, 2};\nLine(2) = {2, 3};\nLine(3) = {3, 4};\nLine(4) = {4, 1};\nPoint(5) = {7, 0.3, 0};\nPoint(6) = "
        "{8.2, 0.3, 0};\nPoint(7) = {7, 1.5, 0};\nPoint(8) = {5.8, 0.3, 0};\nPoint(9) = {7, -0.9, 0};\nCircle(5) = "
        "{6, 5, 7};\nCircle(6) = {7, 5, 8};\nCircle(7) = {8, 5, 9};\nCircle(8) = {9, 5, 6};\nPoint(15) = {10, 0, "
        "0};\nPoint(16) = {10.6, 0, 0};\nPoint(17) = {10, 0.6, 0};\nPoint(18) = {9.4, 0, 0};\nPoint(19) = {10, "
        "-0.6, 0};\nCircle(15) = {16, 15, 17};\nCircle(16) = {17, 15, 18};\nCircle(17) = {18, 15, 19};\nCircle(18) = "
        "{19, 15, 16};\nCurve Loop(1) = {1, 2, 3, 4};\nCurve Loop(2) = {5, 6, 7, 8};\nCurve Loop(3) = {15, 16, 17, "
        "18};\nPlane Surface(1) = {1, 2, 3};\nPlane Surface(2) = {2};\nPhysical Surface(\"blood\") = {1};\nPhysical "
        "Surface(\"embolus\") = {2};\nPhysical Curve(\"wall\") = {1, 3};\nPhysical Curve(\"post\") = {15, 16, 17, "
        "18};\n"};
}

TEST(SurfaceContact, stops_what_a_flow_carries_against_a_post_whatever_its_stiffness) {
    struct Case {
        std::string modulus;
        double speed;
        std::string more;
    };
    const std::string implicit = "[numerics]\nviscosity_stepping = \"implicit\"\n";
    for (const Case& each : {Case{"1 kPa", 0.05, ""}, Case{"10 kPa", 0.05, ""}, Case{"100 kPa", 0.05, implicit},
                             Case{"100 kPa", 0.5, ""}, Case{"10 kPa", 0.5, implicit}}) {
        const Ran ran = run(embolus_at_post(each.modulus, each.speed, each.more));
        ASSERT_TRUE(ran.summary.contact);
        EXPECT_GT(ran.summary.contact->depth, 0) << each.modulus;
        EXPECT_LT(ran.summary.contact->depth, 0.1 * 0.3e-3) << each.modulus << " " << each.speed << each.more;
        EXPECT_LT(ran.summary.momentum_residual, 1e-12) << each.modulus << " " << each.speed << each.more;
        const auto column = [&](const std::string& name) {
            const auto found = std::ranges::find(ran.summary.measures.names, name);
            double largest = 0;
            for (const auto& row : ran.summary.measures.rows)
                largest = std::max(
                    largest, std::abs(row.at(static_cast<std::size_t>(found - ran.summary.measures.names.begin()))));
            return largest;
        };
        EXPECT_GT(column("hit_area"), 0.05e-3);
        EXPECT_GT(column("hit_force_x"), 0);
    }
}

/// The flat end of a bar that lands, tilted, beside a corner: nothing on top faces it, and the block's side, which
/// does, is 0.8 spacings behind it.
TEST(SurfaceContact, does_not_throw_an_end_that_lands_beside_a_corner) {
    const std::string solid =
        "kind = \"elastic\"\ndensity = \"1000 kg/m^3\"\nyoungs_modulus = \"1 MPa\"\npoisson_ratio = 0.25\n";
    const Ran ran =
        run({"schema = 1\ntitle = \"end\"\ndimension = 2\n[geometry]\nfile = \"channel.geo\"\nunit = \"1 "
             "mm\"\n[particles]\nspacing = \"0.25 mm\"\n[[part]]\nname = \"block\"\n" +
                 solid + "[[part]]\nname = \"bar\"\ninitial_velocity = [0, \"-0.2 m/s\"]\n" + solid +
                 "[contact]\nstiffness = \"3e8 Pa/m\"\n[flow]\nlargest_speed = \"0.5 m/s\"\n[run]\nduration = \"2 "
                 "ms\"\n[output]\nevery = \"2 ms\"\n[[measure]]\nname = \"b\"\nkind = \"body\"\npart = \"bar\"\n",
             "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 3, 3};\nRectangle(2) = {-2.8, 3.03, 0, 3, "
             "0.5};\nRotate{ {0, 0, 1}, {0.2, 3.03, 0}, -5 * Pi / 180 } { Surface{2}; }\nPhysical Surface(\"block\") = "
             "{1};\nPhysical Surface(\"bar\") = {2};\n"});
    ASSERT_TRUE(ran.summary.contact);
    EXPECT_LT(ran.summary.contact->depth, 0.1 * 0.25e-3);
    EXPECT_LT(std::abs(ran.last("b_velocity_x")), 0.003);  // before it was 0.031
}

/// Leaflets of stiff springs that close: the equations of contact are far from linear.
TEST(SurfaceContact, finds_the_forces_between_leaflets_that_close) {
    const auto meshed = [](const std::vector<std::string>& embolus) {
        std::vector<std::string> keys{"particles.spacing=\"0.8 mm\"",
                                      "geometry.parameters.half_width=\"4.8 mm\"",
                                      "geometry.parameters.root_inset=\"0.44 mm\"",
                                      "geometry.parameters.tip_gap=\"2.72 mm\"",
                                      "geometry.parameters.shell=\"2.4 mm\"",
                                      "geometry.parameters.casing=\"12.4 mm\"",
                                      "run.duration=\"0.2 s\""};
        keys.insert(keys.end(), embolus.begin(), embolus.end());
        return mesh_case("double_vein_valve/published_scene.toml", keys);
    };
    for (const Meshed& valve :
         {meshed({"geometry.parameters.embolus_length=\"5.9 mm\"", "geometry.parameters.embolus_height=\"2.6 mm\"",
                  "geometry.parameters.embolus_x=\"-8 mm\"", "geometry.parameters.embolus_y=\"4.3 mm\""}),
          meshed({"geometry.parameters.embolus_length=\"7.8 mm\"", "geometry.parameters.embolus_height=\"7.8 mm\"",
                  "part.embolus.youngs_modulus=\"3.75 kPa\""})}) {
        const RunSummary summary = Simulation(valve.scene, valve.particles, Resources(1)).run({});
        EXPECT_TRUE(std::ranges::none_of(summary.warnings,
                                         [](const auto& warning) { return warning.key == "contact.between"; }));
        ASSERT_TRUE(summary.contact);
        EXPECT_LT(summary.contact->depth, 0.02 * 0.8e-3);
    }
}

/// Hertz 1882; Johnson 1985, section 4.2: a cylinder on a plane, of the same material, half as wide as
/// b = (4 P R / (pi E*))^1/2, E* = E / (2 (1 - nu^2)), with the pressure 2 P / (pi b) in the middle.
TEST(SurfaceContact, is_as_wide_and_presses_as_hertz_says) {
    const std::string solid =
        "kind = \"elastic\"\ndensity = \"1000 kg/m^3\"\nyoungs_modulus = \"1 MPa\"\npoisson_ratio = "
        "0.25\nmass_damping = \"1000 1/s\"\n";
    const double load = 50, radius = 5e-3, modulus = 1e6 / (2 * (1 - 0.25 * 0.25));
    const Ran ran =
        run({"schema = 1\ntitle = \"Hertz\"\ndimension = 2\n[geometry]\nfile = \"channel.geo\"\nunit = \"1 "
             "mm\"\n[particles]\nspacing = \"0.5 mm\"\n[[part]]\nname = \"cylinder\"\n" +
                 solid + "[[part]]\nname = \"block\"\nanchor = \"held\"\n" + solid +
                 "[flow]\nlargest_speed = \"0.1 m/s\"\n[[force]]\nname = \"press\"\npart = "
                 "\"cylinder\"\namount = \"total\"\nforce = [0, \"-50 N\"]\n[run]\nduration = \"15 "
                 "ms\"\n[output]\nevery = \"5 ms\"\n[[measure]]\nname = \"c\"\nkind = \"contact\"\npart = "
                 "\"cylinder\"\n",
             "SetFactory(\"OpenCASCADE\");\nDisk(1) = {0, 5, 0, 5, 5};\nRectangle(2) = {-12, -12, 0, 24, "
             "12};\nPhysical Surface(\"cylinder\") = {1};\nPhysical Surface(\"block\") = {2};\nPhysical "
             "Curve(\"held\") = {2};\n"});
    const double half = std::sqrt(4 * load * radius / (std::numbers::pi * modulus));
    EXPECT_NEAR(ran.last("c_force_y"), load, 0.002 * load);
    EXPECT_NEAR(ran.last("c_area"), 2 * half, 0.05 * 2 * half);
    EXPECT_NEAR(ran.last("c_pressure"), 2 * load / (std::numbers::pi * half),
                0.05 * 2 * load / (std::numbers::pi * half));
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
    EXPECT_THAT(
        fault_of(Slide{.friction = 0.3, .more = "between = \"particles\"\n", .measures_contact = false}.texts()),
        HasSubstr("contact.friction is of surfaces"));
    EXPECT_THAT(fault_of(Slide{.more = "stiffness = \"-1 Pa/m\"\n"}.texts()), HasSubstr("stiffness"));
    EXPECT_THAT(fault_of(Slide{.more = "between = \"nothing\"\n"}.texts()), HasSubstr("'surfaces'"));
    const std::string measure = "[[measure]]\nname = \"c\"\nkind = \"contact\"\npart = \"block\"\n";
    EXPECT_THAT(fault_of(Slide{.more = measure + "against = \"flor\"\n", .measures_contact = false}.texts()),
                HasSubstr("no elastic or rigid part 'flor'"));
    EXPECT_THAT(fault_of(Slide{.more = "between = \"particles\"\n" + measure, .measures_contact = false}.texts()),
                HasSubstr("is of contact between surfaces"));
}

}  // namespace
}  // namespace dmp::tests::solver_surface_contact_tests
