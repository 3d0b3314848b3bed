// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/surface_traction.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <functional>

#include "solver/output/fluid_fields.hpp"
#include "solver/output/linear_fit.hpp"
#include "solver/output/point_grid.hpp"

namespace dmp::solver {

namespace {

constexpr double fluid_reach = 4;      ///< R, in spacings
constexpr double nearest_fluid = 1.5;  ///< farther from a surface than this, in spacings, fluid is not beside it

/// Two directions across a normal; in 2-D one, and z.
std::array<Vec, 2> across(const Vec& normal, int dimension) {
    if (dimension == 2) return {Vec(-normal[1], normal[0], 0), Vec::UnitZ()};
    Eigen::Index least = 0;
    normal.cwiseAbs().minCoeff(&least);
    const Vec first = normal.cross(Vec::Unit(least)).normalized();
    return {first, normal.cross(first)};
}

/// A place itself, and its images behind the planes of symmetry.
std::vector<std::function<Vec(const Vec&)>> images(const ParticleSpace& space) {
    std::vector<std::function<Vec(const Vec&)>> images{[](const Vec& place) { return place; }};
    for (int axis = 0; axis < space.dimension; ++axis)
        for (const auto& [side, plane] : {std::pair(std::size_t{0}, space.box.low[axis]), {1, space.box.high[axis]}})
            if (space.mirrored[static_cast<std::size_t>(axis)][side])
                images.emplace_back([axis, plane](const Vec& place) {
                    Vec image = place;
                    image[axis] = 2 * plane - place[axis];
                    return image;
                });
    return images;
}

/// Whether one of these points, given from a surface, stands between the surface and x.
bool is_hidden(const Vec& x, const std::vector<Vec>& points, double spacing) {
    return std::ranges::any_of(points, [&](const Vec& point) {
        const double along = point.dot(x) / x.squaredNorm();
        return along > 0 && along < 1 && (point - along * x).norm() < spacing / 2;
    });
}

/// Outward normals of a body's particles now; 0 of those without a surface.
std::vector<Vec> surface_normals(const SpringBody& body, const ParticleSpace& space) {
    constexpr double reach = 1.6;     // spacings: more than the diagonal of a square, less than two
    constexpr double shortest = 0.5;  // of the sum that shows a surface: 2.4 at a flat face of a square lattice
    std::vector<Vec> at_rest(body.nodes());
    for (std::size_t node = 0; node < body.nodes(); ++node) at_rest[node] = body.rest_position(node);
    const PointGrid grid(space, reach * space.spacing, at_rest);
    const auto all_images = images(space);
    std::vector<Vec> normals(body.nodes(), Vec::Zero());
    for (std::size_t node = 0; node < body.nodes(); ++node) {
        Vec inwards = Vec::Zero();
        for (const auto& image_of : all_images)
            grid.for_each_near(image_of(at_rest[node]), [&](std::size_t other, const Vec&) {
                const Vec apart = nearest_image(image_of(body.position(other)) - body.position(node), space);
                if (apart.norm() > 1e-6 * space.spacing) inwards += apart.normalized();
            });
        if (inwards.norm() > shortest) normals[node] = -inwards.normalized();
    }
    return normals;
}

}  // namespace

SurfaceTraction::SurfaceTraction(const ParticleStore& particles, const SpringBodies& springs, const Ranks& ranks)
    : space_(particles.space()) {
    std::vector<Vec> nodes;
    for (const auto& body : springs.bodies())
        for (std::size_t node = 0; node < body->nodes(); ++node) nodes.push_back(body->position(node));
    // A particle's surface is half a spacing outside of it.
    const PointGrid grid(space_, (fluid_reach + 0.5) * space_.spacing, std::move(nodes));
    const ParticleGroup& fluid = particles.fluid();
    std::vector<Sample> own;
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        const Vec place = shown_place(fluid, space_, i);
        if (!grid.any_near(place)) continue;
        Sample sample{};
        std::copy_n(place.data(), 3, sample.position.begin());
        for (int axis = 0; axis < space_.dimension; ++axis) {
            const double velocity = fluid.data(Field::velocity, axis)[i];
            sample.velocity[static_cast<std::size_t>(axis)] =
                is_shown_mirrored(fluid, space_, axis, i) ? -velocity : velocity;
        }
        sample.id = fluid.tags()[i].id;
        sample.volume = fluid.data(Field::volume)[i];
        sample.pressure = fluid.data(Field::pressure)[i];
        sample.viscosity = fluid.data(Field::viscosity)[i];
        own.push_back(sample);
    }
    samples_ = ranks.gather_to_first(own);
    std::ranges::sort(samples_, {}, &Sample::id);
}

