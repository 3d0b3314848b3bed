// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_names.hpp"
#include "scene/scene.hpp"
#include "scene/step_margins.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// What the plan of a scene's run says, as far as limits depend on it.
struct LimitFacts {
    bool at_rest = false;                       ///< nothing moves, and only species are stepped
    double contact_strength = 0;                ///< K of the short-range repulsion [J]; 0: there is none
    double dt = 0;                              ///< time step [s]
    std::map<std::string, double> step_limits;  ///< largest step of each model that the step follows from [s]
    std::vector<std::string> subcycled;         ///< models with steps of their own in each step, which take time
};

/// Which way a value goes from the scene's own.
enum class DialSide { up, down };

/// A key that a dial turns; several keys of one dial are multiplied by the same factor.
struct DialKey {
    std::string key;       ///< "part.blood.viscosity"
    double own = 0;        ///< the scene's value, in `unit`
    std::string unit;      ///< SI; "": a plain number
    std::string own_toml;  ///< what makes a run the scene's own
    std::function<std::string(double factor)> toml;
};

/// A value of a dial.
struct DialRung {
    double factor = 1;              ///< of the scene's own
    double value = 0;               ///< of the dial's first key, in its unit
    std::vector<std::string> toml;  ///< of each key
    double cost = 1;                ///< steps in the same time, as a multiple of those of the scene's own
};

/// A value of a scene's models that is turned, one way, until the scene breaks.
struct Dial {
    std::string name;  ///< its first key
    std::string what;  ///< for people
    DialSide side = DialSide::up;
    /// A property of what is simulated: with another value the answer is another one, and only what breaks is a limit.
    bool is_physical = false;
    std::vector<DialKey> keys;
    std::optional<StatedLimit> stated;  ///< of the first key: by a formula, or the check that refuses what is beyond
    std::vector<DialRung> rungs;        ///< from the scene's own value away
    std::string end;                    ///< why the ladder has no further rungs
    std::string refused;          ///< what the scene's check says of what is beyond the last rung; "": it allows it
    std::optional<double> bound;  ///< the last value that the check allows, where it refuses what is beyond

    [[nodiscard]] double own() const { return keys.front().own; }
    [[nodiscard]] const std::string& unit() const { return keys.front().unit; }
    /// How many times the value may grow, or shrink, up to the stated limit, which there must be.
    [[nodiscard]] double stated_margin() const {
        return side == DialSide::up ? stated->value / own() : own() / stated->value;
    }
};

/// The dials of the models that the scene uses, each up, down, or both. Rungs are multiples of the scene's own value:
/// 8 by 2^(1/4) each, 4 by 2^(1/2) and 6 by 2, up to a thousand times; less where the check of the scene refuses what
/// is beyond (the last rung is then the bound that it states), where the step no longer changes, and where it becomes
/// shorter than a twentieth. `scene`: as read from `path` with `overrides`.
[[nodiscard]] std::vector<Dial> limit_dials(const Scene& scene, const std::string& path,
                                            const std::vector<std::string>& overrides, const LimitFacts& facts);

/// A run of the scene with another spacing (by 0.5 %) and step (by 3 %), where it has them: what its measures do of
/// themselves. As --set takes it, by key.
[[nodiscard]] std::map<std::string, std::string> repeat_of(const Scene& scene, const LimitFacts& facts);

}  // namespace dmp::study

namespace dmp {

template <>
inline constexpr auto enum_names<study::DialSide> = std::to_array<std::string_view>({"up", "down"});

}  // namespace dmp
