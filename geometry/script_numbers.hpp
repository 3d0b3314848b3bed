// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/script_tokens.hpp"

namespace dmp::geometry {

/// The numbers of a script that can be told without running it.
class ScriptNumbers {
  public:
    /// Finds the names that one statement alone sets, to a number. `tokens` must outlive this object.
    explicit ScriptNumbers(const std::vector<ScriptToken>& tokens);

    /// The value of an expression, the tokens from `begin` to before `end`: numbers, names that have one, + - * / ^ and
    /// brackets. None where there is more in it.
    [[nodiscard]] std::optional<double> value(std::size_t begin, std::size_t end) const;

  private:
    const std::vector<ScriptToken>& tokens_;
    std::map<std::string, double> known_;
};

}  // namespace dmp::geometry
