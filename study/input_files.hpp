// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "study/study.hpp"

namespace dmp::study {

/// A file that a scene reads.
struct InputFile {
    std::string name;  ///< as the scene or the study has it
    std::string hash;  ///< of its contents, 16 hex digits; "" where it cannot be read
};

/// The files of geometry, surfaces, positions and references that the runs of a study read, each once, by name. What
/// such a file reads in turn is not among them.
[[nodiscard]] std::vector<InputFile> input_files(const Study& study);

}  // namespace dmp::study
