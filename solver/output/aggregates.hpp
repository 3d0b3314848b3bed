// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/elastic/spring_bodies.hpp"
#include "solver/results/run_summary.hpp"

namespace dmp::solver {

/// By number of SpringBodies::names().
Aggregate aggregate_of(const SpringBodies& springs, int origin);

/// Columns of an aggregate in measures.csv, and what stands in them.
struct AggregateColumn {
    const char *ending, *unit;
    double (*value)(const Aggregate&);
};
const std::vector<AggregateColumn>& aggregate_columns();

}  // namespace dmp::solver
