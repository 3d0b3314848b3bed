// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "postproc/canvas.hpp"

namespace dmp::postproc {

/// One of several pictures on a panel.
struct PanelActors {
    Box area;             ///< area shown [m]
    std::string caption;  ///< above the picture; may be empty
};

/// Layout of several pictures on one panel: in rows, at one scale, as large as fits on a page. If there are captions,
/// the rows below the first are magnified by a round number where possible, and the captions state it.
class PanelLayout {
  public:
    explicit PanelLayout(std::vector<PanelActors> drawings);

    /// The panel, in metres at the scale of the first picture.
    [[nodiscard]] Box area() const;
    [[nodiscard]] const PanelActors& operator[](std::size_t k) const { return panels_[k]; }

    /// Draws picture k with the given width and height in pixels.
    using Draw = std::function<Image(std::size_t k, int width, int height)>;
    [[nodiscard]] Image draw(int panel_width, int panel_height, const Draw& draw) const;

  private:
    struct Slot {
        double x = 0, y = 0, width = 0, height = 0;  ///< from the panel's top left corner [m]
    };
    struct Rows;
    [[nodiscard]] Rows in_rows(unsigned breaks) const;
    [[nodiscard]] double room_of(std::size_t k, double times, double panel_width) const;
    [[nodiscard]] double least_width(std::size_t first, std::size_t last) const;

    std::vector<PanelActors> panels_;
    std::vector<Slot> positions_;
    double width_ = 0, height_ = 0, caption_height_ = 0;  ///< [m]
};

}  // namespace dmp::postproc
