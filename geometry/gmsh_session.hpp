// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "geometry/geometry.hpp"
#include "geometry/geometry_source.hpp"

namespace dmp::geometry {

/// gmsh from initialize to finalize. It keeps its state in globals, sets OpenMP to one thread and the numeric locale to
/// "C": all of that is undone at the end. One at a time: others wait.
class GmshSession {
  public:
    GmshSession();
    ~GmshSession();
    GmshSession(const GmshSession&) = delete;
    GmshSession& operator=(const GmshSession&) = delete;

    /// Off while a geometry is read: an exception would leave gmsh's parser in the middle of it, and the first error is
    /// often not the one that names the line. On for all questions afterwards; gmsh then throws a std::string.
    static void throw_on_error(bool yes);

    /// What gmsh logged so far at one level ("Error", "Warning"), without the level.
    [[nodiscard]] static std::vector<std::string> logged(const std::string& level);

  private:
    std::unique_lock<std::mutex> only_one_;
    int threads_;
    std::string locale_;
};

/// Opens a geometry with its parameters set; gmsh holds it as long as the session lives, and throws on errors from now
/// on. Throws InputError: what gmsh says of the geometry, and parameters that it does not offer.
std::unique_ptr<GmshSession> open_geometry(const GeometryOptions& options, const GeometrySource& source);

}  // namespace dmp::geometry
