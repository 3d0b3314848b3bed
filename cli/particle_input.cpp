// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/particle_input.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "particles/particle_file.hpp"
#include "scene/read_scene.hpp"

namespace dmp::cli {

namespace {

/// "[[part]]" -> "part"; empty for lines that open no table.
std::string table_in(const std::string& line) {
    if (!line.starts_with('[')) return "";
    const auto first = line.find_first_not_of('['), last = line.find_last_not_of(']');
    return line.substr(first, last - first + 1);
}

/// Keys of a scene that mesher reads; the others may change without new particles.
bool matters(const std::string& table, const std::string& key) {
    if (table.empty()) return key == "dimension";
    if (table == "geometry") return key != "file";
    if (table == "particles" || table == "select") return true;
    if (table == "box") return true;
    if (table == "join") return key != "damping";
    if (table == "flow") return key == "periodic" || key == "symmetry";
    if (table == "contact") return key == "range" || key == "between";
    if (table == "numerics") return key == "support";
    constexpr std::array others{"viscosity",
                                "bond_damping",
                                "damping_ratio",
                                "damping_frequency",
                                "initial_velocity",
                                "drag",
                                "mass_damping",
                                "surface_velocity",
                                "slip",
                                "velocity",
                                "spin",
                                "centre"};
    return table == "part" && std::ranges::find(others, key) == others.end();
}

/// Key and value of each line.
std::map<std::string, std::string> by_key(const std::vector<std::string>& lines) {
    std::map<std::string, std::string> values;
    for (const std::string& line : lines) {
        const auto equals = line.find(" = ");
        if (equals != std::string::npos) values[line.substr(0, equals)] = line.substr(equals + 3);
    }
    return values;
}

/// What the particles were made with and the scene says now, where the two differ; empty: nowhere.
std::string difference(const std::vector<std::string>& made_from, const std::vector<std::string>& now) {
    const auto before = by_key(made_from);
    const auto after = by_key(now);
    std::map<std::string, std::string> keys(before);
    keys.insert(after.begin(), after.end());
    const auto value = [](const auto& values, const std::string& key) {
        const auto found = values.find(key);
        return found == values.end() ? std::string("not there") : found->second;
    };
    std::string text;
    for (const auto& [key, any] : keys) {
        const std::string was = value(before, key), is = value(after, key);
        if (was != is) text += fmt::format("\n  {}: {} in the file, {} in the scene", key, was, is);
    }
    return text;
}

/// The same for what every particle set says of itself.
std::string difference(const ParticleSpace& file, const Scene& scene) {
    std::vector<std::string> made_from{fmt::format("dimension = {}", file.dimension)};
    std::vector<std::string> now{fmt::format("dimension = {}", *scene.dimension)};
    if (scene.parts_of(PartKind::spheres).empty()) {
        made_from.push_back(fmt::format("particles.spacing = {} m", file.spacing));
        now.push_back(fmt::format("particles.spacing = {} m", *scene.particles.spacing));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto line = [&](bool periodic) {
            return fmt::format("flow.periodic along {} = {}", "xyz"[axis], periodic ? "yes" : "no");
        };
        made_from.push_back(line(file.periodic.at(axis)));
        now.push_back(line(*scene.flow.periodic.at(axis)));
    }
    const auto line = [](const std::string& name, const std::string& kind) {
        return fmt::format("part '{}' = {}", name, kind);
    };
    for (const auto& part : file.parts) made_from.push_back(line(part.name, to_string(part.kind)));
    for (const Part& part : scene.parts)
        if (*part.enabled)
            now.push_back(
                line(part.name, part.is_wall_for_spheres() ? to_string(PartKind::rigid) : to_string(*part.kind)));
    return difference(made_from, now);
}

/// Smallest and largest of some constants.
struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -low;

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] std::string text(const char* unit) const {
        if (low > high) return "none";
        const std::string least = quantity_text(low, unit), most = quantity_text(high, unit);
        return least == most ? least : least + " to " + most;
    }
};

