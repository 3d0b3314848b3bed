// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/uses.hpp"
#include "solver/parallel/resources.hpp"

namespace dmp::cli {

// What is wrong with the text of an argument; empty: nothing.

[[nodiscard]] std::string at_least_one(const std::string& text);
[[nodiscard]] std::string a_frame_format(const std::string& text);
[[nodiscard]] std::string a_vector_unit(const std::string& text);

[[nodiscard]] std::optional<VectorUnit> vector_unit_called(const std::string& text);

}  // namespace dmp::cli
