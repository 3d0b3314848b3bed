// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a .geo script, as far as dmp looks at it itself, before gmsh does in another process.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/errors.hpp"
#include "geometry/check_script.hpp"
#include "geometry/geo_text.hpp"
#include "tests/modules.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const dmp::geometry::GeoText script(text);
    const int lines = 1 + static_cast<int>(std::count(text.begin(), text.end(), '\n'));
    const auto need_line = [&](int line) {
        if (line < 0 || line > lines) std::abort();
    };
    if (const auto open = script.unclosed_block()) need_line(open->line);
    need_line(script.line_cut_short());
    need_line(script.line_of_assignment("width"));
    try {
        const auto tokens = dmp::geometry::script_tokens(text, "fuzzed.geo");
        for (const auto& token : tokens) need_line(token.line);
        dmp::geometry::check_script(tokens, {"fuzzed.geo"});
    } catch (const dmp::InputError& error) {
        need_line(error.where().line);
    }
    return 0;
}
