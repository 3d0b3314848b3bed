// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/state/loaded_groups.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::solver {

InputError unlike_any_run(const std::string& problem) {
    return {"the checkpoint holds what no run of dmp writes: " + problem, "Start the run anew in another folder."};
}

void check_loaded(std::span<const ParticleGroup> groups, std::int64_t ids, std::size_t parts) {
    for (const ParticleGroup& group : groups) {
        for (std::size_t i = 0; i < group.owned(); ++i) {
            const ParticleTag& tag = group.tags()[i];
            if (tag.id < 0 || tag.id >= ids)
                throw unlike_any_run("particle " + std::to_string(tag.id) + ", which the run does not have");
            if (tag.part >= parts)
                throw unlike_any_run("a particle of part " + std::to_string(tag.part) +
                                     ", which the scene does not have");
        }
        for (const Field field : group.state())
            for (int axis = 0; axis < group.axes(field); ++axis)
                if (!std::all_of(group.data(field, axis), group.data(field, axis) + group.owned(),
                                 [](double value) { return std::isfinite(value); }))
                    throw unlike_any_run("a " + std::string(info(field).name) + " that is not finite");
    }
}

}  // namespace dmp::solver
