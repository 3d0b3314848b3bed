// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "cli/uses.hpp"
#include "scene/scene.hpp"
#include "solver/results/frame.hpp"
#include "study/trade_settings.hpp"

namespace dmp::cli {

/// A run of a trade's scene, with a finer setting than the trade's own, that all its runs are compared with.
struct GivenReference {
    std::filesystem::path folder;
    study::TradeSetting setting;
    MeasureSeries measures;
};

/// `scene`: of the trade. Throws InputError where there is no run that has come to its end, or it is not one of this
/// scene: apart from the spacing, the quality and what they set, all that its results depend on must be the same.
[[nodiscard]] GivenReference given_reference(const std::filesystem::path& folder, const Scene& scene);

}  // namespace dmp::cli
