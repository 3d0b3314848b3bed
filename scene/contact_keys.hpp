// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/scene.hpp"
#include "scene/schema.hpp"

namespace dmp::scene {

using Contact = decltype(Scene::contact);

/// Keys of [contact].
std::vector<Key<Contact>> contact_keys();

}  // namespace dmp::scene
