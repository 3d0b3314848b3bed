// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "base/safe_file.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/geometry_report.hpp"
#include "cli/prepare.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "geometry/geometry_file.hpp"
#include "postproc/triangle_file.hpp"

namespace dmp::cli {

namespace {

/// Writes the triangles where they are asked for; returns what to say of them.
std::string with_bad_triangles(const InspectCommand& command, const Geometry& geometry, bool unit_known) {
    const bool any =
        std::ranges::any_of(geometry.surfaces, [](const SurfaceSet& set) { return !set.why_open.empty(); });
    const std::string& file = command.bad_triangles;
    if (file.empty())
        return any ? "The triangles at open edges, for ParaView: " + command.typed.text() +
                         " --bad-triangles open_edges.vtp\n"
                   : "";
    if (!any) return "There are no triangles at open edges; " + file + " was not written.\n";
    const TriangleSurface bad = bad_triangles(geometry);
    write_triangles(file, bad.corners, bad.triangles);
    return fmt::format("{} at open edges: {}, lengths in {}\n", count_text(bad.triangles.size(), "triangle"), file,
                       unit_known ? "m" : "units of the file");
}

}  // namespace

int execute(const InspectCommand& command) {
    refuse_several_ranks();
    if (!command.bad_triangles.empty()) check_output_file(command.bad_triangles);
    const GeometryOptions options = geometry_options(command.file, command.unit);
    const Geometry geometry = read_for_inspection(options, command.reading);
    const bool unit_known = options.unit.has_value() || !needs_a_unit(options.file);
    print(command.json ? geometry_json(geometry, unit_known) : geometry_text(geometry, unit_known));
    const std::string bad = with_bad_triangles(command, geometry, unit_known);
    // Beside JSON, what a person is told goes to stderr.
    if (!command.json)
        print(bad);
    else if (!command.bad_triangles.empty())
        print_error(bad);
    return exit_done;
}

}  // namespace dmp::cli
