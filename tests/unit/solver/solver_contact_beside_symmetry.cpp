// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact between surfaces beside planes of symmetry: half a scene, or a quarter, does what the whole one does.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "solver/contact/contact_surfaces.hpp"
#include "solver/simulation.hpp"
#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"

namespace dmp::tests::solver_contact_beside_symmetry_tests {
namespace {

RunSummary run(const Texts& texts) {
    const Meshed meshed = mesh_texts(texts);
    return Simulation(meshed.scene, meshed.particles, Resources(1)).run({});
}

std::vector<double> column(const RunSummary& summary, const std::string& name) {
    const auto found = std::ranges::find(summary.measures.names, name);
    if (found == summary.measures.names.end()) throw std::logic_error("no column " + name);
    std::vector<double> values;
    for (const auto& row : summary.measures.rows)
        values.push_back(row.at(static_cast<std::size_t>(found - summary.measures.names.begin())));
    return values;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// `part`, this share of `whole`, leaves the floor as fast, by this share of the impulse.
void expect_same_bounce(const RunSummary& part, double share, const RunSummary& whole, const std::string& axis) {
    const double rebound = column(whole, "a_velocity_" + axis).back();
    EXPECT_GT(rebound, 0.15);
    EXPECT_NEAR(column(part, "a_velocity_" + axis).back(), rebound, 0.01 * rebound);
    const double impulse = sum(column(whole, "c_force_" + axis));
    EXPECT_NEAR(sum(column(part, "c_force_" + axis)), share * impulse, 0.01 * share * impulse);
}

/// An empty box with this in it, [m]; what is beyond the planes of symmetry is cut off.
Texts in_empty_box(int dimension, const std::string& symmetry, const std::string& spacing, const std::string& parts,
                   const std::string& cad_geometry) {
    return {"schema = 1\ntitle = \"contact\"\ndimension = " + std::to_string(dimension) +
                "\n[geometry]\nfile = \"channel.geo\"\n[particles]\nspacing = \"" + spacing +
                "\"\n[[part]]\nname = \"space\"\nkind = \"fluid\"\ndensity = \"1000 kg/m^3\"\nviscosity = \"1 "
                "mPa*s\"\nenabled = false\n" +
                parts + "[flow]\nsymmetry = [" + symmetry +
                "]\nlargest_speed = \"0.5 m/s\"\n[run]\nduration = \"12 ms\"\n[output]\nevery = \"12 "
                "ms\"\nmeasure_every = \"0.01 ms\"\n[[measure]]\nname = \"a\"\nkind = \"body\"\npart = "
                "\"a\"\n[[measure]]\nname = \"c\"\nkind = \"contact\"\npart = \"a\"\n",
            "SetFactory(\"OpenCASCADE\");\n" + cad_geometry};
}

std::string body(const std::string& name, const std::string& velocity) {
    return "[[part]]\nname = \"" + name +
           "\"\nkind = \"elastic\"\nmodel = \"cells\"\ndensity = \"1000 kg/m^3\"\nyoungs_modulus = \"1 "
           "MPa\"\npoisson_ratio = 0.25\ninitial_velocity = [" +
           velocity + "]\n";
}

const std::string floor_part = "[[part]]\nname = \"floor\"\nkind = \"rigid\"\n";

/// It is drawn nearer to it than pieces of one body that touch.
TEST(ContactBesideSymmetry, lets_a_disc_meet_its_image) {
    const std::string discs =
        "Rectangle(1) = {LEFT, -0.01, 0, 0.014 - LEFT, 0.02};\nDisk(2) = {0.0055, 0, 0, 0.005};\n";
    const std::string faster = "\"-0.2 m/s\", \"-0.05 m/s\"", slower = "\"0.2 m/s\", \"-0.05 m/s\"";
    const std::string floor =
        "Physical Curve(\"floor\") = Curve In BoundingBox{-0.015, -0.0101, -1, 0.015, -0.0099, 1};\n"
        "Physical Surface(\"a\") = {2};\nPhysical Surface(\"space\") = {4};\n";
    const auto at = [](std::string text, const std::string& left) {
        for (auto found = text.find("LEFT"); found != std::string::npos; found = text.find("LEFT"))
            text.replace(found, 4, left);
        return text;
    };
    const RunSummary two =
        run(in_empty_box(2, "", "0.5 mm", body("a", faster) + body("b", slower) + floor_part,
                         at(discs, "-0.014") +
                             "Disk(3) = {-0.0055, 0, 0, 0.005};\nBooleanDifference(4) = { Surface{1}; Delete; }{ "
                             "Surface{2, 3}; };\nPhysical Surface(\"b\") = {3};\n" +
                             floor));
    const RunSummary one =
        run(in_empty_box(2, "\"x_low\"", "0.5 mm", body("a", faster) + floor_part,
                         at(discs, "0") + "BooleanDifference(4) = { Surface{1}; Delete; }{ Surface{2}; };\n" + floor));
    const double rebound = column(two, "a_velocity_x").back();
    EXPECT_GT(rebound, 0.19);
    EXPECT_NEAR(column(one, "a_velocity_x").back(), rebound, 0.005 * rebound);
    EXPECT_NEAR(column(one, "a_velocity_y").back(), -0.05, 1e-9);  // nothing drags it
    ASSERT_TRUE(one.contact && two.contact);
    EXPECT_NEAR(one.contact->depth, two.contact->depth, 0.1 * two.contact->depth);
    EXPECT_LT(one.momentum_residual, 1e-12);
}

/// Where the disc touches first it is its own image.
TEST(ContactBesideSymmetry, lets_half_a_disc_bounce_like_a_whole_one) {
    const std::string fall = "0, \"-0.2 m/s\"";
    const std::string physical =
        "Physical Surface(\"a\") = {2};\nPhysical Surface(\"space\") = {4};\nPhysical Curve(\"floor\") = Curve In "
        "BoundingBox{-0.015, -0.0001, -1, 0.015, 0.0001, 1};\n";
    const RunSummary whole = run(in_empty_box(
        2, "", "0.5 mm", body("a", fall) + floor_part,
        "Rectangle(1) = {-0.01, 0, 0, 0.02, 0.02};\nDisk(2) = {0, 0.006, 0, 0.005};\nBooleanDifference(4) = { "
        "Surface{1}; Delete; }{ Surface{2}; };\n" +
            physical));
    const RunSummary half = run(in_empty_box(
        2, "\"x_low\"", "0.5 mm", body("a", fall) + floor_part,
        "Rectangle(1) = {0, 0, 0, 0.01, 0.02};\nDisk(3) = {0, 0.006, 0, 0.005};\nBooleanIntersection(2) = { "
        "Surface{1}; }{ Surface{3}; Delete; };\nBooleanDifference(4) = { Surface{1}; Delete; }{ Surface{2}; };\n" +
            physical));
    expect_same_bounce(half, 0.5, whole, "y");
}

/// In space, between two planes of symmetry.
TEST(ContactBesideSymmetry, lets_a_quarter_of_a_ball_bounce_like_a_whole_one) {
    const std::string fall = "0, 0, \"-0.2 m/s\"";
    const std::string ball = "Sphere(3) = {0, 0, 0.0055, 0.005};\n";
    const std::string physical =
        "Physical Volume(\"a\") = {2};\nPhysical Volume(\"space\") = {4};\nPhysical Surface(\"floor\") = Surface In "
        "BoundingBox{-0.015, -0.015, -0.0001, 0.015, 0.015, 0.0001};\nMesh.MeshSizeMax = 0.0008;\n";
    const auto cut = [&](const std::string& box) {
        return box + ball +
               "BooleanIntersection(2) = { Volume{1}; }{ Volume{3}; Delete; };\nBooleanDifference(4) = { Volume{1}; "
               "Delete; }{ Volume{2}; };\n" +
               physical;
    };
    const RunSummary whole = run(in_empty_box(3, "", "1 mm", body("a", fall) + floor_part,
                                              cut("Box(1) = {-0.008, -0.008, 0, 0.016, 0.016, 0.013};\n")));
    const RunSummary quarter = run(in_empty_box(3, "\"x_low\", \"y_high\"", "1 mm", body("a", fall) + floor_part,
                                                cut("Box(1) = {0, -0.008, 0, 0.008, 0.008, 0.013};\n")));
    expect_same_bounce(quarter, 0.25, whole, "z");
}

TEST(ContactBesideSymmetry, has_images_whose_own_points_count_for_nothing) {
    const Meshed meshed = mesh_texts(in_empty_box(
        2, "\"x_low\"", "0.5 mm", body("a", "0, 0") + floor_part,
        "Rectangle(1) = {0, 0, 0, 0.01, 0.02};\nDisk(3) = {0, 0.006, 0, 0.005};\nBooleanIntersection(2) = { "
        "Surface{1}; }{ Surface{3}; Delete; };\nBooleanDifference(4) = { Surface{1}; Delete; }{ Surface{2}; "
        "};\nPhysical Surface(\"a\") = {2};\nPhysical Surface(\"space\") = {4};\nPhysical Curve(\"floor\") = Curve In "
        "BoundingBox{-0.015, -0.0001, -1, 0.015, 0.0001, 1};\n"));
    const Ranks alone = Ranks::alone();
    const SpringBodies bodies(meshed.particles, meshed.scene, alone);
    const ContactSurfaces surfaces(meshed.particles, bodies);
    double length = 0;
    int images = 0;
    for (std::size_t k = 0; k < surfaces.pieces().size(); ++k) {
        const auto& piece = surfaces.pieces()[k];
        if (piece.is_wall) continue;
        for (std::size_t p = 0; p < surfaces.points().size(); ++p) length += piece.weight[p];
        if (surfaces.is_image(static_cast<int>(k))) ++images;
        for (std::size_t c = 0; c < piece.now.controls(); ++c) {
            const auto& of_image = piece.at_rest.control[c];
            const Vec back = piece.reflection.of_point(of_image);
            EXPECT_NEAR(back[1], of_image[1], 1e-15);
            double shares = 0;
            for (const auto& share : surfaces.carriers(piece.control[c])) shares += share.share;
            EXPECT_NEAR(shares, 1, 1e-12);
            EXPECT_FALSE(surfaces.is_border(piece.control[0]));
        }
    }
    EXPECT_GT(images, 10);
    EXPECT_NEAR(length, std::numbers::pi * 0.005, 1e-3 * 0.005);  // half of its outline
}

}  // namespace
}  // namespace dmp::tests::solver_contact_beside_symmetry_tests
