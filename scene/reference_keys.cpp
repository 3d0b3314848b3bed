// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/reference_keys.hpp"

namespace dmp::scene {

// Columns as in schema.cpp.
// clang-format off

std::vector<Key<Reference>> reference_keys() {
    return {
        {"name", &Reference::name, name(), not_given,
         "Name of the reference, for --set reference.NAME.until=\"1 s\"."},
        {"measure", &Reference::measure, name(), required, "Measure that it is for."},
        {"column", &Reference::column, text_not_empty(), not_given,
         "Which of the measure's columns it is for, where there are several: the end of the column's name in "
         "measures.csv after the measure's name and '_', such as \"x\"."},
        {"formula", &Reference::formula, any_formula("0.1 m/s * exp(-t / 2 s)"), not_given,
         "What the column should be, as a formula of t with the dimension of the column; or give file."},
        {"file", &Reference::file, text_not_empty(), not_given,
         "CSV file, relative to the scene's folder or absolute, whose heading has the columns time [UNIT] and the "
         "measure's, named as in measures.csv; straight lines join its values (docs/results.md)."},
        {"from", &Reference::from, quantity("1 s", not_negative), "0 s",
         "Time from which it holds; what was before does not count."},
        {"until", &Reference::until, quantity("2 s", positive), not_given,
         "Time until which it holds; to the end by default."},
        {"source", &Reference::source, text_not_empty(), required,
         "Where it is from: a paper, or how it was worked out."},
    };
}
// clang-format on

}  // namespace dmp::scene
