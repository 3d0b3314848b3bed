// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "postproc/colour_map.hpp"
#include "postproc/particle_view.hpp"
#include "postproc/uses.hpp"
#include "postproc/vtk_frames.hpp"
#include "solver/results/frame.hpp"

namespace dmp::postproc {

/// The particles at one time, without the walls at rest.
struct RunFrame {
    double time = 0;     ///< [s]
    double spacing = 0;  ///< [m]
    std::optional<FrameGroup> fluid, solid, spheres, moving_walls;
    std::optional<FrameGroup>
        bodies;  ///< rigid parts shown as bodies, not walls: those within the fluid of a 3-D scene
    /// The group coloured by a field: the fluid, or the spheres if there is no fluid.
    [[nodiscard]] const std::optional<FrameGroup>& coloured() const { return fluid ? fluid : spheres; }
};

/// The folder of a finished run. Scenes of spheres are shown in an oblique view: positions are rotated so that x
/// points to the right, y up and z towards the viewer.
class RunFolder {
  public:
    /// Reads the lists of frames, the walls and the title. Throws InputError if there are no frames.
    explicit RunFolder(std::filesystem::path folder);

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] std::size_t frames() const { return files_.times().size(); }
    [[nodiscard]] RunFrame read(std::size_t frame) const;
    [[nodiscard]] const std::optional<FrameGroup>& walls() const { return walls_; }
    [[nodiscard]] const std::string& title() const { return title_; }
    [[nodiscard]] double end_time() const { return files_.times().back(); }
    /// False if particles are more than a few spacings apart in z.
    [[nodiscard]] bool flat() const { return flat_; }
    [[nodiscard]] bool of_spheres() const { return files_.of_spheres(); }
    /// The area shown in pictures: the walls and the particles of the first and last frame, excluding particles of
    /// the last frame that are far away [m].
    [[nodiscard]] const Box& area() const { return area_; }

  private:
    std::filesystem::path folder_;
    void turn(FrameGroup& group) const;

    VtkFrames files_;
    std::optional<FrameGroup> walls_;
    std::string title_;
    Box area_;
    bool flat_ = true;
};

/// Colours and label of a field.
struct ColourScale {
    ColourMap map;
    std::string label;                             ///< "speed [m/s]"
    bool beyond_low = false, beyond_high = false;  ///< values exist beyond the ends of the map
    Colour solid;                                  ///< for solids: contrasts with the map
    bool shown = true;                             ///< false: no field for the colours
};

/// Finds the range of a field over several frames. The range omits the outermost 0.1 % of a frame's particles, so
/// that single outliers do not reduce the contrast.
class FieldRange {
  public:
    void include(const RunFrame& frame, const std::string& field);
    [[nodiscard]] bool missing() const { return missing_; }
    /// Pressure and other signed fields: cool to warm around 0; others: viridis, speeds and magnitudes from 0.
    [[nodiscard]] ColourScale scale() const;

  private:
    std::string field_, unit_;
    bool vector_ = false, missing_ = false, any_ = false;
    double low_ = 0, high_ = 0;        ///< without outliers
    double lowest_ = 0, highest_ = 0;  ///< of all particles
};

/// Removes bonds that cross a periodic boundary, whose ends are on opposite sides of the fluid.
void leave_out_bonds_round_borders(RunFrame& frame);

/// Layers from bottom to top: fluid, walls and bodies, solids; spheres have their own size, with transparent walls.
/// Without the field, the fluid has one plain colour.
std::vector<ParticleLayer> layers_of(const RunFrame& frame, const std::optional<FrameGroup>& walls,
                                     const std::string& field, const ColourScale& scale);

/// Number of particles of the frame that are outside the area, in 2-D or in 3-D (`dimension` 2 or 3), or whose
/// position is not finite.
std::size_t count_outside(const RunFrame& frame, const Box& area, int dimension);

/// "1.25 s"; `scale` [s] sets the prefix, so that it is the same for all times of a run.
std::string time_text(double seconds, double scale);

}  // namespace dmp::postproc
