// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "base/vec.hpp"

namespace dmp {

/// A chain of points; closed when the last is joined to the first.
struct Polyline {
    std::vector<Vec> points;
    bool closed = false;

    [[nodiscard]] double length() const;
    /// The point at arc length s in [0, length()] and the unit tangent there.
    [[nodiscard]] std::pair<Vec, Vec> at(double s) const;
};

/// Where a point stands to a region.
enum class Side { outside, on_edge, inside };

/// The nearest point of a set of curves.
struct Projection {
    Vec point = Vec::Zero();
    double distance = 0;
};

/// A named area of a 2-D drawing, bounded by closed polylines (the first need not be the outer one; even-odd rule).
struct Region {
    std::string name;
    std::vector<Polyline> loops;

    [[nodiscard]] double area() const;
    /// Exact: decided with exact predicates on the polyline's doubles, also on edges and corners.
    [[nodiscard]] Side side_of(const Vec& point) const;
};

/// A named set of curves: walls, inlets, leaflets. Each piece is a maximal chain of connected curves.
struct CurveSet {
    std::string name;
    std::vector<Polyline> pieces;

    [[nodiscard]] double length() const;
    [[nodiscard]] Projection nearest(const Vec& point) const;
};

/// A drawing in SI units: named areas, curves and points (gmsh's physical groups).
struct Geometry {
    std::string file;
    int dimension = 2;
    Box box;
    std::vector<Region> regions;
    std::vector<CurveSet> curves;
    std::map<std::string, std::vector<Vec>> points;

    [[nodiscard]] const Region* region(const std::string& name) const;
    [[nodiscard]] const CurveSet* curve_set(const std::string& name) const;
    /// Names of all regions, curve sets and point sets, each once, sorted.
    [[nodiscard]] std::vector<std::string> names() const;
};

struct DrawingOptions {
    std::string file;                          ///< path of the drawing
    double unit = 1.0;                         ///< one unit of the drawing [m]
    std::map<std::string, double> parameters;  ///< DefineConstant name -> value in the drawing's units
    std::map<std::string, Place> parameter_places;  ///< where the scene sets them, for errors
    double chord_error = 1e-6;                 ///< largest distance between a curve and its polyline [m]
    Place place;                               ///< where the scene names the file, for errors
};

/// Reads a 2-D gmsh drawing (.geo, .geo_unrolled, .msh). Throws InputError: unreadable file, gmsh's own error with
/// its line, a parameter the drawing has no DefineConstant for (with the nearest name), a drawing without names.
Geometry read_drawing(const DrawingOptions& options);

}  // namespace dmp
