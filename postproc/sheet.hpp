// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "base/vec.hpp"
#include "postproc/canvas.hpp"
#include "postproc/frame_scene.hpp"

namespace dmp::postproc {

/// One or more pictures of the same area with title, times, length scale and colour bar.
class Sheet {
  public:
    /// `panels` pictures of `area` on a sheet at most `width` pixels wide; the number of columns is chosen to fit a
    /// page.
    Sheet(const Box& area, std::size_t panels, int width, const std::string& title);

    [[nodiscard]] int panel_width() const { return panel_width_; }
    [[nodiscard]] int panel_height() const { return panel_height_; }

    /// Adds the next picture, of panel_width x panel_height pixels.
    void add(const Image& image, const std::string& caption);
    /// Adds the length scale and the colour bar below the pictures.
    void finish(const ColourScale& scale);
    void save(const std::filesystem::path& file) const { canvas_.save(file); }
    [[nodiscard]] std::string png() const { return canvas_.png(); }

  private:
    struct Layout;
    Sheet(const Layout& layout, const Box& area, const std::string& title);
    void draw_length(double top);
    void draw_colours(const ColourScale& scale, double top);

    double unit_;  ///< the length of one pixel on a sheet 1600 pixels wide [pixels]
    int columns_, rows_, panel_width_, panel_height_;
    double pitch_x_, pitch_y_, left_, head_, pixels_per_metre_;
    int added_ = 0;
    Canvas canvas_;
};

}  // namespace dmp::postproc
