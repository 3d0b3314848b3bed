// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"

namespace dmp::tests {

/// good_scene with `found` replaced, or the override `found`, and the message it must give.
struct Fault {
    const char* name;
    const char* found;
    const char* replacement;
    const char* message;
};

inline void PrintTo(const Fault& fault, std::ostream* stream) { *stream << fault.name; }
inline std::string name_of(const testing::TestParamInfo<Fault>& info) { return info.param.name; }

}  // namespace dmp::tests
