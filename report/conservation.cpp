// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/conservation.hpp"

#include <cmath>

#include <fmt/format.h>

#include "report/html.hpp"

namespace dmp::report {

namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string mass_and_momentum(const JsonValue& conserved) {
    const double before = conserved["start"]["mass"].number(), after = conserved["end"]["mass"].number();
    std::string text =
        table("Mass [kg] of what moves", {"", "at the start", "at the end", "change relative to the start"},
              {{"mass", number_text(before), number_text(after),
                before > 0 ? fmt::format("{:.2g}", after / before - 1) : "none moves"}});
    const auto row = [](const std::string& name, const JsonValue& vector) {
        std::vector<std::string> cells{name};
        for (const JsonValue& component : vector.elements()) cells.push_back(number_text(component.number()));
        cells.resize(4, "not known");
        return cells;
    };
    text += table("Momentum [kg m/s] of what moves, and what changed it", {"", "x", "y", "z"},
                  {row("momentum at the start", conserved["start"]["momentum"]),
                   row("impulse of body forces", conserved["impulse_of_body_forces"]),
                   row("impulse of walls and anchors", conserved["impulse_of_fixed"]),
                   row("impulse of drag", conserved["impulse_of_drag"]),
                   row("momentum at the end", conserved["end"]["momentum"])});
    const double residual = conserved["momentum_residual"].number();
    return text + "<p>Unaccounted for: " +
           (std::isfinite(residual) ? fmt::format("{:.2g} of the sum of the impulses' magnitudes", residual)
                                    : std::string("not known")) +
           ".</p>\n";
}

std::string species_table(const JsonValue& species) {
    Rows rows;
    for (const auto& [name, of] : species.members())
        rows.push_back({fmt::format("{} [{}]", name, of["unit"].text()), number_text(of["start"].number()),
                        number_text(of["from_walls"].number()), number_text(of["taken_up"].number()),
                        number_text(of["end"].number()), fmt::format("{:.2g}", of["residual"].number())});
    return rows.empty()
               ? ""
               : table("Species",
                       {"species", "at the start", "from walls", "taken up", "at the end", "unaccounted for, relative"},
                       rows);
}

std::string energy_table(const JsonValue& energy) {
    if (!energy.is_there()) return "";
    const auto row = [](const std::string& name, const JsonValue& of) {
        const double translation = of["translation"].number(), rotation = of["rotation"].number(),
                     contacts = of["contacts"].number();
        return std::vector<std::string>{name, number_text(translation), number_text(rotation), number_text(contacts),
                                        number_text(translation + rotation + contacts)};
    };
    return table("Energy [J] of the spheres", {"", "translation", "rotation", "in contacts", "sum"},
                 {row("at the start", energy["start"]), row("at the end", energy["end"])});
}

}  // namespace

std::string conservation_section(const RunFiles& run) {
    const JsonValue facts = run.facts();
    std::string text;
    if (facts["conserved"].is_there()) text += mass_and_momentum(facts["conserved"]);
    text += species_table(facts["species"]) + energy_table(facts["energy"]);
    std::vector<std::pair<std::string, std::string>> items{{"particles lost", number_text(facts["lost"].number())}};
    const double low = facts["density_low"].number(), high = facts["density_high"].number();
    if (low > 0 && high >= low)
        items.emplace_back("density of the fluid", fmt::format("{:.6g} to {:.6g} kg/m^3", low, high));
    if (const double drift = facts["density_drift"].number(); std::isfinite(drift) && drift != 0)
        items.emplace_back("drift of the mean density that was corrected", fmt::format("{:.2g} of itself", drift));
    return section("conservation", "What was conserved", text + list(items));
}

}  // namespace dmp::report
