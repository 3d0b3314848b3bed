// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace dmp::solver {

/// A named array over the particles or bonds of a group, components interleaved.
struct FrameField {
    std::string name;    ///< snake_case, no unit in it
    std::string unit;    ///< "m/s", "Pa"; "1" when dimensionless
    int components = 1;  ///< 1, 3 for vectors (z = 0 in 2-D), 6 for symmetric tensors: xx, yy, zz, xy, yz, xz
    std::vector<float> values;
};

/// Particles that are looked at together: the fluid, the solids, the walls.
struct FrameGroup {
    std::string name;             ///< "fluid", "solid", "spheres", "walls" (at rest) or "moving_walls"
    std::vector<float> position;  ///< x, y, z of each particle [m]
    std::vector<std::int64_t> id;
    std::vector<std::int32_t> part;  ///< index into Frame::parts
    std::vector<FrameField> fields;
    std::vector<std::int32_t> bond_ends;  ///< two indices into this group a bond
    std::vector<FrameField> bond_fields;
    std::vector<std::int32_t> triangles{};  ///< three indices into this group a triangle: walls of spheres

    [[nodiscard]] std::size_t size() const { return id.size(); }
    [[nodiscard]] std::size_t bonds() const { return bond_ends.size() / 2; }
};

/// All there is to see at one time.
struct Frame {
    double time = 0;  ///< [s]
    long step = 0;
    double spacing = 0;              ///< particle spacing [m]
    std::vector<std::string> parts;  ///< part names by number
    std::vector<FrameGroup> groups;  ///< "walls" only in the first frame
};

/// Takes frames as they come. Implementations throw ResourceError when they cannot keep them.
class FrameSink {
  public:
    virtual ~FrameSink() = default;
    /// False: of several ranks the first one has the sink and hands it all particles. True: every rank has one and
    /// hands it its own.
    [[nodiscard]] virtual bool takes_pieces() const { return false; }
    virtual void write(const Frame& frame) = 0;
};

/// A sink that keeps a run's frames in a folder, for whom a run can go on.
class FrameSeries : public FrameSink {
  public:
    /// Takes up the frames of the run that is in the folder after its first `frames` ones; later ones go. Throws
    /// InputError when they are not all there.
    virtual void go_on(long frames) = 0;
    /// The files to look at, relative to the folder.
    [[nodiscard]] virtual std::vector<std::string> files() const = 0;
};

/// One row of measures: the values at one time, in the order of the names.
struct MeasureSeries {
    std::vector<std::string> names;  ///< column names, without time
    std::vector<std::string> units;
    std::vector<double> time;               ///< [s]
    std::vector<std::vector<double>> rows;  ///< rows[k] belongs to time[k]
};

}  // namespace dmp::solver
