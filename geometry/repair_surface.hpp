// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "geometry/repair_report.hpp"
#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// What may be done for a surface that is not closed, each with all before it.
enum class RepairRung {
    none,
    weld,  ///< corners nearby become one, T-junctions are divided
    fill,  ///< small holes are filled
    vote,  ///< holes are left, and the winding number says what is inside
    wrap   ///< another surface stands around it
};

/// What repair_surface may do. Lengths are relative to the particles: what is far smaller than a spacing changes no
/// particle.
struct RepairLimits {
    double spacing = 0;           ///< of the particles [m]; must be positive
    double weld_distance = 1e-3;  ///< corners nearer than that become one [spacings]
    double largest_hole = 8;      ///< perimeter of holes that are filled [spacings]
    double smallest_piece = 1;    ///< pieces whose box has a shorter diagonal are thrown away [spacings]
    double largest_doubt = 0.02;  ///< share of places of which the winding number may not be sure
    RepairRung highest = RepairRung::wrap;
    double wrap_alpha = 1;     ///< the wrap closes what is narrower than that [spacings]
    double wrap_offset = 0.1;  ///< and lies that far outside [spacings]
    bool meets_itself = true;  ///< whether to look for triangles that meet: a second for 10^6 triangles or so
};

struct RepairedSurface {
    TriangleSurface surface;  ///< faces outward; closed, or has_holes is set
    RepairReport report;
};

/// A surface that could not be repaired.
class UnusableSurface : public InputError {
  public:
    UnusableSurface(SourceLocation where, std::string what, std::string what_to_do, TriangleSurface bad)
        : InputError(std::move(where), std::move(what), std::move(what_to_do)),
          bad_(std::make_shared<const TriangleSurface>(std::move(bad))) {}

    /// The triangles that are to blame, for a file that shows them.
    [[nodiscard]] const TriangleSurface& bad_triangles() const { return *bad_; }

  private:
    std::shared_ptr<const TriangleSurface> bad_;
};

/// Gives a surface of triangles an inside, by the first rung of a ladder that does:
///   1. corners at the same place are one; triangles without area and duplicates are dropped;
///   2. if it is not closed: corners are welded, T-junctions divided;
///   3. pieces that touch in edges are separated, triangles turned to face outward, small pieces and those without
///   volume
///      thrown away;
///   4. small holes are filled;
///   5. holes are left, and the winding number decides, if it is clear enough (largest_doubt);
///   6. CGAL's alpha wrap takes its place, if its volume is what the winding number says of the surface itself: it has
///   not
///      gone in through a large hole.
/// Where pieces cross each other, what lies in either is inside. The report says what each rung did. A surface that is
/// in order comes back as it is.
///
/// Throws UnusableSurface with `name` ("solid 'blood'") and `place` (the file, or where the scene names it), counts and
/// the first bad place: no triangles; corners that are not finite or do not exist; all pieces smaller than the limit or
/// without volume; sheets; a surface that no rung closes. Throws std::invalid_argument for limits that are not
/// positive.
RepairedSurface repair_surface(TriangleSurface surface, const RepairLimits& limits, const std::string& name,
                               const SourceLocation& location);

}  // namespace dmp::geometry
