// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/solidify/body_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dmp::solver {

std::optional<std::array<int, 2>> overloaded_bond(const SpringBody& body, const BondBreak& law, int origin) {
    std::optional<std::array<int, 2>> worst;
    double most = 0;
    for (std::size_t b = 0; b < body.bonds().size(); ++b) {
        if (body.bond_origin(b) != origin) continue;
        const SpringBody::OwnBond& bond = body.bonds()[b];
        const double excess = law.excess(body.stretch(bond), bond.rest_length, bond.stiffness);
        if (!(excess > 0) || excess < most) continue;
        const auto [low, high] = std::minmax(body.ids()[bond.a], body.ids()[bond.b]);
        const std::array<int, 2> ends{low, high};
        if (!worst || excess > most || ends < *worst) worst = ends;
        most = excess;
    }
    return worst;
}

namespace {

/// A part's particles may be others than its scene asks for: a thin volume becomes a shell, and particles may come from
/// a file.
void refuse_limit(const Value<double>& limit, const std::string& text, const Breaking& rule) {
    if (limit > 0)
        throw InputError(limit.location,
                         "break '" + *rule.name + "': " + text + " (a volume thinner than two spacings is a shell)",
                         "give strain_above");
}

std::variant<BondBreak, SolidBreak> law_of(const ParticleSet& set, const Breaking& rule) {
    const bool of_cells = std::ranges::any_of(
        set.cells, [&](const SolidCell& cell) { return set.parts[set.part[cell.particle]].name == *rule.part; });
    if (of_cells) {
        refuse_limit(rule.force_above, "'" + *rule.part + "' consists of cells, and force_above is for bonds", rule);
        if (rule.stress_above > 0) return SolidBreak{SolidBreak::Criterion::stress, rule.stress_above};
        return SolidBreak{SolidBreak::Criterion::strain, rule.strain_above};
    }
    refuse_limit(rule.stress_above, "'" + *rule.part + "' consists of bonds, and stress_above is for cells", rule);
    if (rule.force_above > 0) return BondBreak{BreakCriterion::force, rule.force_above};
    return BondBreak{BreakCriterion::strain, rule.strain_above};
}

/// What breaks of a body, if anything does.
struct Overloaded {
    const SpringBody& body;
    int origin;
    std::optional<std::array<int, 2>> operator()(const BondBreak& law) const {
        return overloaded_bond(body, law, origin);
    }
    std::optional<std::array<int, 2>> operator()(const SolidBreak& law) const {
        return body.overloaded_face(law, origin);
    }
};

}  // namespace

BodyEvents::BodyEvents(const Scene& scene, const ParticleSet& set, const Ranks& ranks) {
    for (int number = 0; number < static_cast<int>(scene.solidify.size()); ++number) {
        const Solidify& rule = scene.solidify[static_cast<std::size_t>(number)];
        const double until = *rule.until > 0 ? *rule.until : std::numeric_limits<double>::infinity();
        solidifying_.push_back(
            {std::make_unique<Solidification>(scene, number, set, ranks), rule.from, until, Schedule(rule.interval)});
    }
    const auto names = body_names(scene);
    for (const Breaking& rule : scene.breaking) {
        breaks_.push_back({*rule.name, law_of(set, rule),
                           static_cast<int>(std::ranges::find(names, *rule.part) - names.begin()), rule.interval == 0,
                           Schedule(rule.interval > 0 ? rule.interval.value : 1)});
    }
}

/// The time of its next event [s]; infinite after the last one.
double BodyEvents::Solidifying::next() const {
    const double next = from + times.next(), rounding = 1e-9 * std::abs(next);
    return next < until - rounding ? next : std::numeric_limits<double>::infinity();
}

double BodyEvents::next() const {
    double next = std::numeric_limits<double>::infinity();
    for (const Solidifying& each : solidifying_) next = std::min(next, each.next());
    for (const Breaks& each : breaks_)
        if (!each.every_step) next = std::min(next, each.times.next());
    return next;
}

bool BodyEvents::act(double time, ParticleStore& particles, FluidStep& fluid) {
    bool acted = false;
    for (Breaks& each : breaks_) {
        if (!each.every_step && !each.times.due(time)) continue;
        BodyChange change;
        for (const auto& body : fluid.springs().bodies())
            if (const auto ends = std::visit(Overloaded{*body, each.origin}, each.law)) change.broken.push_back(*ends);
        if (change.empty()) continue;
        fluid.refresh_neighbours();
        fluid.change_bodies(change);
        acted = true;
    }
    for (Solidifying& each : solidifying_) {
        if (!std::isfinite(each.next()) || !each.times.due(time - each.from)) continue;
        fluid.update_pressure();
        fluid.refresh_neighbours();
        each.rule->act(each.events++, particles, fluid);
        acted = true;
    }
    return acted;
}

void BodyEvents::archive(Archive& file, double time) {
    for (std::size_t k = 0; k < solidifying_.size(); ++k) {
        Solidifying& each = solidifying_[k];
        each.times.archive(file, "solidify/times_" + std::to_string(k));
        if (file.starts_run()) each.times.skip_until(time - each.from);  // events may have had an end that is gone now
        file("solidify/events_" + std::to_string(k), each.events);
        each.rule->archive(file);
    }
    for (Breaks& each : breaks_) each.times.archive(file, "break/times_" + each.name);
}

}  // namespace dmp::solver
