// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "postproc/canvas.hpp"

namespace dmp::postproc {

/// Particles drawn in the same way: as discs, with lines between them. Layers are drawn in order, each over the
/// previous ones; within a layer the particle nearest to each point of the plane z = 0 is visible. If any layer has
/// spheres, everything is drawn at its own z, and nearer objects hide farther ones.
struct ParticleLayer {
    std::vector<float> position;          ///< x, y, z of each particle [m]
    std::vector<Colour> colour;           ///< one per particle
    double radius = 0;                    ///< of the discs [m]
    std::vector<float> radii;             ///< one per particle: shaded spheres instead of discs [m]
    std::vector<std::int32_t> triangles;  ///< three particles per triangle: transparent triangles instead of discs
    std::vector<std::int32_t> lines;      ///< two particles per line
    Colour line_colour;
    double line_width = 0;  ///< [m]
};

/// Renders particles off-screen with OpenGL, viewed along z. Needs a usable VirtualDisplay that outlives it.
class ParticleView {
  public:
    ParticleView();
    ~ParticleView();
    ParticleView(const ParticleView&) = delete;
    ParticleView& operator=(const ParticleView&) = delete;

    /// Draws the area of the plane on width x height pixels of the same aspect ratio, on white.
    [[nodiscard]] Image draw(const std::vector<ParticleLayer>& layers, const Box& area, int width, int height);

  private:
    struct Window;
    std::unique_ptr<Window> window_;
};

}  // namespace dmp::postproc
