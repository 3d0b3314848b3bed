// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/elastic/spring_bodies.hpp"
#include "solver/results/run_summary.hpp"

namespace dmp::solver {

/// By number of SpringBodies::names().
Aggregate aggregate_of(const SpringBodies& springs, int origin);

/// What stands in the columns of a measure of an aggregate.
std::vector<double> values_of(const Aggregate& aggregate);

}  // namespace dmp::solver
