// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "geometry/checked_script.hpp"
#include "geometry/geometry.hpp"

namespace dmp::geometry {

/// The file of a geometry, open and checked, in the form in which gmsh reads it.
///
/// gmsh takes any file for a script whose beginning or ending it does not know, and executes FILE.opt where one lies
/// beside FILE. It is therefore given no file of the user's folder by name: scripts are texts in memory
/// (CheckedScript), meshes and CAD files are open files under /proc/self/fd, where nothing lies beside them. Only a
/// script that is trusted is read where it is.
class GeometrySource {
  public:
    /// Throws InputError: no such file; contents of another kind than the ending says; a script that does harm; an
    /// option file beside a trusted script.
    explicit GeometrySource(const GeometryOptions& options);
    ~GeometrySource();
    GeometrySource(const GeometrySource&) = delete;
    GeometrySource& operator=(const GeometrySource&) = delete;

    /// What gmsh is to open.
    [[nodiscard]] const std::string& path() const { return path_; }
    /// A script without statements, after which gmsh has the size of what it holds.
    [[nodiscard]] const std::string& empty_script() const { return empty_script_; }
    /// The user's file where gmsh reads that; -1: it reads a text in memory.
    [[nodiscard]] int descriptor() const { return script_ ? -1 : descriptor_; }

    /// Where a script sets a name to a value at the beginning of a statement; line 0: nowhere.
    [[nodiscard]] SourceLocation assignment_of(const std::string& name) const;

    /// What gmsh says, with the user's names of files and lines.
    [[nodiscard]] std::string in_users_words(std::string message) const;

  private:
    std::string file_, path_, empty_script_;
    std::optional<CheckedScript> script_;
    int descriptor_ = -1, empty_descriptor_ = -1;
};

}  // namespace dmp::geometry