Origin origin_of(const std::filesystem::path& file, const ParticleSet& particles,
                 const std::vector<const Join*>& joins) {
    Origin origin{"from", file.string(), {}, {}};
    std::vector<Range> bonds(particles.parts.size()), hinges(bonds), dihedrals(bonds);
    const auto part_of = [&](int particle) {
        return static_cast<std::size_t>(particles.part[static_cast<std::size_t>(particle)]);
    };
    for (const Bond& bond : particles.bonds)
        if (bond.join < 0 && part_of(bond.a) == part_of(bond.b)) bonds[part_of(bond.a)].add(bond.stiffness);
    for (const Hinge& hinge : particles.hinges) hinges[part_of(hinge.centre)].add(hinge.stiffness);
    for (const Dihedral& dihedral : particles.dihedrals) dihedrals[part_of(dihedral.b)].add(dihedral.stiffness);
    for (std::size_t n = 0; n < particles.parts.size(); ++n) {
        if (particles.parts[n].kind != PartKind::elastic) continue;
        const auto cells =
            std::ranges::count_if(particles.cells, [&](const SolidCell& cell) { return part_of(cell.particle) == n; });
        if (cells > 0) {
            origin.springs.emplace_back("cells " + particles.parts[n].name,
                                        count_text(static_cast<std::size_t>(cells), "cell") + ", from the file");
            continue;
        }
        const std::string folds = particles.dihedrals.empty() ? "" : ", k_d " + dihedrals[n].text("J");
        origin.springs.emplace_back(
            "springs " + particles.parts[n].name,
            fmt::format("k_b {}, k_a {}{}, from the file", bonds[n].text("N/m"), hinges[n].text("J"), folds));
    }
    for (std::size_t join = 0; join < joins.size(); ++join) {
        Range stiffness;
        std::size_t count = 0;
        for (const Bond& bond : particles.bonds) {
            if (bond.join != static_cast<int>(join)) continue;
            stiffness.add(bond.stiffness);
            ++count;
        }
        origin.springs.emplace_back(
            "join " + *joins[join]->name,
            fmt::format("{} of k_b {}, from the file", count_text(count, "bond"), stiffness.text("N/m")));
    }
    return origin;
}

}  // namespace

std::vector<std::string> values_behind_particles(const Scene& scene) {
    const bool of_spheres = !scene.parts_of(PartKind::spheres).empty();
    std::vector<std::string> lines;
    std::istringstream text(resolved_scene(scene));
    std::string table, part;
    for (std::string line; std::getline(text, line);) {
        if (const std::string opened = table_in(line); !opened.empty()) {
            table = opened;
            continue;
        }
        const auto equals = line.find(" = ");
        if (equals == std::string::npos) continue;
        const std::string key = line.substr(0, equals);
        const bool is_in_file = of_spheres && key == "initial_velocity";  // theirs is in the set, that of solids is not
        if (!matters(table, key) && !is_in_file) continue;
        // A part's first key is its name, as a selection's and a join's.
        const bool is_named = table == "part" || table == "select" || table == "join";
        if (is_named && key == "name") {
            part = line.substr(equals + 4, line.size() - equals - 5);
            continue;
        }
        std::string whole_key = table.empty() ? "" : table + ".";
        if (is_named) whole_key += part + ".";
        lines.push_back(whole_key + line);
    }
    return lines;
}

ParticlesWithOrigin particles_from_file(const std::filesystem::path& file, const Scene& scene) {
    StoredParticles stored = read_particle_file(file);
    std::string differs = difference(stored.particles, scene);
    if (differs.empty() && !stored.made_from.empty())
        differs = difference(stored.made_from, values_behind_particles(scene));
    if (!differs.empty())
        throw InputError(SourceLocation{file.string(), 0, 0}, "the particles were made for another scene:" + differs,
                         "Make them anew, with the same --set as this run has: dmp mesh SCENE --particles FILE.h5");
    Origin origin = origin_of(file, stored.particles, scene.joins_of_enabled());
    return {std::move(stored.particles), std::move(origin)};
}

}  // namespace dmp::cli
