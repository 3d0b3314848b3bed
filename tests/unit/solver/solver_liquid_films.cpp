// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Films of liquid between surfaces that are nearer than particles resolve.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "solver/contact/liquid_film.hpp"
#include "solver/implicit/contact_preconditioner.hpp"
#include "solver/simulation.hpp"
#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"

namespace dmp::tests::solver_liquid_films_tests {
namespace {

constexpr double viscosity = 0.1;

TEST(LiquidFilmLaw, flows_by_the_cube_of_its_thickness) {
    const LiquidFilmLaw law{viscosity, 1e-3};
    EXPECT_DOUBLE_EQ(law.conductance(0.5e-3), 0.125e-9 / (12 * viscosity));
    EXPECT_DOUBLE_EQ(law.drag(0.5e-3), viscosity * (2000 - 1000));
    EXPECT_DOUBLE_EQ(law.drag(1e-3), 0);
    EXPECT_DOUBLE_EQ(law.thickness(-1e-5), 0.02e-3);  // what touches keeps a film
}

/// Integral over [0, end] by Simpson's rule.
template <class Function>
double integral(double end, const Function& of) {
    constexpr int steps = 4000;
    double sum = of(0.0) + of(end);
    for (int k = 1; k < steps; ++k) sum += (k % 2 == 1 ? 4 : 2) * of(end * k / steps);
    return sum * end / (3 * steps);
}

/// A disc, or a ball, of 2 mm above a floor at the height 0, in particles of 0.2 mm.
Texts above_floor(int dimension, double gap) {
    const std::string at = std::to_string(2 + 1e3 * gap);
    const std::string parts =
        "[[part]]\nname = \"water\"\nkind = \"fluid\"\ndensity = \"1000 kg/m^3\"\nviscosity = \"0.1 "
        "Pa*s\"\n[[part]]\nname = \"body\"\nkind = \"elastic\"\nmodel = \"cells\"\ndensity = \"1000 "
        "kg/m^3\"\nyoungs_modulus = \"1 MPa\"\npoisson_ratio = 0.25\n[[part]]\nname = \"floor\"\nkind = \"rigid\"\n";
    const std::string head = "schema = 1\ntitle = \"film\"\ndimension = " + std::to_string(dimension) +
                             "\n[geometry]\nfile = \"channel.geo\"\nunit = \"1 mm\"\n[particles]\nspacing = \"" +
                             (dimension == 2 ? "0.2" : "0.4") + " mm\"\n" + parts;
    const std::string flow = "[run]\nduration = \"1 ms\"\n[output]\nevery = \"1 ms\"\n";
    if (dimension == 2)
        return {
            head + "[flow]\nperiodic = [\"x\"]\nlargest_speed = \"10 mm/s\"\nlargest_pressure = \"200 Pa\"\n" + flow,
            "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {-8, 0, 0, 16, 12};\nDisk(2) = {0, " + at +
                ", 0, 2, 2};\nBooleanFragments{ Surface{1}; Delete; }{ Surface{2}; Delete; }\nbody() = Surface In "
                "BoundingBox{-2.1, -0.1, -1, 2.1, 6, 1};\nall() = Surface{:};\nall() -= body();\nfloor() = Curve "
                "In BoundingBox{-8.1, -0.1, -1, 8.1, 0.1, 1};\nfloor() += Curve In BoundingBox{-8.1, 11.9, -1, "
                "8.1, 12.1, 1};\nPhysical Surface(\"water\") = all();\nPhysical Surface(\"body\") = "
                "body();\nPhysical Curve(\"floor\") = floor();\nMesh.MeshSizeMax = 0.1;\n"};
    return {head + "[flow]\nperiodic = [\"x\", \"y\"]\nlargest_speed = \"10 mm/s\"\n" + flow,
            "SetFactory(\"OpenCASCADE\");\nBox(1) = {-3, -3, 0, 6, 6, 6};\nSphere(2) = {0, 0, " + at +
                ", 2};\nBooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; };\nBox(4) = {-3, -3, -2, 6, 6, "
                "2};\nBox(5) = {-3, -3, 6, 6, 6, 2};\nPhysical Volume(\"water\") = {3};\nPhysical Volume(\"body\") = "
                "{2};\nPhysical Volume(\"floor\") = {4, 5};\nMesh.MeshSizeMax = 0.3;\n"};
}

/// The film on the body's own surface, in front of the floor.
class FilmOnBody {
  public:
    FilmOnBody(int dimension, double gap) : FilmOnBody(above_floor(dimension, gap), dimension) {}
    FilmOnBody(const Texts& texts, int dimension)
        : meshed_(mesh_texts(texts)),
          bodies_(meshed_.particles, meshed_.scene, alone_),
          surfaces_(meshed_.particles, bodies_),
          film_({viscosity, meshed_.particles.spacing}, surfaces_) {
        const Vec up = Vec::Unit(dimension - 1);
        std::vector<LiquidFilm::Point> points;
        for (std::size_t k = 0; k < surfaces_.pieces().size(); ++k)
            for (std::size_t p = 0; p < surfaces_.points().size(); ++p) {
                const auto& piece = surfaces_.pieces()[k];
                const double above = piece.now.at(surfaces_.points()[p].place).dot(up);
                if (piece.is_wall || piece.weight[p] == 0 || above > film_.law().thickest) continue;
                points.push_back({static_cast<int>(k), p, above, up});
                weights_.push_back(piece.weight[p]);
            }
        film_.find(std::move(points));
    }

