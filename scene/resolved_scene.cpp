// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/read_scene.hpp"
#include "scene/schema.hpp"

namespace dmp {

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
    std::string section;
    for (const auto& key : schema().scene) {
        if (key.facts.section() != section) {
            section = key.facts.section();
            text += "\n[" + section + "]\n";
        }
        write_key(text, scene, key);
    }
    write_items(text, scene.parts, "part", schema().part);
    write_items(text, scene.regions, "region", schema().region);
    write_items(text, scene.measures, "measure", schema().measure);
    write_items(text, scene.solidify, "solidify", schema().solidify);
    write_items(text, scene.breaking, "break", schema().breaking);
    return text;
}

}  // namespace dmp
