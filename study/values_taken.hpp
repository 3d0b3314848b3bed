// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study/points.hpp"
#include "study/study.hpp"

namespace dmp::study {

/// What a key is set to in the runs of a study.
struct ValuesTaken {
    std::vector<VariedValue> values;  ///< each once, in the order of the runs; of a range of a Latin hypercube its ends
    std::size_t count = 0;            ///< how many different ones there are
    bool is_formula = false;          ///< it follows other keys
    bool log_range = false;           ///< evenly spaced in its logarithm

    [[nodiscard]] bool varies() const { return count > 1; }
    /// Whether all of them are numbers.
    [[nodiscard]] bool are_numbers() const;
};

/// Of each key, in the order of Study::keys().
[[nodiscard]] std::vector<ValuesTaken> values_taken(const Study& study, const Points& points);

}  // namespace dmp::study
