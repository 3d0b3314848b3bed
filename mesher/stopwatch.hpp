// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <ctime>
#include <string>

#include "mesher/mesh.hpp"

namespace dmp::mesher {

/// Takes down how long the stages of a mesh are, and the most memory that the program has had.
class Stopwatch {
  public:
    explicit Stopwatch(MeshReport::Cost& cost) : cost_(cost), last_(std::chrono::steady_clock::now()) {}

    /// What went on since the last lap was this stage; adds up where it comes again.
    void lap(const std::string& stage);

  private:
    MeshReport::Cost& cost_;
    std::chrono::steady_clock::time_point last_;
    std::clock_t last_processor_ = std::clock();
};

}  // namespace dmp::mesher
