// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/errors.hpp"
#include "postproc/frame_scene.hpp"
#include "postproc/measure_plot.hpp"
#include "postproc/particle_view.hpp"
#include "postproc/sheet.hpp"
#include "postproc/tables.hpp"
#include "postproc/virtual_display.hpp"
#include "postproc/vtk_messages.hpp"

namespace dmp {

namespace fs = std::filesystem;

namespace {

void warn(std::string& warning, const std::string& words) {
    if (warning.find(words) != std::string::npos) return;
    if (!warning.empty()) warning += '\n';
    warning += words;
}

/// `count` of the run's frames, evenly spaced, the last one among them, the first (at rest) only when all are taken.
std::vector<std::size_t> spread(std::size_t frames, int count) {
    std::vector<std::size_t> chosen;
    const std::size_t taken = std::min(frames, static_cast<std::size_t>(std::max(count, 1)));
    for (std::size_t k = 1; k <= taken; ++k)
        chosen.push_back(taken == frames ? k - 1 : (k * (frames - 1) + taken / 2) / taken);
    return chosen;
}

/// Draws the frames of one run one after the other; holds one at a time.
class RunPainter {
  public:
    RunPainter(const RunFolder& run, const PictureOptions& options) : run_(run), options_(options) {}

    /// The chosen frames on one sheet with one colour range.
    void write(const std::vector<std::size_t>& frames, const std::string& file, Pictures& pictures) {
        FieldRange range;
        for (const std::size_t number : frames) range.include(run_.read(number), options_.field);
        const Box area = run_.area();
        Sheet sheet(area, frames.size(), options_.width, run_.title());
        const ColourScale scale = range.scale();
        for (const std::size_t number : frames) {
            const RunFrame frame = run_.read(number);
            const Image image = view_.draw(layers_of(frame, run_.walls(), options_.field, scale), area,
                                           sheet.panel_width(), sheet.panel_height());
            if (distinct_colours(image, 3) < 3)
                warn(pictures.warning,
                     file + ": the drawing of t = " + time_text(frame.time, run_.end_time()) + " came out blank");
            sheet.add(image, "t = " + time_text(frame.time, run_.end_time()));
            if (const std::size_t outside = count_outside(frame, area); outside > 0)
                warn(pictures.warning, file + ": " + std::to_string(outside) + " particles at t = " +
                                           time_text(frame.time, run_.end_time()) + " lie outside the picture");
        }
        if (range.missing())
            warn(pictures.warning, "the frames hold no field '" + options_.field + "' to colour the particles with");
        sheet.finish(scale);
        sheet.save(run_.folder() / file);
        pictures.files.push_back(file);
    }

  private:
    const RunFolder& run_;
    const PictureOptions& options_;
    ParticleView view_;
};

void write_frames(const RunFolder& run, const PictureOptions& options, Pictures& pictures) {
    if (!run.flat() && !run.of_spheres()) {
        warn(pictures.warning,
             "no pictures of the frames: they are three-dimensional; see them in ParaView with "
             "open_in_paraview.py");
        return;
    }
    const VirtualDisplay display;
    if (!display.usable()) {
        warn(pictures.warning, "no pictures of the frames: " + display.problem());
        return;
    }
    const VtkMessages messages;
    RunPainter painter(run, options);
    painter.write({run.frames() - 1}, "last_frame.png", pictures);
    if (run.frames() > 1) painter.write(spread(run.frames(), options.sheet_frames), "cycle.png", pictures);
    if (!messages.text().empty()) warn(pictures.warning, "while drawing: " + messages.text());
}

}  // namespace

Pictures write_pictures(const fs::path& folder, const PictureOptions& options) {
    const RunFolder run(folder);
    Pictures pictures;
    write_frames(run, options, pictures);
    if (fs::exists(folder / measures_file_name)) {
        const MeasureSeries measures = read_measures_csv(folder);
        if (!measures.names.empty() && !measures.rows.empty()) {
            draw_measures(measures, run.title(), options.width).save(folder / "measures.png");
            pictures.files.emplace_back("measures.png");
        }
    }
    return pictures;
}

}  // namespace dmp
