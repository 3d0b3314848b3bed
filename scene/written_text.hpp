// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "base/errors.hpp"

namespace dmp::scene {

/// A text the user wrote and where its characters stand, so that an error can point into it.
struct WrittenText {
    std::string text;
    SourceLocation location;         ///< of the whole value: its opening quote
    SourceLocation first_character;  ///< not known where escapes make columns meaningless

    /// The place of the character at byte `offset`; that of the whole value where the text's columns are not known.
    [[nodiscard]] SourceLocation at(std::size_t offset) const;
};

}  // namespace dmp::scene
