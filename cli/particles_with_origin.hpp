// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::cli {

/// Where particles come from, and what is worth knowing of how they were made.
struct Origin {
    std::string what;  ///< "geometry", "spheres" (file empty) or "from"
    std::string file;
    std::vector<std::pair<std::string, std::string>> springs;  ///< constants, by "springs PART" or "join NAME"
    std::vector<std::string> notes;                            ///< what was adapted
    std::vector<std::string> warnings{};                       ///< what makes results wrong
};

struct ParticlesWithOrigin {
    ParticleSet particles;
    Origin origin;
};

}  // namespace dmp::cli
