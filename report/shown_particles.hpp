// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "report/uses.hpp"
#include "solver/results/frame_source.hpp"

namespace dmp::report {

/// A quantity that particles of a group can be coloured by.
struct ShownField {
    std::string name;  ///< "speed" is the magnitude of the velocity
    std::string unit;
};

/// A group's particles at one time.
struct GroupAtTime {
    std::vector<float> position;             ///< x, y, z of each [m]
    std::vector<float> radius;               ///< of spheres, else empty [m]
    std::vector<std::vector<float>> values;  ///< of each field, one per particle; NaN: the frame has none

    [[nodiscard]] std::size_t size() const { return position.size() / 3; }
};

struct ShownGroup {
    std::string name;       ///< as in FrameGroup
    std::size_t every = 1;  ///< every n-th particle is shown
    std::vector<ShownField> fields;
    std::vector<std::int32_t> triangles;  ///< of a surface, shown instead of its points
    std::vector<GroupAtTime> at;          ///< of each time; of walls at rest one for all
};

/// What a page shows of a run's frames.
struct ShownParticles {
    std::vector<double> times;  ///< of the frames shown [s]
    std::size_t frames_of_run = 0;
    double spacing = 0;  ///< of particles [m]
    std::vector<ShownGroup> groups;
    std::vector<std::string> notes;  ///< of what could not be shown
};

/// Reads as many frames and particles as `bytes` of a page hold (particle_plan.hpp). What cannot be read or has no
/// place near the others is left out, with a note. `times` is empty where no frame can be read.
[[nodiscard]] ShownParticles read_shown_particles(const FrameSource& source, std::size_t bytes);

/// The bytes of a group at one time: places with 16 bits an axis, radii with 16, values with 8.
[[nodiscard]] std::size_t bytes_of(const ShownGroup& group, std::size_t particles, bool flat);

/// Whether all particles lie in one plane z.
[[nodiscard]] bool is_flat(const ShownParticles& particles);

}  // namespace dmp::report
