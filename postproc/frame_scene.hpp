// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "postproc/colour_map.hpp"
#include "postproc/particle_view.hpp"
#include "postproc/read_frames.hpp"
#include "postproc/uses.hpp"
#include "solver/results/frame.hpp"

namespace dmp::postproc {

/// What is seen at one time, walls at rest aside.
struct RunFrame {
    double time = 0;     ///< [s]
    double spacing = 0;  ///< [m]
    std::optional<FrameGroup> fluid, solid, spheres, moving_walls;
    std::optional<FrameGroup> bodies;  ///< rigid parts told from walls: those within the fluid of a scene in 3-D
    /// What is coloured by a field: the fluid, or the spheres where there is none.
    [[nodiscard]] const std::optional<FrameGroup>& coloured() const { return fluid ? fluid : spheres; }
};

/// A finished run's folder. Scenes of spheres are seen aslant: their places are turned so that x runs to the right, y
/// up and z towards the eye.
class RunFolder {
  public:
    /// Reads the lists of frames, the walls and the title. Throws InputError when there are no frames.
    explicit RunFolder(std::filesystem::path folder);

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] std::size_t frames() const { return times_.size(); }
    [[nodiscard]] RunFrame read(std::size_t frame) const;
    [[nodiscard]] const std::optional<FrameGroup>& walls() const { return walls_; }
    [[nodiscard]] const std::string& title() const { return title_; }
    [[nodiscard]] double end_time() const { return times_.back(); }
    /// False when particles lie more than a few spacings apart in z.
    [[nodiscard]] bool flat() const { return flat_; }
    [[nodiscard]] bool of_spheres() const { return !spheres_.empty(); }
    /// What the pictures show: the walls and the particles of the first and last frame, however far a stray
    /// particle of the last frame may be [m].
    [[nodiscard]] const Box& area() const { return area_; }

  private:
    std::filesystem::path folder_;
    void turn(FrameGroup& group) const;

    std::vector<SeriesEntry> fluid_, solid_, spheres_, moving_walls_;
    std::vector<double> times_;
    std::optional<FrameGroup> walls_;
    std::string title_;
    Box area_;
    bool flat_ = true;
};

/// Colours for a field, and how to name it.
struct ColourScale {
    ColourMap map;
    std::string label;                             ///< "speed [m/s]"
    bool beyond_low = false, beyond_high = false;  ///< there are values beyond the map's ends
    Colour solid;                                  ///< for the solids: stands out on the map
    bool shown = true;                             ///< false: nothing to colour by
};

/// Finds the range of a field over several frames. The ends leave out the outermost 0.1 % of a frame's particles, so
/// that a single one does not wash out the picture.
class FieldRange {
  public:
    void include(const RunFrame& frame, const std::string& field);
    [[nodiscard]] bool missing() const { return missing_; }
    /// Pressure and other signed fields: cool to warm around 0; the others: viridis, speeds and magnitudes from 0.
    [[nodiscard]] ColourScale scale() const;

  private:
    std::string field_, unit_;
    bool vector_ = false, missing_ = false, any_ = false;
    double low_ = 0, high_ = 0;        ///< of the bulk
    double lowest_ = 0, highest_ = 0;  ///< of all
};

/// Bonds that go round a periodic border are not shown: their ends are on opposite sides of the fluid.
void leave_out_bonds_round_borders(RunFrame& frame);

/// Fluid below, walls and bodies over it, solids on top; spheres of their size among walls that show what is behind.
/// Without the field the fluid has one plain colour.
std::vector<ParticleLayer> layers_of(const RunFrame& frame, const std::optional<FrameGroup>& walls,
                                     const std::string& field, const ColourScale& scale);

/// Particles of the frame that are not in the area, in 2-D or in 3-D (`dimension` 2 or 3), or nowhere.
std::size_t count_outside(const RunFrame& frame, const Box& area, int dimension);

/// "1.25 s"; the prefix is the one that suits `scale` [s], the same for all times of a run.
std::string time_text(double seconds, double scale);

}  // namespace dmp::postproc
