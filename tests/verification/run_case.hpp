// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/geometry.hpp"
#include "mesher/mesh_spheres.hpp"
#include "scene/read_scene.hpp"
#include "solver/simulation.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// Keeps the last frame of a run.
class LastFrame : public FrameSink {
  public:
    void write(const Frame& written) override { frame = written; }
    Frame frame;
};

/// A case of the repository, with what a test sets in it.
inline Scene scene_of_case(const std::string& name, const std::vector<std::string>& overrides) {
    return read_scene(DMP_SOURCE_DIR "/cases/" + name, overrides);
}

/// What the scene's geometry is filled with, or where its spheres are.
inline ParticleSet particles_of(const Scene& scene) {
    if (is_of_spheres(scene)) return mesh_spheres(scene).particles;
    GeometryOptions cad_geometry;
    cad_geometry.file = scene.directory + "/" + scene.geometry.file.value;
    cad_geometry.unit = scene.geometry.unit;
    cad_geometry.chord_error = 1e-3 * scene.particles.spacing;
    for (const auto& [parameter, value] : scene.geometry.parameters) cad_geometry.parameters[parameter] = value;
    return mesh(read_geometry(cad_geometry), scene).particles;
}

/// Runs a scene without writing anything; frames go to the sink. Few particles are fastest on one thread.
inline RunSummary run_scene(const Scene& scene, const ParticleSet& particles, double until, FrameSink* sink = nullptr,
                            int threads = 0) {
    Simulation simulation(scene, particles, threads);
    RunOptions options;
    options.until = until;
    options.sink = sink;
    return simulation.run(options);
}

/// Meshes and runs a case of the repository.
inline RunSummary run_case(const std::string& name, const std::vector<std::string>& overrides, double until,
                           FrameSink* sink = nullptr, int threads = 0) {
    const Scene scene = scene_of_case(name, overrides);
    return run_scene(scene, particles_of(scene), until, sink, threads);
}

/// A value with all its digits.
inline std::string quantity(double value, const std::string& unit = "") {
    std::array<char, 32> digits{};
    (void)std::snprintf(digits.data(), digits.size(), "%.17g", value);
    return digits.data() + (unit.empty() ? "" : " " + unit);
}

/// An override of it.
inline std::string set_to(const std::string& key, double value, const std::string& unit = "") {
    return key + "=" + quantity(value, unit);
}

/// The same of a point or vector.
inline std::string set_to(const std::string& key, const std::array<double, 3>& value, const std::string& unit) {
    std::string list;
    for (const double axis : value) list += (list.empty() ? "\"" : ", \"") + quantity(axis, unit) + '"';
    return key + "=[" + list + "]";
}

/// One measure of a run, by name.
inline std::vector<double> column(const MeasureSeries& series, const std::string& name) {
    const auto found = std::find(series.names.begin(), series.names.end(), name);
    if (found == series.names.end()) throw std::invalid_argument("no measure " + name);
    std::vector<double> values;
    for (const auto& row : series.rows) values.push_back(row[static_cast<std::size_t>(found - series.names.begin())]);
    return values;
}

/// The part of a column with from <= time <= to.
inline std::vector<double> between(const MeasureSeries& series, const std::string& name, double from, double to) {
    const auto all = column(series, name);
    std::vector<double> values;
    for (std::size_t k = 0; k < all.size(); ++k)
        if (series.time[k] >= from && series.time[k] <= to) values.push_back(all[k]);
    return values;
}

inline const FrameGroup& required_group(const Frame& frame, const std::string& name) {
    for (const FrameGroup& group : frame.groups)
        if (group.name == name) return group;
    throw std::invalid_argument("the frame has no group " + name);
}

inline const FrameField& required_field(const FrameGroup& group, const std::string& name) {
    for (const FrameField& field : group.fields)
        if (field.name == name) return field;
    throw std::invalid_argument("the group has no field " + name);
}

inline double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}
inline double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }
inline double smallest(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

}  // namespace dmp::tests
