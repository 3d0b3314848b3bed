// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/argument_checks.hpp"

#include "cli/version.hpp"

namespace dmp::cli {

std::string at_least_one(const std::string& text) {
    const bool digits = !text.empty() && text.size() < 6 && text.find_first_not_of("0123456789") == std::string::npos;
    return digits && std::stoi(text) > 0 ? "" : "'" + text + "' is not a number of them; give a whole one from 1 on";
}

std::string a_frame_format(const std::string& text) {
    if (text != "vtk" && text != "hdf5") return "'" + text + "' is no format of frames; there are 'vtk' and 'hdf5'";
    return text == "vtk" && build_facts().libraries.empty()
               ? "this dmp was built for clusters, without VTK; leave it out for frames in HDF5"
               : "";
}

std::optional<VectorUnit> vector_unit_called(const std::string& text) {
    for (const VectorUnit unit : {VectorUnit::avx2, VectorUnit::avx512}) {
        if (to_string(unit) == text) return unit;
    }
    return std::nullopt;
}

std::string a_vector_unit(const std::string& text) {
    return vector_unit_called(text) ? "" : "'" + text + "' is no vector unit; there are 'avx2' and 'avx512'";
}

}  // namespace dmp::cli
