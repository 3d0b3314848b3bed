// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "study/formula_value.hpp"
#include "study/study.hpp"

namespace dmp::study {

/// Largest number of runs of a study. Each is a process, a folder and a row of results.csv: at a second a run a million
/// take twelve days of a processor, and more files than many file systems hold. A larger one is a slip of the pen.
inline constexpr int most_runs = 1'000'000;

/// One run of a study: what its keys are set to.
struct Point {
    std::string name;                 ///< "0012_5f3a90c1": its number, and a hash of the scene and of its values
    std::vector<VariedValue> values;  ///< one for each key, in the order of Study::keys()
};

/// The runs of a study, in order: of a grid the first key varies slowest. They are worked out one by one, as asked for,
/// by one thread.
class Points {
  public:
    /// Throws InputError where keys that vary together have different numbers of values, or there are more than
    /// most_runs runs.
    explicit Points(const Study& study);

    [[nodiscard]] std::size_t size() const { return size_; }
    /// The run with this index, from 0 on. Throws std::out_of_range, or InputError where a formula has no value there.
    [[nodiscard]] Point at(std::size_t index) const;
    /// Its values alone, one for each key. Throws likewise.
    [[nodiscard]] std::vector<VariedValue> values_at(std::size_t index) const;
    /// How many values of formulas have been worked out for all runs asked for; others were known.
    [[nodiscard]] std::size_t formulas_worked_out() const { return formula_values_.worked_out(); }

  private:
    [[nodiscard]] std::vector<VariedValue> axis_values(std::size_t axis, std::size_t index) const;

    const Study& study_;
    std::vector<VariedKey> keys_;
    std::size_t size_ = 0;
    std::string scene_hash_;
    mutable FormulaValues formula_values_;
    std::vector<std::vector<std::uint32_t>> strata_;  ///< Latin hypercube: of each axis, the stratum of each sample
};

/// What a run sets, as --set takes it: the study's overrides and the values of its point, "particles.spacing=\"0.1
/// mm\"".
[[nodiscard]] std::vector<std::string> overrides(const Study& study, const Point& point);

/// A hash of all that the runs depend on in the study and its scene, 16 hex digits; not of its results, nor of the
/// scene's title, threads and pictures.
[[nodiscard]] std::string identity_of(const Study& study);

}  // namespace dmp::study