    [[nodiscard]] Vec force(const Vec& velocity) const {
        const std::vector<Vec> past(weights_.size(), velocity);
        Vec force = Vec::Zero();
        const auto tractions = film_.tractions(past);
        for (std::size_t k = 0; k < weights_.size(); ++k)
            force += weights_[k] * (tractions[k].normal + tractions[k].tangential);
        return force;
    }
    /// Of tractions by `past` with velocities `with` [W].
    [[nodiscard]] double power(const std::vector<Vec>& past, const std::vector<Vec>& with) const {
        const auto tractions = film_.tractions(past);
        double power = 0;
        for (std::size_t k = 0; k < weights_.size(); ++k)
            power += weights_[k] * (tractions[k].normal + tractions[k].tangential).dot(with[k]);
        return power;
    }
    [[nodiscard]] std::vector<Vec> some_velocities(double seed) const {
        std::vector<Vec> some;
        for (std::size_t k = 0; k < weights_.size(); ++k) {
            const auto x = static_cast<double>(k);
            some.emplace_back(std::sin(seed * x), std::cos(1.3 * seed * x), std::sin(0.7 * seed * x + 1));
        }
        return some;
    }
    [[nodiscard]] double thickest() const { return film_.law().thickest; }

  private:
    Meshed meshed_;
    Ranks alone_ = Ranks::alone();
    SpringBodies bodies_;
    ContactSurfaces surfaces_;
    LiquidFilm film_;
    std::vector<double> weights_;
};

constexpr double radius = 2e-3;
double below_disc(double gap, double x) { return gap + radius - std::sqrt(radius * radius - x * x); }
/// How far a film under a disc that is not thicker than `thickest` reaches [m].
double half_width(double gap, double thickest) {
    const double depth = radius - (thickest - gap);
    return std::sqrt(radius * radius - depth * depth);
}

/// h^3 p' = -12 mu V x below a disc that sinks with V, p = 0 at the film's ends.
TEST(LiquidFilm, holds_a_disc_that_sinks) {
    for (const double gap : {0.1e-3, 0.06e-3, 0.02e-3}) {
        const FilmOnBody film(2, gap);
        const double speed = 1e-3;
        const double exact = 2 * integral(half_width(gap, film.thickest()), [&](double x) {
                                 return 12 * viscosity * speed * x * x / std::pow(below_disc(gap, x), 3);
                             });
        const Vec force = film.force({0, -speed, 0});
        EXPECT_NEAR(force[1], exact, 0.03 * exact) << gap;
        EXPECT_NEAR(force[0], 0, 0.01 * exact);
    }
}

/// Cut by a plane of symmetry.
TEST(LiquidFilm, holds_half_a_disc_by_half_the_force) {
    const double gap = 0.06e-3, speed = 1e-3;
    const Texts half =
        above_floor(2, gap)
            .with("periodic = [\"x\"]", "symmetry = [\"x_low\", \"x_high\"]")
            .with("Rectangle(1) = {-8, 0, 0, 16, 12}", "Rectangle(1) = {0, 0, 0, 8, 12}")
            .with("BooleanFragments{",
                  "Rectangle(3) = {-8, 0, 0, 8, 12};\nBooleanDifference(4) = { "
                  "Surface{2}; Delete; }{ Surface{3}; Delete; };\nBooleanFragments{")
            .with("Surface{1}; Delete; }{ Surface{2}; Delete; }", "Surface{1}; Delete; }{ Surface{4}; Delete; }");
    const Vec of_half = FilmOnBody(half, 2).force({0, -speed, 0}), of_whole = FilmOnBody(2, gap).force({0, -speed, 0});
    EXPECT_NEAR(of_half[1], 0.5 * of_whole[1], 0.01 * of_whole[1]);
}

/// Beside it, as it slides with U: p' = -6 mu U / h^2 + C / h^3, and the stress is -mu U (1/h - 1/h_0) + h p' / 2.
TEST(LiquidFilm, drags_a_disc_that_slides) {
    const double gap = 0.06e-3, speed = 1e-3;
    const FilmOnBody film(2, gap);
    const double end = half_width(gap, film.thickest());
    const auto h = [&](double x) { return below_disc(gap, x); };
    const double squares = integral(end, [&](double x) { return 1 / (h(x) * h(x)); });
    const double cubes = integral(end, [&](double x) { return 1 / std::pow(h(x), 3); });
    const double constant = 6 * viscosity * speed * squares / cubes;
    const double exact = 2 * integral(end, [&](double x) {
                             const double slope = -6 * viscosity * speed / (h(x) * h(x)) + constant / std::pow(h(x), 3);
                             return -viscosity * speed * (1 / h(x) - 1 / film.thickest()) + 0.5 * h(x) * slope;
                         });
    const Vec force = film.force({speed, 0, 0});
    EXPECT_NEAR(force[0], exact, 0.05 * std::abs(exact));
    EXPECT_NEAR(force[1], 0, 0.02 * std::abs(exact));
}

/// h^3 p' = -6 mu V r below a ball.
TEST(LiquidFilm, holds_a_ball_that_sinks) {
    const double gap = 0.12e-3, speed = 1e-3;
    const FilmOnBody film(3, gap);
    const double exact = integral(half_width(gap, film.thickest()), [&](double r) {
        return 6 * std::numbers::pi * viscosity * speed * r * r * r / std::pow(below_disc(gap, r), 3);
    });
    const Vec force = film.force({0, 0, -speed});
    EXPECT_NEAR(force[2], exact, 0.12 * exact);  // triangles of 0.75 spacings, a film 2.5 across
    EXPECT_NEAR(force.head<2>().norm(), 0, 0.02 * exact);
}

TEST(LiquidFilm, only_takes_energy_by_a_symmetric_drag) {
    for (const int dimension : {2, 3}) {
        const FilmOnBody film(dimension, 0.05e-3);
        const std::vector<Vec> a = film.some_velocities(0.9), b = film.some_velocities(2.1);
        const double of_both = film.power(a, b);
        EXPECT_NEAR(film.power(b, a), of_both, 1e-9 * std::abs(film.power(a, a)));
        EXPECT_LT(film.power(a, a), 0);
        EXPECT_LT(film.power(b, b), 0);
    }
}

/// The speed of a cylinder that a force F drives towards a plane, in Stokes flow (Jeffrey & Onishi 1981):
/// F = 4 pi mu V / (a - tanh a), cosh a = 1 + gap / R.
TEST(LiquidFilm, lets_a_disc_sink_onto_a_floor_as_fast_as_stokes_flow) {
    constexpr double load = 53.5e-3, spacing = 0.4e-3;
    const Texts texts = above_floor(2, 1.6e-3)
                            .with("0.2 mm", "0.4 mm")
                            .with("duration = \"1 ms\"", "duration = \"0.5 s\"")
                            .with("every = \"1 ms\"", "every = \"0.25 s\"\nmeasure_every = \"1 ms\"");
    const Meshed meshed = mesh_texts(
        {texts.scene + "[[force]]\nname = \"push\"\npart = \"body\"\namount = \"total\"\nforce = [0, \"-53.5 "
                       "mN\"]\n[[measure]]\nname = \"b\"\nkind = \"body\"\npart = \"body\"\n",
         texts.cad_geometry});
    const RunSummary summary = Simulation(meshed.scene, meshed.particles, Resources(1)).run({});
    EXPECT_LT(summary.momentum_residual, 1e-12);
    const auto& rows = summary.measures.rows;
    const auto column =
        static_cast<std::size_t>(std::ranges::find(summary.measures.names, "b_y") - summary.measures.names.begin());
    ASSERT_LT(column, summary.measures.names.size());
    const auto gap = [&](std::size_t row) { return rows[row].at(column) - radius; };
    const auto time_at = [&](double wanted) {
        std::size_t row = 1;
        while (row < rows.size() && gap(row) > wanted) ++row;
        if (row == rows.size()) return std::numeric_limits<double>::infinity();
        const auto& time = summary.measures.time;
        return time[row] - (wanted - gap(row)) / (gap(row - 1) - gap(row)) * (time[row] - time[row - 1]);
    };
    const auto resistance = [](double at) {
        const double a = std::acosh(1 + at / radius);
        return 4 * std::numbers::pi * viscosity / (a - std::tanh(a));
    };
    for (const double at : {0.7, 0.5, 0.3}) {
        const double low = 0.8 * at * spacing, high = 1.2 * at * spacing;
        const double exact = integral(high - low, [&](double x) { return resistance(low + x) / load; });
        EXPECT_NEAR(time_at(low) - time_at(high), exact, 0.25 * exact) << at;
    }
}

/// A body that sinks into the floor with its lowest points, and has a film around them.
TEST(ContactPreconditioner, solves_what_conjugate_gradients_multiply) {
    for (const int dimension : {2, 3}) {
        constexpr double dt = 1e-4;
        const Meshed meshed = mesh_texts(above_floor(dimension, 1e-6));
        const Ranks alone = Ranks::alone();
        SpringBodies bodies(meshed.particles, meshed.scene, alone);
        ParticleStore particles(meshed.particles, {1000, 1000, 1000});
        WallMotion walls(meshed.scene, meshed.particles, particles);
        SurfaceContact contact(meshed.scene, meshed.particles, bodies, dt, viscosity, 1);
        SpringBody& body = *bodies.bodies()[0];
        const std::vector<Vec> sinking(body.unknowns(), -0.05 * Vec::Unit(dimension - 1));
        ASSERT_TRUE(contact.may_touch(bodies, walls, 0, dt));
        std::vector<Vec> force(body.unknowns(), Vec::Zero());
        contact.add_forces_at_end(sinking, force);
        EXPECT_TRUE(std::ranges::any_of(force, [](const Vec& on) { return on.norm() > 0; }));
        body.prepare_alone(sinking, dt, true);
        ContactPreconditioner preconditioner;
        preconditioner.factorise(bodies, contact);

        std::vector<Vec> values, image;
        for (std::size_t n = 0; n < body.unknowns(); ++n) {
            const auto x = static_cast<double>(n);
            values.emplace_back(std::sin(x), std::cos(1.7 * x), dimension == 3 ? std::sin(0.3 * x) : 0);
        }
        image = values;
        body.multiply_in_fluid(image);
        const std::vector<Vec> of_body = image;
        contact.add_stiffness_times(values, image);
        double added = 0, most = 0;
        for (std::size_t n = 0; n < image.size(); ++n) {
            added = std::max(added, (image[n] - of_body[n]).norm());
            most = std::max(most, of_body[n].norm());
        }
        EXPECT_GT(added, most);
        preconditioner.solve(image);
        for (std::size_t n = 0; n < image.size(); ++n) EXPECT_LT((image[n] - values[n]).norm(), 1e-8) << n;
    }
}

/// A disc that nearly touches the floor.
TEST(LiquidFilm, is_solved_with_implicit_viscosity) {
    const Texts texts = above_floor(2, 2e-6)
                            .with("0.2 mm", "0.4 mm")
                            .with("largest_pressure", "acceleration = [0, \"-9.81 m/s^2\"]\nlargest_pressure")
                            .with("duration = \"1 ms\"", "duration = \"20 ms\"");
    const Meshed meshed =
        mesh_texts({texts.scene + "[numerics]\nviscosity_stepping = \"implicit\"\n", texts.cad_geometry});
    const RunSummary summary = Simulation(meshed.scene, meshed.particles, Resources(1)).run({});
    EXPECT_LT(summary.viscous_solves.most_iterations, 60);
    EXPECT_LT(summary.momentum_residual, 1e-12);
}

}  // namespace
}  // namespace dmp::tests::solver_liquid_films_tests
