// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page_frame.hpp"

#include <fmt/format.h>

#include "report/embedded.hpp"
#include "report/html.hpp"

namespace dmp::report {

namespace {

/// A script with the licence that goes with it.
std::string licensed(std::string_view licence, std::string_view script) {
    return "/*\n" + std::string(licence) + "*/\n" + std::string(script) + "\n";
}

std::string script_element(std::string_view script) { return "<script>\n" + std::string(script) + "</script>\n"; }

}  // namespace

std::string plotting_library() { return licensed(uplot_licence, uplot_script); }

std::string drawing_library() { return licensed(three_licence, three_script); }

std::string page_text(const std::string& title, const std::string& content, const PageScripts& run) {
    std::string text =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
        "'unsafe-inline'; script-src 'unsafe-inline'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n<title>";
    text += escaped(title) + "</title>\n<style>\n" + std::string(uplot_style) + "\n" + std::string(page_style) +
            "</style>\n</head>\n<body>\n<main>\n" + content + "</main>\n";
    if (run.data.empty()) return text + "</body>\n</html>\n";
    for (const auto& [id, json] : run.data)
        text += "<script type=\"application/json\" id=\"" + id + "\">" + json + "</script>\n";
    text += script_element(axes_script);
    for (const std::string& script : run.scripts) text += script_element(script);
    return text + "</body>\n</html>\n";
}

std::string without_markup(std::string json) {
    for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at))
        json.replace(at, 1, "\\u003c");
    return json;
}

std::string box(const std::string& kind, const std::string& heading, const std::vector<std::string>& lines) {
    if (lines.empty()) return "";
    std::string text = fmt::format("<section class=\"box {}\"><h2>{}</h2>\n<ul>\n", kind, escaped(heading));
    for (const std::string& line : lines) text += "<li>" + escaped(line) + "</li>\n";
    return text + "</ul></section>\n";
}

std::string or_unknown(std::string text) { return text.empty() ? "not known" : text; }

std::string navigation(const std::vector<std::pair<std::string, std::string>>& anchors) {
    std::string text = "<nav aria-label=\"Sections\">";
    for (const auto& [anchor, name] : anchors)
        text += fmt::format("<a href=\"#{}\">{}</a> ", escaped(anchor), escaped(name));
    return text + "</nav>\n";
}

}  // namespace dmp::report
