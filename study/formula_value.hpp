// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "scene/toml_node.hpp"
#include "study/study.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// Takes a formula, or a list of them for a key that takes a list. Throws InputError where it is neither.
void read_formulas(const TomlNode& node, Vary& vary);

/// Values of formulas that have been worked out: the runs of a grid take the same few numbers again and again.
class FormulaValues {
  public:
    /// The value of a formula of numbers, constant_formula's. Throws InputError as that does.
    [[nodiscard]] Quantity of(const WrittenText& formula, const std::string& subject);
    /// How many have been worked out, not found.
    [[nodiscard]] std::size_t worked_out() const { return worked_out_; }

  private:
    std::unordered_map<std::string, Quantity> known_;  ///< by the formula's text
    std::size_t worked_out_ = 0;
};

/// The value of a key that has formulas, from those of the keys before it. Throws InputError where a name in it is none
/// of theirs, or units do not fit together.
[[nodiscard]] VariedValue value_of(const Vary& vary, const std::vector<VariedKey>& keys,
                                   const std::vector<VariedValue>& values, FormulaValues& known);

}  // namespace dmp::study
