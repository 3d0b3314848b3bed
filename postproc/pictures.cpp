// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "postproc/animated_png.hpp"
#include "postproc/frame_scene.hpp"
#include "postproc/measure_plot.hpp"
#include "postproc/panel_layout.hpp"
#include "postproc/particle_view.hpp"
#include "postproc/sheet.hpp"
#include "postproc/tables.hpp"
#include "postproc/views.hpp"
#include "postproc/virtual_display.hpp"
#include "postproc/vtk_messages.hpp"

namespace dmp::postproc {

namespace fs = std::filesystem;

namespace {

void warn(std::string& warning, const std::string& words) {
    if (warning.find(words) != std::string::npos) return;
    if (!warning.empty()) warning += '\n';
    warning += words;
}

/// `count` of the run's frames, evenly spaced, including the last; the first (initial state) only if all are chosen.
std::vector<std::size_t> spread(std::size_t frames, int count) {
    std::vector<std::size_t> chosen;
    const std::size_t taken = std::min(frames, static_cast<std::size_t>(std::max(count, 1)));
    for (std::size_t k = 1; k <= taken; ++k)
        chosen.push_back(taken == frames ? k - 1 : (k * (frames - 1) + taken / 2) / taken);
    return chosen;
}

/// Draws the frames of one run one after the other, with one in memory at a time.
class RunPainter {
  public:
    RunPainter(const RunFolder& run, const PictureOptions& options) : run_(run), options_(options) {}

    /// Draws the chosen frames in all views on one sheet with one colour range.
    void write(const std::vector<std::size_t>& frames, const std::vector<View>& views, const std::string& file,
               Pictures& pictures) {
        draw(frames, views, scale_of(frames, pictures), options_.width, file, pictures).save(run_.folder() / file);
        pictures.files.push_back(file);
    }

    /// The same as a film, in which each frame is a sheet.
    void film(const std::vector<std::size_t>& frames, const std::vector<View>& views, const std::string& file,
              Pictures& pictures) {
        constexpr int milliseconds = 40;
        const ColourScale scale = scale_of(frames, pictures);
        std::vector<std::string> images;
        for (const std::size_t number : frames)
            images.push_back(draw({number}, views, scale, options_.film_width, file, pictures).png());
        write_file(run_.folder() / file, animated_png(images, milliseconds));
        pictures.files.push_back(file);
    }

  private:
    ColourScale scale_of(const std::vector<std::size_t>& frames, Pictures& pictures) const {
        FieldRange range;
        for (const std::size_t number : frames) range.include(run_.read(number), options_.field);
        if (range.missing())
            warn(pictures.warning, "the frames contain no field '" + options_.field + "' to colour the particles with");
        return range.scale();
    }

    Sheet draw(const std::vector<std::size_t>& frames, const std::vector<View>& views, const ColourScale& scale,
               int sheet_width, const std::string& file, Pictures& pictures) {
        std::vector<PanelActors> drawings;
        drawings.reserve(views.size());
        // with several frames, the caption of a panel is its time
        for (const View& view : views) drawings.push_back({view.area, frames.size() == 1 ? view.caption : ""});
        const PanelLayout layout(drawings);
        Sheet sheet(layout.area(), frames.size(), sheet_width, run_.title());
        for (const std::size_t number : frames) {
            const RunFrame frame = run_.read(number);
            const std::string time = time_text(frame.time, run_.end_time());
            const auto draw_view = [&](std::size_t k, int width, int height) {
                const Seen shown = seen(views[k], frame, run_.walls());
                Image image =
                    view_.draw(layers_of(views[k], shown, options_.field, scale), views[k].area, width, height);
                if (views[k].shows == View::Shows::slice && frame.fluid && !shown.frame.fluid)
                    warn(pictures.warning, file + ": no fluid at t = " + time + " in the slice with " +
                                               views[k].caption + "; open open_in_paraview.py to view all of it");
                else if (distinct_colours(image, 3) < 3)
                    warn(pictures.warning, file + ": the picture of t = " + time + " is blank");
                return image;
            };
            sheet.add(layout.draw(sheet.panel_width(), sheet.panel_height(), draw_view), "t = " + time);
            const int dimension = run_.flat() || run_.of_spheres() ? 2 : 3;
            if (const std::size_t outside = count_outside(frame, run_.area(), dimension); outside > 0)
                warn(pictures.warning,
                     file + ": " + std::to_string(outside) + " particles at t = " + time + " lie outside the picture");
        }
        sheet.finish(scale);
        return sheet;
    }

    const RunFolder& run_;
    const PictureOptions& options_;
    ParticleView view_;
};

/// If there are slices, only these: small panels show no more detail.
std::vector<View> views_of_many(std::vector<View> views) {
    if (views.size() > 1) std::erase_if(views, [](const View& view) { return view.shows == View::Shows::opened; });
    return views;
}

void write_frames(const RunFolder& run, const PictureOptions& options, Pictures& pictures) {
    const VirtualDisplay display;
    if (!display.usable()) {
        warn(pictures.warning, "no pictures of the frames: " + display.problem());
        return;
    }
    const VtkMessages messages;
    const std::vector<View> views = cameras(run, options.mirrored);
    RunPainter painter(run, options);
    painter.write({run.frames() - 1}, views, "last_frame.png", pictures);
    if (run.frames() > 1)
        painter.write(spread(run.frames(), options.sheet_frames), views_of_many(views), "cycle.png", pictures);
    if (run.frames() > 1 && options.film)
        painter.film(spread(run.frames(), options.film_frames), views_of_many(views), film_file_name, pictures);
    if (run.frames() == 1 && options.film) warn(pictures.warning, "no film: the run has one frame");
    if (!messages.text().empty()) warn(pictures.warning, "message of VTK: " + messages.text());
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

}  // namespace dmp::postproc
