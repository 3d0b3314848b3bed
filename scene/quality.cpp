// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Defaults that depend on the scene's quality, and the origin of a default for the user.
#include <algorithm>

#include "scene/read_scene.hpp"
#include "scene/schema.hpp"

namespace dmp::scene {

const std::string& Default::at(Quality quality) const {
    if (!depends_on_quality() || quality == Quality::standard) return value;
    return quality == Quality::draft ? draft : fine;
}

std::string default_origin(const Scene& scene, const std::string& key) {
    const auto facts = schema().facts();
    const std::string pattern = key_pattern(key);
    const bool follows = std::any_of(facts.begin(), facts.end(), [&](const KeyFacts& fact) {
        return fact.path == pattern && fact.fallback.depends_on_quality();
    });
    if (!follows || !scene.quality.given()) return "default";
    return "quality = \"" + to_string(*scene.quality) + "\" at " + scene.quality.location.text();
}

}  // namespace dmp::scene
