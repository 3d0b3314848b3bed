// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/read_scene.hpp"
#include "scene/schema.hpp"

namespace dmp::scene {

namespace {

template <class Owner>
void write_key(std::string& text, const Owner& owner, const Key<Owner>& key) {
    const std::string value = key.write(owner);
    if (!value.empty()) text += key.facts.name() + " = " + value + "\n";
}

template <class Item>
void write_items(std::string& text, const std::vector<Item>& items, const std::string& what,
                 const std::vector<Key<Item>>& keys) {
    for (const auto& item : items) {
        text += "\n[[" + what + "]]\n";
        for (const auto& key : keys) {
            if (key.facts.is_for(kind_of(item))) write_key(text, item, key);
        }
    }
}

}  // namespace

std::string resolved_scene(const Scene& scene) {
    std::string text;
    std::string opened;
    for (const auto& key : schema().scene) {
        std::string line;
        write_key(line, scene, key);
        if (line.empty()) continue;
        if (const std::string section = key.facts.section(); section != opened) {
            text += "\n[" + section + "]\n";
            opened = section;
        }
        text += line;
    }
    write_items(text, scene.selections, "select", schema().select);
    write_items(text, scene.parts, "part", schema().part);
    write_items(text, scene.joins, "join", schema().join);
    write_items(text, scene.species, "species", schema().species);
    write_items(text, scene.contact_pairs, "contact_pair", schema().contact_pair);
    write_items(text, scene.forces, "force", schema().force);
    write_items(text, scene.moving_shapes, "moving_shape", schema().moving_shape);
    write_items(text, scene.regions, "region", schema().region);
    write_items(text, scene.measures, "measure", schema().measure);
    write_items(text, scene.references, "reference", schema().reference);
    write_items(text, scene.solidify, "solidify", schema().solidify);
    write_items(text, scene.breaking, "break", schema().breaking);
    return text;
}

}  // namespace dmp::scene
