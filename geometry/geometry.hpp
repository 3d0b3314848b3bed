// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "base/vec.hpp"
#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// A chain of points; closed when the last is joined to the first.
struct Polyline {
    std::vector<Vec> points;
    bool closed = false;

    [[nodiscard]] double length() const;
    /// The point at arc length s in [0, length()] and the unit tangent there (at a corner that of the segment before).
    /// Throws std::out_of_range for an s outside, or a line without length.
    [[nodiscard]] std::pair<Vec, Vec> at(double s) const;
};

/// Where a point stands to a region.
enum class Side { outside, on_edge, inside };

/// The nearest point of a set of curves.
struct Projection {
    Vec point = Vec::Zero();
    double distance = 0;
};

/// A named area of a 2-D geometry, bounded by closed polylines (the first need not be the outer one; even-odd rule).
/// Every loop counts as closed. read_geometry turns all loops so that the region lies on their left.
/// For many points ask an InsideTest (geometry/inside_test.hpp).
struct Region {
    std::string name;
    std::vector<Polyline> loops;

    [[nodiscard]] double area() const;
    /// Exact: decided with exact predicates on the polyline's doubles, also on edges and corners.
    [[nodiscard]] Side side_of(const Vec& point) const;
};

/// A named set of curves: walls, inlets, leaflets. Each piece is a maximal chain of connected curves: it ends at loose
/// ends and where more than two curves meet. Pieces follow the order of the curves' numbers in the geometry, and each
/// has the direction of its first curve. For many points ask a NearestCurve (geometry/nearest_curve.hpp).
struct CurveSet {
    std::string name;
    std::vector<Polyline> pieces;

    [[nodiscard]] double length() const;
    /// The first of the nearest points; of a set without points the distance is infinite.
    [[nodiscard]] Projection nearest(const Vec& point) const;
};

/// A named volume of a 3-D geometry. Its surface is closed, and its triangles face outward.
struct Solid {
    std::string name;
    TriangleSurface surface;

    [[nodiscard]] double volume() const;  ///< [m^3]
};

/// A named set of surfaces in 3-D: walls, inlets, thin bodies.
struct SurfaceSet {
    std::string name;
    TriangleSurface surface;
    std::string why_open{};  ///< why triangles of a file make up no solid; empty: they were not to
};

/// Where a length that the file gives no unit comes from.
enum class UnitSource { scene, file, assumed };

/// A geometry in SI units: named areas, curves and points (gmsh's physical groups) of the plane, or named volumes and
/// surfaces in 3-D (gmsh's physical groups, bodies of CAD files, groups of files of triangles).
struct Geometry {
    std::string file;
    int dimension = 2;
    Box box;
    std::vector<Region> regions;       ///< 2-D only
    std::vector<CurveSet> curves;      ///< 2-D only
    std::vector<Solid> solids;         ///< 3-D only
    std::vector<SurfaceSet> surfaces;  ///< 3-D only
    std::map<std::string, std::vector<Vec>> points;
    double unit = 1;  ///< one unit of the geometry, or of its file as it was read [m]
    UnitSource unit_source = UnitSource::assumed;
    std::vector<std::string> warnings;  ///< of gmsh while it read the geometry, and what was changed in it

    [[nodiscard]] const Region* region(const std::string& name) const;
    [[nodiscard]] const CurveSet* curve_set(const std::string& name) const;
    [[nodiscard]] const Solid* solid(const std::string& name) const;
    [[nodiscard]] const SurfaceSet* surface_set(const std::string& name) const;
    /// Names of all regions, curve sets, solids, surface sets and point sets, each once, sorted.
    [[nodiscard]] std::vector<std::string> names() const;
};

/// Triangles of a body or surface in 3-D by where they lie; all that is given must hold at once. They get a name and
/// become a surface set. In 2-D: straight pieces of an area's boundary or of a curve, which become a curve set.
struct FaceSelection {
    std::string name{};
    std::string of{};                                 ///< the solid or surface set; region or curve set
    std::array<std::optional<double>, 3> in_plane{};  ///< by axis: all corners have this coordinate [m]
    std::optional<Box> in_box{};                      ///< all corners lie in it [m]
    std::optional<Vec> normal{};                      ///< of any length: where they face
    double angle = 0;                                 ///< from the normal, at most [rad]
    std::vector<std::string> except{};                ///< names of earlier selections that they are not in
    SourceLocation location{};                        ///< where the scene asks for it, for errors
};

/// How far what a script of gmsh says is trusted (docs/security.md).
enum class Trust {
    none,       ///< words that do more than describe shapes are refused, and the process that reads it is confined
    unchecked,  ///< confined only: for tests of that
    full,       ///< gmsh does what the script says, as the user
};

struct GeometryOptions {
    std::string file{};  ///< path of the geometry
    Trust trust = Trust::none;
    std::optional<double>
        unit{};  ///< one unit of the geometry [m]; none: what the file says, or 1 m for gmsh's geometries
    std::map<std::string, double> parameters{};  ///< DefineConstant name -> value in the geometry's units
    std::map<std::string, SourceLocation> parameter_locations{};  ///< where the scene sets them, for errors
    double chord_error = 1e-6;  ///< largest distance between a curve and its polyline [m]
    std::vector<FaceSelection> selections{};
    SourceLocation location{};  ///< where the scene names the file, for errors

    [[nodiscard]] double metres() const { return unit.value_or(1.0); }  ///< one unit of the geometry [m]
};

/// Reads a geometry, by its ending (docs/cad.md):
///
/// - a gmsh geometry: a .geo or .geo_unrolled script, or a .msh mesh, whose edges are then taken as they are;
/// - a CAD file: .step, .stp, .iges, .igs or .brep. Its bodies become solids; faces alone in z = 0 regions;
/// - a file of triangles: .stl, .obj, .ply or .off. Each closed group of triangles becomes a solid, others surface
/// sets.
///
/// A gmsh geometry without volumes lies in the plane z = 0: named physical surfaces become regions, named physical
/// curves curve sets, named physical points points. In one with volumes, named physical volumes become solids and named
/// physical surfaces surface sets, of triangles that follow the drawn surfaces to within the chord error about.
/// Coordinates are scaled to metres. The ends of curves are the geometry's points, bit for bit; straight lines stay two
/// points.
///
/// Parameters set the constants that the script offers with a Name:
///
///     DefineConstant[ leaflet_length = {0.0175, Name "leaflet_length"} ];
///
/// It is the text after Name that counts. gmsh offers no way to set the plain form DefineConstant[ a = 1 ] from
/// outside.
///
/// Safe to call from several threads (one geometry is read at a time). gmsh's global state does not outlive the call;
/// the caller's locale and number of threads stay as they were.
///
/// Throws InputError: a file that cannot be read or has a format we do not read; a unit that is missing or that the
/// file has itself; gmsh's own errors with their line; a parameter that the geometry does not offer (with the nearest
/// name) or fixes itself; a geometry without named groups, or without volumes and outside z = 0; groups without a name;
/// curves without length; regions that are empty, open or cross themselves; solids that are not closed or enclose
/// nothing; selections without a face.
Geometry read_geometry(const GeometryOptions& options);

}  // namespace dmp::geometry
