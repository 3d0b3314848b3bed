// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/write_report.hpp"

#include "base/safe_file.hpp"
#include "report/run_page.hpp"
#include "report/study_files.hpp"
#include "report/study_page.hpp"

namespace dmp::report {

void write_run_report(const std::filesystem::path& folder, const OpenParaviewFrames& open_paraview) {
    write_file(folder / report_file_name, run_page(read_run_files(folder, open_paraview)));
}

void write_study_report(const std::filesystem::path& folder) {
    write_file(folder / report_file_name, study_page(read_study_files(folder)));
}

}  // namespace dmp::report
