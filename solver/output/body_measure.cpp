// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/body_measure.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/errors.hpp"
#include "particles/whole_periods.hpp"

namespace dmp::solver {

namespace {

/// The turn that brings X nearest to x (Kabsch 1976), from SUM m x (x) X; in 2-D about z.
Eigen::Matrix3d turn_of(const Eigen::Matrix3d& covariance, int dimension) {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    if (dimension == 2) {
        const double cosine = covariance(0, 0) + covariance(1, 1), sine = covariance(1, 0) - covariance(0, 1);
        if (const double size = std::hypot(cosine, sine); size > 0)
            turn.topLeftCorner<2, 2>() << cosine / size, -sine / size, sine / size, cosine / size;
        return turn;
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    // Of a bar one particle across what turns about its axis is not known: the least turn.
    if (constexpr double one_line = 1e-9; svd.singularValues()[1] < one_line * svd.singularValues()[0]) {
        const Vec before = svd.matrixV().col(0), now = svd.matrixU().col(0);
        return Eigen::Quaterniond::FromTwoVectors(before, now).toRotationMatrix();
    }
    const double side = (svd.matrixU() * svd.matrixV().transpose()).determinant();
    return svd.matrixU() * Eigen::Vector3d(1, 1, side < 0 ? -1 : 1).asDiagonal() * svd.matrixV().transpose();
}

}  // namespace

BodyMeasure::BodyMeasure(const Scene& scene, const Measure& measure, const SpringBodies& springs)
    : dimension_(scene.dimension), has_initial_state_(scene.part_named(measure.part) != nullptr) {
    const auto origin = static_cast<int>(std::ranges::find(springs.names(), *measure.part) - springs.names().begin());
    const auto for_each = [&](const auto& visit) {
        for (const auto& body : springs.bodies())
            for (std::size_t node = 0; node < body->nodes(); ++node)
                if (body->origin(node) == origin && !body->of_wall(node)) visit(*body, node, body->mass(node));
    };
    double mass = 0;
    Vec before = Vec::Zero();
    for_each([&](const SpringBody& body, std::size_t node, double m) {
        mass += m;
        centre_ += m * body.position(node);
        velocity_ += m * body.velocity(node);
        before += m * body.rest_position(node);
    });
    if (mass == 0) return;
    is_there_ = true;
    centre_ /= mass;
    velocity_ /= mass;
    before /= mass;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(), at_rest = covariance, now = covariance;
    for_each([&](const SpringBody& body, std::size_t node, double m) {
        const Vec x = body.position(node) - centre_, at_start = body.rest_position(node) - before;
        covariance += m * (x * at_start.transpose());
        at_rest += m * (at_start * at_start.transpose());
        now += m * (x * x.transpose());
    });
    turn_ = turn_of(covariance, dimension_);
    // Where the body has no extent it counts as unstretched.
    constexpr double tiny = 1e-9;
    const double floor = tiny * std::max(at_rest.trace(), std::numeric_limits<double>::min());
    const Eigen::Matrix3d gradient =
        (covariance + floor * turn_) * (at_rest + floor * Eigen::Matrix3d::Identity()).inverse();
    stretch_ = turn_.transpose() * gradient;
    const Vec axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(now).eigenvectors().col(2);  // ascending
    double low = 0, high = 0;
    for_each([&](const SpringBody& body, std::size_t node, double) {
        const double along = axis.dot(body.position(node) - centre_);
        low = std::min(low, along);
        high = std::max(high, along);
    });
    length_ = high - low;
}

void BodyMeasure::need_ends(const Measure& measure, const ParticleSet& set) {
    const auto named = std::ranges::find(set.parts, *measure.part, [](const auto& part) { return part.name; });
    if (named == set.parts.end()) return;  // a [[solidify]], which has nothing yet
    const auto part = static_cast<int>(named - set.parts.begin());
    const auto is_of_it = [&](int particle) { return set.part[static_cast<std::size_t>(particle)] == part; };
    const bool cells_go_on = std::ranges::any_of(
        set.cells, [&](const SolidCell& cell) { return cell.periods != 0 && is_of_it(cell.particle); });
    const bool bonds_go_on = std::ranges::any_of(set.bonds, [&](const Bond& bond) {
        const Vec apart =
            set.position[static_cast<std::size_t>(bond.b)] - set.position[static_cast<std::size_t>(bond.a)];
        return is_of_it(bond.a) && is_of_it(bond.b) && !periods_to_nearest(apart, set).isZero(0);
    });
    if (cells_go_on || bonds_go_on)
        throw InputError(measure.part.location,
                         "measure '" + *measure.name + "': '" + *measure.part +
                             "' goes on through a periodic side, and has no centre, length or angle as one body",
                         "draw it inside the box; or measure the displacement of a point of it");
}

std::vector<double> BodyMeasure::values(double angle_before) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (!is_there_) return std::vector<double>(4 + 2 * static_cast<std::size_t>(dimension_), none);
    std::vector<double> values;
    for (const Vec& vector : {centre_, velocity_})
        for (int axis = 0; axis < dimension_; ++axis) values.push_back(vector[axis]);
    if (!has_initial_state_) {
        values.insert(values.end(), {none, length_, none, none});
        return values;
    }
    if (dimension_ == 2) {
        const double angle = std::atan2(turn_(1, 0), turn_(0, 0)), whole = 2 * std::numbers::pi;
        const double before = std::isfinite(angle_before) ? angle_before : 0;  // a run that went on may have no row
        values.push_back(angle + whole * std::round((before - angle) / whole));
    } else {
        values.push_back(Eigen::AngleAxisd(turn_).angle());
    }
    values.push_back(length_);
    const Eigen::JacobiSVD<Eigen::MatrixXd> principal(stretch_.topLeftCorner(dimension_, dimension_));
    values.push_back(principal.singularValues()[dimension_ - 1]);
    values.push_back(principal.singularValues()[0]);
    return values;
}

}  // namespace dmp::solver
