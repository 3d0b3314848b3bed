// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/enum_names.hpp"
#include "scene/value.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// What starts a run's ranks.
enum class Launcher { mpirun, srun };

/// [slurm]: what the jobs of a study ask Slurm for (docs/studies.md). What is not given is not asked for.
struct Slurm {
    Value<std::string> partition, account, qos, constraint, memory;
    Value<double> time;           ///< the limit of a job [s], at least a minute
    Value<double> stop_before;    ///< time before that limit at which a run writes its checkpoint and leaves [s]
    Value<int> ranks = 1;         ///< of a run
    Value<int> threads;           ///< of a rank; not given: as the scene says, else 1
    Value<int> runs_per_job = 1;  ///< that an element of the array does, one after another
    Value<Launcher> launcher = Launcher::mpirun;

    /// stop_before, or two minutes; a quarter of the time where that is less [s].
    [[nodiscard]] double seconds_before_limit() const;
};

}  // namespace dmp::study

namespace dmp {

template <>
inline constexpr auto enum_names<study::Launcher> = std::to_array<std::string_view>({"mpirun", "srun"});

}  // namespace dmp
