// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace dmp::cli {

/// What this program was built from.
struct BuildFacts {
    std::string version;     ///< of dmp: "0.1.0"
    std::string build_type;  ///< "Release"
    std::string compiler;    ///< "g++ 12.2.0"
    std::string sanitizers;  ///< "address,undefined"; empty: none
    std::string libraries;   ///< "VTK 9.1.0, gmsh 4.8.4"; empty: built for clusters, without them
};

[[nodiscard]] BuildFacts build_facts();

/// BuildFacts::libraries; workstation.cpp and cluster.cpp each have one of it (workstation.hpp).
[[nodiscard]] std::string workstation_libraries();

}  // namespace dmp::cli
