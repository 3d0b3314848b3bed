// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/limit_dials.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/errors.hpp"
#include "base/number_text.hpp"
#include "scene/quantity.hpp"
#include "scene/read_scene.hpp"
#include "scene/toml_node.hpp"
#include "study/limit_dial_list.hpp"

namespace dmp::study {

namespace {

/// Rungs: so many, each by a ratio of 2 to this power.
constexpr std::pair<int, double> parts_of_ladder[] = {{8, 0.25}, {4, 0.5}, {6, 1}};
constexpr double largest_cost = 20;
/// Values that are nearer to each other are not told apart.
constexpr double nearly = 1.01;
/// As of a trade's repeats.
constexpr double repeat_spacing = 1.005, repeat_step = 0.97;

/// Factors of a ladder, above 1.
std::vector<double> ladder_factors() {
    std::vector<double> factors;
    double power = 0;
    for (const auto& [count, ratio] : parts_of_ladder)
        for (int k = 0; k < count; ++k) factors.push_back(std::exp2(power += ratio));
    return factors;
}

/// Makes the ladders of a scene.
class Ladders {
  public:
    Ladders(const Scene& scene, const std::string& path, const std::vector<std::string>& overrides,
            const LimitFacts& facts)
        : of_{scene, facts}, path_(path), overrides_(overrides) {}

    std::vector<Dial> all() {
        std::vector<Dial> dials;
        for (const DialRow& row : dial_list())
            for (const std::vector<DialKey>& keys : row.found(of_)) {
                // A key that another one excludes, although it has a value, cannot be given.
                if (!problem_of(keys, 1, true).empty()) continue;
                for (const DialSide side : row.sides) dials.push_back(dial_of(row, keys, side));
            }
        return dials;
    }

  private:
    Dial dial_of(const DialRow& row, const std::vector<DialKey>& keys, DialSide side) {
        Dial dial;
        dial.name = keys.front().key;
        dial.what = row.what;
        dial.side = side;
        dial.is_physical = row.is_physical;
        dial.keys = keys;
        if (row.stated) dial.stated = row.stated(of_);
        for (const double factor : ladder_factors()) add(dial, side == DialSide::up ? factor : 1 / factor);
        end_where_refused(dial);
        end_where_steps_tell(dial, row);
        return dial;
    }

    static DialRung rung_at(const Dial& dial, double factor) {
        // As it is written for the run.
        const double value = std::stod(number_text(dial.own() * factor, rung_digits));
        DialRung rung{value / dial.own(), value, {}, 1};
        for (const DialKey& key : dial.keys) rung.toml.push_back(key.toml(factor));
        return rung;
    }
    static void add(Dial& dial, double factor) { dial.rungs.push_back(rung_at(dial, factor)); }

    /// What the check of the scene says of it; "": nothing.
    [[nodiscard]] std::string problem_of(const std::vector<DialKey>& keys, double factor, bool own = false) const {
        std::vector<std::string> all = overrides_;
        for (const DialKey& key : keys) all.push_back(key.key + "=" + (own ? key.own_toml : key.toml(factor)));
        try {
            static_cast<void>(read_scene(path_, all));
        } catch (const InputError& error) {
            return error.problem();
        }
        return "";
    }

    /// The rungs that the check allows, and the bound that it has.
    void end_where_refused(Dial& dial) const {
        if (problem_of(dial.keys, dial.rungs.back().factor).empty()) return;
        const auto refused = std::ranges::find_if(
            dial.rungs, [&](const DialRung& rung) { return !problem_of(dial.keys, rung.factor).empty(); });
        dial.refused = problem_of(dial.keys, refused->factor);
        double good = refused == dial.rungs.begin() ? 1 : std::prev(refused)->factor, bad = refused->factor;
        dial.rungs.erase(refused, dial.rungs.end());
        for (int i = 0; i < 30; ++i) {
            const double middle = std::sqrt(good * bad);
            (problem_of(dial.keys, middle).empty() ? good : bad) = middle;
        }
        const double last = dial.rungs.empty() ? 1 : dial.rungs.back().factor;
        if (std::max(good / last, last / good) > nearly) add(dial, good);
        dial.bound = rung_at(dial, good).value;
        if (!dial.stated) dial.stated = StatedLimit{*dial.bound, dial.refused};
        dial.end = "refused beyond: " + dial.refused;
    }

    static double power_of(const DialRow& row, const std::string& model) {
        double power = 0;
        for (const StepScaling& scaling : row.steps)
            if (model.starts_with(scaling.model)) power = scaling.power;
        return power;
    }

    /// The step [s] that the models allow at a factor, and which of them rules it.
    [[nodiscard]] std::pair<double, std::string> step_at(const DialRow& row, double factor) const {
        std::pair<double, std::string> step{of_.facts.dt, ""};
        for (const auto& [model, dt] : of_.facts.step_limits) {
            const double scaled = dt * std::pow(factor, power_of(row, model));
            if (step.second.empty() || scaled < step.first) step = {scaled, model};
        }
        return step;
    }

    /// How many times as many steps a factor takes, of the run or, at most, of what is sub-cycled, and by which model.
    [[nodiscard]] std::pair<double, std::string> cost_at(const DialRow& row, double factor) const {
        const auto [step, ruling] = step_at(row, factor);
        std::pair<double, std::string> cost{step_at(row, 1).first / step, ruling};
        for (const std::string& model : of_.facts.subcycled)
            if (const double its = std::pow(factor, -power_of(row, model)); its > cost.first) cost = {its, model};
        return cost;
    }

    void end_where_steps_tell(Dial& dial, const DialRow& row) const {
        double before = step_at(row, 1).first;
        for (auto rung = dial.rungs.begin(); rung != dial.rungs.end(); ++rung) {
            const auto [step, ruling] = step_at(row, rung->factor);
            const auto [cost, costly] = cost_at(row, rung->factor);
            rung->cost = cost;
            const bool is_same = row.acts_by_step && step < before * nearly;
            if (rung->cost <= largest_cost && !is_same) {
                before = step;
                continue;
            }
            dial.end = is_same ? "beyond, the limit '" + ruling + "' rules the step"
                               : "beyond, steps are more than " + number_text(largest_cost) + " times shorter, by '" +
                                     costly + "'";
            dial.refused.clear();
            dial.bound.reset();
            dial.rungs.erase(rung, dial.rungs.end());
            return;
        }
        if (dial.end.empty()) dial.end = "the end of the ladder";
    }

    DialScene of_;
    const std::string& path_;
    const std::vector<std::string>& overrides_;
};

}  // namespace

std::vector<Dial> limit_dials(const Scene& scene, const std::string& path, const std::vector<std::string>& overrides,
                              const LimitFacts& facts) {
    return Ladders(scene, path, overrides, facts).all();
}

std::map<std::string, std::string> repeat_of(const Scene& scene, const LimitFacts& facts) {
    std::map<std::string, std::string> values;
    const auto& numerics = scene.numerics;
    if (scene.particles.spacing.given())
        values["particles.spacing"] = toml_quoted(number_text(*scene.particles.spacing * repeat_spacing, 6) + " m");
    if (!scene.parts_of(PartKind::fluid).empty() && !facts.at_rest)
        values["numerics.step_factor"] = number_text(*numerics.step_factor * repeat_step, 6);
    if (!scene.parts_of(PartKind::spheres).empty() && *numerics.contact_step == 0)
        values["numerics.steps_per_contact"] = number_text(*numerics.steps_per_contact / repeat_step, 6);
    return values;
}

}  // namespace dmp::study
