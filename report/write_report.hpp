// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "report/run_files.hpp"

namespace dmp::report {

inline constexpr const char* report_file_name = "report.html";

/// Writes folder/report.html about the run in the folder: one file, which needs no other and no network. Throws
/// InputError where no run has begun there or a file of it is damaged, ResourceError if it cannot be written.
void write_run_report(const std::filesystem::path& folder, const OpenParaviewFrames& open_paraview);

/// The same about the study in the folder.
void write_study_report(const std::filesystem::path& folder);

}  // namespace dmp::report
