// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/study_plots.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/csv.hpp"
#include "report/html.hpp"

namespace dmp::report {

namespace {

using Json = JsonValue::Json;

/// -1 where there is none.
template <class Named>
int index_of(const std::vector<Named>& list, const std::string& name) {
    const auto found = std::ranges::find(list, name, &Named::name);
    return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

struct Indices {
    int result, key, lines_by;
    [[nodiscard]] bool known() const { return result >= 0 && key >= 0; }
};

Indices indices(const StudyFiles& study, const StudyFacts::Plot& plot) {
    return {index_of(study.facts.results, plot.result), index_of(study.facts.keys, plot.key),
            plot.lines_by.empty() ? -1 : index_of(study.facts.keys, plot.lines_by)};
}

std::string caption(const StudyFacts::Plot& plot) {
    if (!plot.title.empty()) return plot.title;
    return plot.result + " over " + plot.key;
}

}  // namespace

Json plots_json(const StudyFiles& study) {
    Json plots = Json::array();
    for (const StudyFacts::Plot& plot : study.facts.plots) {
        const Indices at = indices(study, plot);
        if (!at.known()) continue;
        Json& json = plots.emplace_back(Json{{"result", at.result},
                                             {"key", at.key},
                                             {"lines_by", at.lines_by},
                                             {"log_x", plot.log_x},
                                             {"log_y", plot.log_y}});
        for (const StudyFacts::Reference& of : plot.references)
            if (of.problem.empty()) json["reference"] = {{"file", of.file}, {"x", of.x}, {"y", of.y}};
    }
    return plots;
}

std::string study_plots_section(const StudyFiles& study) {
    std::string figures;
    int drawn = 0;
    for (const StudyFacts::Plot& plot : study.facts.plots) {
        if (!indices(study, plot).known()) continue;
        const std::string name = escaped(caption(plot));
        figures += fmt::format(
            "<figure><figcaption>{0}</figcaption><div class=\"legend\"></div><div class=\"plot\" data-plot=\"{1}\" "
            "tabindex=\"0\" role=\"group\" aria-label=\"Plot: {0}\"></div>\n<p class=\"readout\" "
            "aria-live=\"polite\"></p><p class=\"note treatment\"></p>",
            name, drawn++);
        for (const StudyFacts::Reference& of : plot.references)
            if (!of.problem.empty())
                figures += fmt::format("<p class=\"note\">The points of {} are not shown: {}.</p>", escaped(of.file),
                                       escaped(of.problem));
        figures += "</figure>\n";
    }
    if (figures.empty() || study.rows.empty()) return section("plots", "Plots", "<p>There is nothing to plot.</p>\n");
    std::string text =
        "<noscript><p class=\"note\">The plots need JavaScript, which is off in this browser.</p></noscript>\n"
        "<p class=\"script-only\">What is next to the pointer stands below each plot; a click opens the page of that "
        "run, where it has one. Drag across a plot to zoom in, double-click to see all. With the keyboard, in a plot: "
        "arrow keys go from run to run, Enter opens its page, 0 shows all.</p>\n";
    if (study.facts.default_plots)
        text +=
            "<p class=\"note\">The study has no [[plot]]: each result is plotted over the key that takes most "
            "values.</p>\n";
    return section("plots", "Plots",
                   text + "<div id=\"choices\" class=\"controls script-only\"></div>\n<div class=\"plots\">\n" +
                       figures + "</div>\n");
}

}  // namespace dmp::report
