// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/particle_section.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "report/embedded.hpp"
#include "report/html.hpp"
#include "report/plots.hpp"

namespace dmp::report {

namespace {

/// "every 4th": 1st and 2nd do not end in th, 11th and 12th do.
std::string ordinal(std::size_t n) {
    const std::size_t ones = n % 10, teens = n / 10 % 10;
    return fmt::format("{}{}", n,
                       teens == 1 || ones > 3 || ones == 0 ? "th"
                       : ones == 1                         ? "st"
                       : ones == 2                         ? "nd"
                                                           : "rd");
}

/// What of the frames is shown.
std::string extent_text(const ShownParticles& particles) {
    std::string text =
        particles.times.size() < particles.frames_of_run
            ? fmt::format("{} of the {} frames are shown", particles.times.size(), particles.frames_of_run)
            : fmt::format("All {} frames are shown", particles.frames_of_run);
    if (particles.frames_of_run == 1) text = "The one frame is shown";
    std::set<std::size_t> strides;
    for (const ShownGroup& group : particles.groups) strides.insert(group.every);
    if (*strides.rbegin() == 1) return text + " with all their particles.";
    for (const std::size_t every : strides) {
        if (every == 1) continue;
        std::string names;
        for (const ShownGroup& group : particles.groups) {
            if (group.every != every) continue;
            names += (names.empty() ? "" : ", ") + (group.name == "moving_walls" ? "moving walls" : group.name);
        }
        text += fmt::format("; of {} every {} particle, the same ones in all frames", names, ordinal(every));
    }
    return text + ". The frames in the folder have all.";
}

}  // namespace

std::size_t bytes_for_particles(const RunFiles& run) {
    constexpr std::size_t bytes_of_point = 24, text_of_page = 100'000;
    std::size_t used = text_of_page + page_style.size() + uplot_style.size() + uplot_script.size() +
                       three_script.size() + particle_script.size();
    for (const Picture& picture : run.pictures) used += picture.bytes.size() * 4 / 3;
    if (run.measures)
        used += bytes_of_point * run.measures->names.size() *
                std::min(run.measures->rows.size(), points_of_each(run.measures->names.size()));
    const std::size_t left = used < most_page_bytes ? (most_page_bytes - used) * 3 / 4 : 0;
    return std::clamp(left, least_particle_bytes, most_particle_bytes);
}

std::string particle_section(const RunFiles& run) {
    if (run.particles.times.empty() || run.particles.groups.empty())
        return section("particles", "Particles", "<p>No frames are there of which particles could be shown.</p>\n");
    return section("particles", "Particles",
                   "<noscript><p class=\"note\">The particles need JavaScript, which is off in this browser. The "
                   "pictures show some of the frames.</p></noscript>\n"
                   "<div id=\"particle-view\" class=\"script-only\"></div>\n<p class=\"note\">" +
                       escaped(extent_text(run.particles)) + "</p>\n");
}

}  // namespace dmp::report
