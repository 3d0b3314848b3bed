// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "base/errors.hpp"

namespace dmp::geometry {

/// A script as gmsh is to read it: the text that was checked, and no other. Comments are gone, files that it includes
/// stand in it, and gmsh's places can be told in the script as it was written.
class CheckedScript {
  public:
    /// Reads the script and what it includes, and checks it (check_script). Files may be included from the folder of
    /// the script and from those in it, links followed. Throws InputError.
    explicit CheckedScript(const std::string& file);

    [[nodiscard]] const std::string& text() const { return text_; }

    /// Where a line of text() (from 1) was written.
    [[nodiscard]] SourceLocation written_at(int line) const;

  private:
    struct Place {
        int file = 0, line = 0;
    };

    std::string text_;
    std::vector<std::string> files_;
    std::vector<Place> places_;  ///< of each line
};

}  // namespace dmp::geometry
