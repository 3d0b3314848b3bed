// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "postproc/canvas.hpp"

namespace dmp::postproc {

/// Particles drawn alike: discs, and lines between them. Layers are drawn over one another in their order, and of a
/// layer's discs the particle nearest to each place of the plane z = 0 shows; unless a layer has spheres: then all
/// stand where they are, and the nearer hides the farther.
struct ParticleLayer {
    std::vector<float> position;          ///< x, y, z of each particle [m]
    std::vector<Colour> colour;           ///< one a particle
    double radius = 0;                    ///< of the discs [m]
    std::vector<float> radii;             ///< one a particle: shaded spheres instead of discs [m]
    std::vector<std::int32_t> triangles;  ///< three particles a triangle, seen through, instead of discs
    std::vector<std::int32_t> lines;      ///< two particles a line
    Colour line_colour;
    double line_width = 0;  ///< [m]
};

/// Draws particles off the screen with OpenGL, seen along z. Needs a usable VirtualDisplay that outlives it.
class ParticleView {
  public:
    ParticleView();
    ~ParticleView();
    ParticleView(const ParticleView&) = delete;
    ParticleView& operator=(const ParticleView&) = delete;

    /// The part `area` of the plane on width x height pixels of the same aspect ratio, on white.
    [[nodiscard]] Image draw(const std::vector<ParticleLayer>& layers, const Box& area, int width, int height);

  private:
    struct Window;
    std::unique_ptr<Window> window_;
};

}  // namespace dmp::postproc
