// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Defaults that depend on the scene's quality and scheme, and the origin of a default for the user.
#include <stdexcept>

#include "scene/read_scene.hpp"
#include "scene/schema.hpp"
#include "scene/step_margins.hpp"

namespace dmp::scene {

const std::string& ByQuality::at(Quality quality) const {
    switch (quality) {
        case Quality::draft:
            return draft;
        case Quality::standard:
            return standard;
        case Quality::fine:
            return fine;
    }
    throw std::logic_error("a quality that is none");
}

const ByQuality& Default::of(FluidScheme scheme) const {
    switch (scheme) {
        case FluidScheme::corrected:
            return values.corrected;
        case FluidScheme::plain:
            return values.plain;
    }
    throw std::logic_error("a scheme that is none");
}

std::string default_origin(const Scene& scene, const std::string& key) {
    const auto facts = schema().facts();
    const std::string pattern = key_pattern(key);
    const auto& scheme = scene.numerics.scheme;
    std::string origin;
    for (const KeyFacts& fact : facts) {
        if (fact.path != pattern) continue;
        if (fact.fallback.depends_on_scheme() && scheme.given())
            origin = "numerics.scheme = \"" + to_string(*scheme) + "\" at " + scheme.location.text();
        if (fact.fallback.depends_on_quality(*scheme) && scene.quality.given())
            origin += (origin.empty() ? "" : ", ") + ("quality = \"" + to_string(*scene.quality) + "\" at ") +
                      scene.quality.location.text();
    }
    if (origin.empty()) origin = "default";
    const std::string lowered = lowered_text(scene, key);
    return lowered.empty() ? origin : origin + ", " + lowered;
}

}  // namespace dmp::scene
