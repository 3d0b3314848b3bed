// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/viewpoint.hpp"

#include <Eigen/Geometry>

#include "postproc/axis.hpp"

namespace dmp::postproc {

Box Viewpoint::operator()(const Box& box) const {
    const Vec centre = (*this)((box.low + box.high) / 2);
    const Vec reach = axes.cwiseAbs() * (box.extent() / 2);
    return {centre - reach, centre + reach};
}

Viewpoint along(int right, int up, const Vec& origin) {
    const Vec to_the_right = Vec::Unit(right), upward = Vec::Unit(up);
    Viewpoint view;
    view.axes.row(0) = to_the_right;
    view.axes.row(1) = upward;
    view.axes.row(2) = to_the_right.cross(upward);
    view.origin = origin;
    return view;
}

Viewpoint aslant(const Viewpoint& front) {
    const Vec towards = Vec(0.45, 0.5, 1).normalized();
    const Vec right = Vec::UnitY().cross(towards).normalized();
    Eigen::Matrix3d turn;
    turn.row(0) = right;
    turn.row(1) = towards.cross(right);
    turn.row(2) = towards;
    return {turn * front.axes, front.origin};
}

std::string slice_text(int right, int up, const Vec& origin, double scale) {
    constexpr std::string_view names = "xyz";
    const auto across = static_cast<std::size_t>(3 - right - up);
    return std::string{names[static_cast<std::size_t>(right)]} + " right, " + names[static_cast<std::size_t>(up)] +
           " up, at " + names[across] + " = " + printed_length(origin[static_cast<Eigen::Index>(across)], scale);
}

}  // namespace dmp::postproc
