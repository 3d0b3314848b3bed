// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/written_text.hpp"

#include <algorithm>

namespace dmp::scene {

SourceLocation WrittenText::at(std::size_t offset) const {
    if (!first_character.known() || first_character.line == 0) return location;
    SourceLocation found = first_character;
    for (std::size_t i = 0; i < std::min(offset, text.size()); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (byte == '\n') {
            ++found.line;
            found.column = 1;
        } else if ((byte & 0xC0U) != 0x80U) {  // columns count characters, not UTF-8 continuation bytes
            ++found.column;
        }
    }
    return found;
}

}  // namespace dmp::scene
