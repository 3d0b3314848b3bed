// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "base/errors.hpp"

namespace dmp::scene {

/// A text of the user with the locations of its characters, for error messages.
struct WrittenText {
    std::string text;
    SourceLocation location;         ///< of the whole value: its opening quote
    SourceLocation first_character;  ///< unknown if the text contains escapes

    /// Location of the character at byte `offset`; that of the whole value if the columns are unknown.
    [[nodiscard]] SourceLocation at(std::size_t offset) const;
};

}  // namespace dmp::scene
