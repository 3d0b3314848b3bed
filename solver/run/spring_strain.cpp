// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/spring_strain.hpp"

#include <algorithm>
#include <iterator>

#include "base/number_text.hpp"
#include "base/unlisted_value.hpp"

namespace dmp::solver {

namespace {

constexpr double most = 0.2;

double size_of(const LargestStrain& strain) { return std::max(strain.stretched, -strain.compressed); }

/// The part that is judged; null for solids that form or break, whose bonds have limits of their own, and for cells of
/// laws that are for large strains.
const Part* judged_part(const Scene& scene, const std::string& name) {
    const Part* part = scene.part_named(name);
    const bool breaks = std::ranges::any_of(scene.breaking, [&](const Breaking& rule) { return *rule.part == name; });
    const bool is_for_large_strains = part != nullptr && part->elastic_law->is<NeoHookean>();
    return breaks || is_for_large_strains ? nullptr : part;
}

Warning warning_of(const LargestStrain& strain, const Part& part) {
    const std::string range = "was strained by " + number_text(100 * strain.compressed, 3) + " to " +
                              number_text(100 * strain.stretched, 3) + " %";
    if (strain.of_cells)
        return {"part." + strain.name, part.name.location,
                range + " (Green's strain), and its law, that of Saint Venant and Kirchhoff, is for small strains",
                "write elastic_law = \"neo_hookean\", or make the solid stiffer or its load smaller"};
    return {"part." + strain.name, part.name.location,
            range +
                " along its bonds, whose forces are linear in their lengths: its stiffness is no longer that of the "
                "scene (docs/elastic.md, \"Large strains\")",
            "compare with a finer spacing, or make the solid stiffer or its load smaller"};
}

}  // namespace

SpringStrain::SpringStrain(const SpringBodies& springs) {
    for (const std::string& name : springs.names()) largest_.push_back({name});
    for (const auto& body : springs.bodies())
        if (body->consists_of_cells()) largest_[static_cast<std::size_t>(body->origin(0))].of_cells = true;
}

std::vector<Warning> SpringStrain::add(const SpringBodies& springs, const Scene& scene) {
    std::vector<LargestStrain> now = largest_;
    const auto note = [&](int origin, double least, double most_of_it) {
        LargestStrain& of = now[static_cast<std::size_t>(origin)];
        of.stretched = std::max(of.stretched, most_of_it);
        of.compressed = std::min(of.compressed, least);
    };
    for (const auto& body : springs.bodies()) {
        for (std::size_t b = 0; b < body->bonds().size(); ++b) {
            const SpringBody::OwnBond& bond = body->bonds()[b];
            const double strain = body->stretch(bond) / bond.rest_length;
            note(body->bond_origin(b), strain, strain);
        }
        for (std::size_t node = 0; node < body->nodes(); ++node)
            if (const auto strains = body->strains(node)) note(body->origin(node), (*strains)[0], (*strains)[1]);
    }
    std::vector<Warning> first;
    for (std::size_t k = 0; k < now.size(); ++k)
        if (const Part* part = judged_part(scene, now[k].name);
            part != nullptr && size_of(now[k]) > most && size_of(largest_[k]) <= most)
            first.push_back(warning_of(now[k], *part));
    largest_ = std::move(now);
    return first;
}

std::vector<Warning> SpringStrain::warnings(const Scene& scene) const {
    std::vector<Warning> all;
    for (const LargestStrain& strain : largest_)
        if (const Part* part = judged_part(scene, strain.name); part != nullptr && size_of(strain) > most)
            all.push_back(warning_of(strain, *part));
    return all;
}

std::vector<LargestStrain> SpringStrain::largest() const {
    std::vector<LargestStrain> strained;
    std::ranges::copy_if(largest_, std::back_inserter(strained), [](const auto& each) { return size_of(each) > 0; });
    return strained;
}

void SpringStrain::archive(Archive& file) {
    for (LargestStrain& strain : largest_) {
        file("strain/" + strain.name + "/stretched", strain.stretched);
        file("strain/" + strain.name + "/compressed", strain.compressed);
    }
}

}  // namespace dmp::solver
