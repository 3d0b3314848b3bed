// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/chains.hpp"
#include "geometry/geometry.hpp"

namespace dmp::geometry {

/// The points and curves of the geometry that gmsh has open, as pieces in metres. Each curve is made once, so that all
/// who share it share its bits.
class CadCurves {
  public:
    explicit CadCurves(const GeometryOptions& options);

    [[nodiscard]] Vec point(int tag) const;

    /// One piece for a curve with a formula, one for each edge of a mesh. Throws InputError for a curve without length.
    const std::vector<CurvePiece>& curve(int tag);

    /// Several of them as a named set.
    CurveSet set(const std::string& name, const std::vector<int>& tags);

    /// The boundary pieces of surfaces; one that lies between two of them comes twice or not at all.
    std::vector<CurvePiece> boundary(const std::vector<int>& surfaces);

  private:
    [[nodiscard]] Vec in_metres(const Vec& drawn) const { return options_.metres() * drawn; }
    [[nodiscard]] InputError problem(int curve, const std::string& what, const std::string& what_to_do) const;
    [[nodiscard]] CurvePiece sampled(int tag, bool straight) const;
    void refine(int tag, double t, double step, const Vec& start, const Vec& end, int depth, CurvePiece& points) const;
    [[nodiscard]] std::vector<CurvePiece> mesh_edges(int dimension, const std::vector<int>& tags) const;

    const GeometryOptions& options_;
    std::map<std::size_t, Vec> nodes_;  ///< of a mesh [m]
    std::map<int, std::vector<CurvePiece>> curves_;
};

}  // namespace dmp::geometry
