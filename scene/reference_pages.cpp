// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The reference pages in docs/scene/, one for each table of a scene.
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include "scene/read_scene.hpp"
#include "scene/schema.hpp"

namespace dmp::scene {

namespace {

struct Table {
    std::string_view name, meaning;
};

/// In the usual order of a scene file.
constexpr std::array tables{
    Table{"top", "The keys before the first table."},
    Table{"geometry",
          "The CAD file, its unit and parameters, and the repair of its surfaces (docs/cad.md, docs/repair.md)."},
    Table{"select",
          "Names faces of the geometry by position and direction, so that a part can refer to them (docs/cad.md)."},
    Table{"particles", "Spacing and arrangement of the particles (docs/meshing.md)."},
    Table{"part",
          "Kind and material of each part: a fluid, a rigid wall, an elastic solid, spheres, or a wall for spheres "
          "(docs/elastic.md, docs/spheres.md)."},
    Table{"join", "Bonds between two elastic solids, or an elastic solid and a wall (docs/elastic.md)."},
    Table{"contact_pair", "How spheres of two parts interact when they touch (docs/contact.md)."},
    Table{"box", "The periodic box of a scene of spheres without a geometry."},
    Table{"flow", "What drives the fluid, periodic directions and planes of symmetry, and its initial state."},
    Table{"contact", "The short-range repulsion between solids, and between solids and the fluid."},
    Table{"numerics", "Numerical methods and their parameters; quality sets several of them (docs/accuracy.md)."},
    Table{"run", "Duration, threads and when to stop."},
    Table{"output", "Frames, measures and pictures (docs/results.md)."},
    Table{"species", "Substances that are dissolved in the fluid and diffuse (docs/species.md)."},
    Table{"force", "Forces on parts (docs/driving.md)."},
    Table{"moving_shape", "Shapes that move and push parts (docs/driving.md)."},
    Table{"region", "Boxes that residence times, seeds and measures refer to."},
    Table{"measure", "Quantities written to measures.csv over time (docs/results.md)."},
    Table{"reference", "What a measure should be, where an exact answer or published data is known (docs/results.md)."},
    Table{"solidify", "Fluid that turns solid near seeds: clots and calcification (docs/solidify.md)."},
    Table{"break", "When bonds break (docs/solidify.md)."},
};

std::string table_of(const KeyFacts& key) {
    const std::string name = key.path.substr(0, key.path.find('.'));
    return key.path.find('.') == std::string::npos ? "top" : name;
}

bool is_list(std::string_view table) { return std::ranges::find(item_lists(), table) != item_lists().end(); }

std::string heading_of(std::string_view table) {
    if (table == "top") return "Top of the file";
    return (is_list(table) ? "`[[" : "`[") + std::string(table) + (is_list(table) ? "]]`" : "]`");
}

/// Replaces names of documentation pages by links.
std::string with_links(std::string_view text) {
    std::string linked(text);
    for (std::size_t at = linked.find("docs/"); at != std::string::npos; at = linked.find("docs/", at + 1)) {
        const std::size_t end = linked.find(".md", at) + 3;
        const std::string page = linked.substr(at + 5, end - at - 5);
        linked.replace(at, end - at, "[" + page + "](../" + page + ")");
    }
    return linked;
}

constexpr std::string_view note =
    "This page is generated from the program's table of keys; a test compares the two. `dmp explain KEY` prints one "
    "entry.\n";

}  // namespace

std::vector<std::string> reference_tables() {
    std::vector<std::string> names;
    for (const Table& table : tables) names.emplace_back(table.name);
    for (const KeyFacts& key : schema().facts())
        if (std::ranges::find(names, table_of(key)) == names.end())
            throw std::logic_error("the reference has no page for the key " + key.path);
    return names;
}

std::string reference_index() {
    std::string text =
        "# Scene reference\n\n"
        "A scene is one TOML file. Each dimensional value is a quantity in quotes with its unit, such as `\"3.5 "
        "mPa*s\"`; a bare\nnumber is refused where a unit is needed. 2-D scenes are 1 m deep, so masses are in kg, "
        "forces in N and "
        "energies in J.\nFormulas may use `t`, `x`, `y`, `z`, `pi` and the usual functions; their dimension is "
        "checked. On the command line, an\nentry of a list is selected by its name: `--set "
        "part.leaflets.enabled=false`.\n\n"
        "| table | contents |\n|---|---|\n";
    for (const Table& table : tables)
        text += "| [" + heading_of(table.name) + "](" + std::string(table.name) + ".md) | " +
                with_links(table.meaning) + " |\n";
    return text + "\n" + std::string(note);
}

std::string reference_page(const std::string& name) {
    const auto* const table = std::ranges::find(tables, name, &Table::name);
    if (table == tables.end()) throw std::out_of_range("a scene has no table '" + name + "'");
    std::string text = "# " + heading_of(name) + "\n\n" + with_links(table->meaning) + "\n\n";
    if (is_list(name)) text += "A list: one `[[" + name + "]]` for each.\n\n";
    text += scene_reference([&](const KeyFacts& key) { return table_of(key) == name; });
    return text + "\n[All tables](index.md). " + std::string(note);
}

}  // namespace dmp::scene
