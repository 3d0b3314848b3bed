// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace dmp::geometry {

/// The text of a gmsh .geo script, for what gmsh itself does not tell: it runs a loop without its end once, drops
/// statements of a last line without line break, and keeps no record of constants that cannot be set from outside.
class GeoText {
  public:
    explicit GeoText(const std::string& text);

    /// The first line (from 1) that reads "name =", outside comments and strings; 0 when there is none.
    [[nodiscard]] int line_of_assignment(const std::string& name) const;

    struct Unclosed {
        std::string word;  ///< "If", "For", "EndIf" or "EndFor"
        int line = 0;
    };
    /// An If or For without its end, or an end without its beginning.
    [[nodiscard]] std::optional<Unclosed> unclosed_block() const;

    /// The last line (from 1) when it has no line break and more than one statement, else 0: gmsh drops all of them but
    /// the first.
    [[nodiscard]] int line_cut_short() const;

  private:
    std::string code_;  ///< comments and strings blanked, line breaks kept
};

}  // namespace dmp::geometry
