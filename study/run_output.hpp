// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "base/enum_names.hpp"
#include "scene/toml_node.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// What a run may do without besides its numbers (measures.csv, summary.json, run.log, scene.resolved.toml).
enum class RunOutput {
    frames,     ///< and with them ParaView's files and the pictures, which are drawn of them
    pictures,   ///< 'dmp pictures' draws them of the frames
    page,       ///< 'dmp report' writes it
    checkpoint  ///< of a run that has reached its end: it cannot be made longer then
};
using LeftOut = std::set<RunOutput>;

/// Of a study that does not say what its runs leave out: of more runs than this they have no pictures and no page.
inline constexpr std::size_t most_runs_with_pages = 100;

/// None where there is no such output.
[[nodiscard]] std::optional<RunOutput> run_output_called(std::string_view name);

/// Of a list such as ["frames", "page"]. Throws InputError.
[[nodiscard]] LeftOut read_left_out(const TomlNode& list, const std::string& path);

}  // namespace dmp::study

namespace dmp {

template <>
inline constexpr auto enum_names<study::RunOutput> = std::to_array<std::string_view>({"frames", "pictures", "page",
                                                                                      "checkpoint"});

}  // namespace dmp
