// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_names.hpp"
#include "cli/sweep/sweep_rows.hpp"
#include "cli/uses.hpp"
#include "scene/scene.hpp"
#include "solver/results/frame.hpp"
#include "study/limit_bisection.hpp"
#include "study/limit_study.hpp"
#include "study/series_error.hpp"

namespace dmp::cli {

/// How a run of a study of limits has ended.
enum class RungWay {
    unknown,  ///< not to its end
    clean,
    departs,  ///< a measure is further from that of the scene's own settings than is allowed
    breaks,   ///< the simulation diverged
    refused,  ///< bad input, by the check of the scene or of its particles
    failed    ///< otherwise: killed, without memory or disk, or by a bug
};

struct RungEnd {
    RungWay way = RungWay::unknown;
    std::string text;                    ///< what it said, of one that has failed
    std::string likely_causes;           ///< that it named; "": none
    double distance = study::no_number;  ///< the largest of its measures' (study::SeriesError)
    std::string column;                  ///< which that is of

    /// What it is for the search of a limit.
    [[nodiscard]] study::RungState state() const;
};

/// A column of measures that runs are compared by.
struct LimitColumn {
    std::string name;
    study::SeriesSize size;             ///< of the run with the scene's own settings, or of its vector
    double scatter = study::no_number;  ///< distance of the repeat; NaN: not known
    double allowed = 0;                 ///< distance from which on a run departs

    /// Not where it is zero, or scatters by more than a fifth of its size.
    [[nodiscard]] bool counts() const { return size.peak > 0 && !(scatter > 0.2); }
};

/// How the runs of a study of limits have ended, as its table and their folders have it; of those that go on, as soon
/// as they have.
class RungEnds {
  public:
    /// `tolerance`: from which distance on a measure departs, where it scatters by less than a third of that.
    RungEnds(const SweepRows& rows, const study::LimitStudy& study, const Scene& scene, double tolerance)
        : rows_(rows), study_(study), scene_(scene), tolerance_(tolerance) {}

    [[nodiscard]] const RungEnd& of(std::size_t run);
    /// Whether runs can be compared: that with the scene's own settings is clean, and its repeat has ended.
    [[nodiscard]] bool has_reference();
    [[nodiscard]] std::vector<study::RungState> states_of(std::size_t dial);
    /// Whether a dial's runs can be told from each other: by what breaks alone, or by a measure that counts. Only after
    /// has_reference.
    [[nodiscard]] bool can_compare(std::size_t dial) const;
    /// What is to be said of the measures: why their scatter is not known, that none counts.
    [[nodiscard]] std::vector<std::string> notes();
    /// Those of the run with the scene's own settings; none before has_reference.
    [[nodiscard]] const std::vector<LimitColumn>& columns() const { return columns_; }

  private:
    [[nodiscard]] RungEnd end_of(std::size_t run);
    [[nodiscard]] MeasureSeries measures_of(std::size_t run) const;
    void take_reference();
    void compare(RungEnd& end, const MeasureSeries& measures) const;

    const SweepRows& rows_;
    const study::LimitStudy& study_;
    const Scene& scene_;
    double tolerance_;
    std::map<std::size_t, RungEnd> ends_;
    std::optional<MeasureSeries> own_;
    std::vector<LimitColumn> columns_;
};

}  // namespace dmp::cli

namespace dmp {

template <>
inline constexpr auto enum_names<cli::RungWay> = std::to_array<std::string_view>({"unknown", "clean", "departs",
                                                                                  "breaks", "refused", "failed"});

}  // namespace dmp
