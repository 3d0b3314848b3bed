// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace dmp::solver {

/// A named array over the particles or bonds of a group, components interleaved.
struct FrameField {
    std::string name;    ///< snake_case, without a unit
    std::string unit;    ///< "m/s", "Pa"; "1" when dimensionless
    int components = 1;  ///< 1, 3 for vectors (z = 0 in 2-D), 6 for symmetric tensors: xx, yy, zz, xy, yz, xz
    std::vector<float> values;
};

/// Particles that are shown together: the fluid, the solids, the walls.
struct FrameGroup {
    std::string name;             ///< "fluid", "solid", "spheres", "walls" (at rest) or "moving_walls"
    std::vector<float> position;  ///< x, y, z of each particle [m]
    std::vector<std::int64_t> id;
    std::vector<std::int32_t> part;  ///< index into Frame::parts
    std::vector<FrameField> fields;
    std::vector<std::int32_t> bond_ends;  ///< two indices into this group per bond
    std::vector<FrameField> bond_fields;
    std::vector<std::int32_t> triangles{};  ///< three indices into this group per triangle: walls of spheres

    [[nodiscard]] std::size_t size() const { return id.size(); }
    [[nodiscard]] std::size_t bonds() const { return bond_ends.size() / 2; }
};

/// The output of a run at one time.
struct Frame {
    double time = 0;  ///< [s]
    long step = 0;
    double spacing = 0;              ///< particle spacing [m]
    std::vector<std::string> parts;  ///< part names by part number
    std::vector<FrameGroup> groups;  ///< "walls" only in the first frame
};

/// Receives frames as the run produces them. Implementations throw ResourceError if they cannot store them.
class FrameSink {
  public:
    virtual ~FrameSink() = default;
    /// False: only rank 0 has the sink and passes it all particles. True: every rank has a sink and passes it its own
    /// particles.
    [[nodiscard]] virtual bool takes_pieces() const { return false; }
    virtual void write(const Frame& frame) = 0;
};

/// A sink that stores a run's frames in a folder and can be resumed.
class FrameSeries : public FrameSink {
  public:
    /// Continues the series of the run in the folder after its first `frames` frames; later ones are removed. Throws
    /// InputError if frames are missing.
    virtual void go_on(long frames) = 0;
    /// The files to open, relative to the folder.
    [[nodiscard]] virtual std::vector<std::string> files() const = 0;
};

/// Measures over time: each row has the values at one time, in the order of the names.
struct MeasureSeries {
    std::vector<std::string> names;  ///< column names, without time
    std::vector<std::string> units;
    std::vector<double> time;               ///< [s]
    std::vector<std::vector<double>> rows;  ///< rows[k] belongs to time[k]
};

}  // namespace dmp::solver
