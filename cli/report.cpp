// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/prepare.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "cli/terminal.hpp"
#include "cli/uses.hpp"
#include "cli/workstation.hpp"
#include "report/write_report.hpp"

namespace dmp::cli {

int execute(const ReportCommand& command) {
    refuse_several_ranks();
    const std::filesystem::path folder = command.folder;
    if (sweep_contents_of(folder).kind == SweepContents::Kind::study)
        write_study_report(folder);
    else
        write_run_report(folder, stored_paraview_frames);
    print((folder / report_file_name).string() + "\n");
    return exit_done;
}

}  // namespace dmp::cli