std::vector<std::vector<std::optional<Vec>>> SurfaceTraction::on(const SpringBodies& springs) const {
    std::vector<Vec> places, nodes;
    for (const Sample& sample : samples_) places.emplace_back(sample.position.data());
    for (const auto& body : springs.bodies())
        for (std::size_t node = 0; node < body->nodes(); ++node) nodes.push_back(body->position(node));
    const double reach = fluid_reach * space_.spacing;
    const PointGrid fluid(space_, reach, std::move(places)), solids(space_, reach, std::move(nodes));
    std::vector<std::vector<std::optional<Vec>>> tractions;
    for (const auto& body : springs.bodies()) {
        const std::vector<Vec> normals = surface_normals(*body, space_);
        auto& of_body = tractions.emplace_back(body->nodes());
        for (std::size_t node = 0; node < body->nodes(); ++node) {
            const Vec& normal = normals[node];
            if (normal.isZero(0) || body->of_wall(node)) continue;
            const Vec half = space_.spacing / 2 * normal, surface = body->position(node) + half;
            std::vector<Vec> before;  // particles of solids in front of the surface
            solids.for_each_near(surface, [&](std::size_t, const Vec& x) {
                if (x.dot(normal) > 0) before.push_back(x);
            });
            std::vector<Near> near;
            double nearest = reach;
            fluid.for_each_near(surface, [&](std::size_t k, const Vec& x) {
                if ((x + half).dot(normal) <= 0 || is_hidden(x, before, space_.spacing)) return;
                near.push_back({&samples_[k], x, samples_[k].volume * std::pow(1 - x.norm() / reach, 2)});
                nearest = std::min(nearest, x.norm());
            });
            if (nearest < nearest_fluid * space_.spacing) of_body[node] = traction(near, normal);
        }
    }
    return tractions;
}

Vec SurfaceTraction::traction(const std::vector<Near>& near, const Vec& normal) const {
    LinearFit fit;
    for (const auto& [sample, x, weight] : near) fit.add(x, weight);
    fit.finish(Ranks::alone(), space_.spacing);
    double pressure = 0, viscosity = 0, weights = 0;
    for (const auto& [sample, x, weight] : near) {
        pressure += fit.share(x, weight) * sample->pressure;
        viscosity += weight * sample->viscosity;
        weights += weight;
    }
    viscosity /= weights;
    const Eigen::Matrix3d gradient = velocity_gradient(near, normal);
    return viscosity * (gradient + gradient.transpose()) * normal - pressure * normal;
}

Eigen::Matrix3d SurfaceTraction::velocity_gradient(const std::vector<Near>& near, const Vec& normal) const {
    // In reaches: v = a + c s + b_1 t_1 (+ b_2 t_2) + d s^2, s along the normal and t across it.
    const double reach = fluid_reach * space_.spacing;
    const auto [first, second] = across(normal, space_.dimension);
    const auto rows = static_cast<Eigen::Index>(near.size());
    const Eigen::Index last = space_.dimension + 1;
    Eigen::MatrixXd basis(rows, last + 1), velocity(rows, 3);
    for (Eigen::Index row = 0; row < rows; ++row) {
        const auto& [sample, x, weight] = near[static_cast<std::size_t>(row)];
        const double s = x.dot(normal) / reach, root = std::sqrt(weight / near.front().weight);
        basis(row, 0) = root;
        basis(row, 1) = root * s;
        basis(row, 2) = root * x.dot(first) / reach;
        if (space_.dimension == 3) basis(row, 3) = root * x.dot(second) / reach;
        basis(row, last) = root * s * s;
        velocity.row(row) = root * Eigen::Map<const Eigen::RowVector3d>(sample->velocity.data());
    }
    constexpr double undetermined = 0.01;  // of the largest pivot; s^2 of two rows of fluid is below it
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(undetermined);
    solver.compute(basis);
    if (solver.rank() <= last) solver.compute(basis.leftCols(last));
    const Eigen::MatrixXd fitted = solver.solve(velocity) / reach;
    Eigen::Matrix3d gradient = fitted.row(1).transpose() * normal.transpose();  // at the surface, s = 0
    gradient += fitted.row(2).transpose() * first.transpose();
    if (space_.dimension == 3) gradient += fitted.row(3).transpose() * second.transpose();
    return gradient;
}

}  // namespace dmp::solver
