// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/geometry_report.hpp"
#include "cli/prepare.hpp"
#include "cli/terminal.hpp"
#include "cli/uses.hpp"
#include "geometry/geometry_file.hpp"

namespace dmp::cli {

int execute(const InspectCommand& command) {
    refuse_several_ranks();
    const GeometryOptions options = geometry_options(command.file, command.unit);
    const Geometry geometry = read_for_inspection(options, command.reading);
    const bool unit_known = options.unit.has_value() || !needs_a_unit(options.file);
    print(command.json ? geometry_json(geometry, unit_known) : geometry_text(geometry, unit_known));
    return exit_done;
}

}  // namespace dmp::cli
