// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace dmp::scene {

/// Advice for a key that had another name in version 0.1; empty for all other keys.
/// `pattern`: "accuracy.kernel", "contact_pair.*.law".
std::string advice_for_renamed_key(const std::string& pattern);

/// The same for a value of the key at `path`: "part.leaflets.kind", "springs".
std::string advice_for_renamed_value(const std::string& path, const std::string& value);

}  // namespace dmp::scene
