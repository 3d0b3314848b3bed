// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "scene/scene.hpp"
#include "scene/toml_node.hpp"

namespace dmp::scene {

/// Checks values of one key, as --set would give them to a scene: type, unit and range. What several keys have to agree
/// on is checked when a scene is read with all of them.
class ValueCheck {
  public:
    /// `key`: "particles.spacing", "part.leaflets.density", "geometry.parameters.width". Throws InputError at
    /// `location` for an unknown key, an entry that the scene's list does not have, or a key that its kind does not
    /// have.
    ValueCheck(const Scene& scene, const std::string& key, const SourceLocation& location);

    /// Throws the InputError, with the value's location, that reading it in a scene would throw.
    void operator()(const TomlNode& value) const { read_(value); }

  private:
    std::function<void(const TomlNode&)> read_;
};

}  // namespace dmp::scene
