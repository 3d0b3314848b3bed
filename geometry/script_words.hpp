// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace dmp::geometry {

/// What gmsh would do at this word wherever it stands in a script ("run a program"); empty: nothing of harm.
[[nodiscard]] std::string_view harm_of_word(std::string_view word);

/// What it would do at this word where a text or another word follows; elsewhere it is a name as any.
[[nodiscard]] std::string_view harm_of_command(std::string_view word);

/// Whether a text may follow the word: options of constants, and macros.
[[nodiscard]] bool takes_a_text(std::string_view word);

/// Whether the word begins an expression whose value is a text.
[[nodiscard]] bool begins_a_text(std::string_view word);

/// Whether a script may read and set gmsh's option CATEGORY.NAME.
[[nodiscard]] bool is_harmless_option(std::string_view category, std::string_view name);

/// Whether the word is one of gmsh's categories of options.
[[nodiscard]] bool is_option_category(std::string_view word);

/// Whether a size field of this type (Field[1] = TYPE) only calculates.
[[nodiscard]] bool is_harmless_field(std::string_view type);

/// The word at which gmsh, while it passes over statements, goes on reading, where a text or a longer word holds it;
/// empty: none does.
[[nodiscard]] std::string_view block_word_within(std::string_view text);

}  // namespace dmp::geometry
