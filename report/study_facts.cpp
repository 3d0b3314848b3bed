// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/study_facts.hpp"

#include <cmath>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "report/json_value.hpp"

namespace dmp::report {

namespace {

using Json = JsonValue::Json;

Json json_of(const StudyFacts::Plot& plot) {
    Json json{{"title", plot.title},       {"result", plot.result}, {"key", plot.key},
              {"lines_by", plot.lines_by}, {"log_x", plot.log_x},   {"log_y", plot.log_y}};
    for (const StudyFacts::Reference& of : plot.references)
        json["references"].push_back({{"file", of.file}, {"x", of.x}, {"y", of.y}, {"problem", of.problem}});
    return json;
}

std::vector<double> numbers(const JsonValue& list) {
    std::vector<double> result;
    for (const JsonValue& element : list.elements()) result.push_back(element.number());
    return result;
}

StudyFacts::Plot plot_of(const JsonValue& json) {
    StudyFacts::Plot plot{json["title"].text(),
                          json["result"].text(),
                          json["key"].text(),
                          json["lines_by"].text(),
                          json["log_x"].truth(),
                          json["log_y"].truth(),
                          {}};
    for (const JsonValue& of : json["references"].elements())
        plot.references.push_back({of["file"].text(), numbers(of["x"]), numbers(of["y"]), of["problem"].text()});
    return plot;
}

}  // namespace

void write_study_facts(const std::filesystem::path& folder, const StudyFacts& facts) {
    Json keys = Json::array(), results = Json::array(), plots = Json::array();
    for (const StudyFacts::Key& key : facts.keys)
        keys.push_back(
            {{"name", key.name}, {"unit", key.unit}, {"values", key.values}, {"is_formula", key.is_formula}});
    for (const StudyFacts::Result& result : facts.results)
        results.push_back({{"name", result.name}, {"meaning", result.meaning}});
    for (const StudyFacts::Plot& plot : facts.plots) plots.push_back(json_of(plot));
    const Json json{{"title", facts.title},
                    {"purpose", facts.purpose},
                    {"study_file", facts.study_file},
                    {"scene_file", facts.scene_file},
                    {"scene_title", facts.scene_title},
                    {"combination", facts.combination},
                    {"is_scattered", facts.is_scattered},
                    {"default_plots", facts.default_plots},
                    {"runs", facts.runs},
                    {"keys", keys},
                    {"results", results},
                    {"plots", plots}};
    write_file(folder / study_facts_name, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

StudyFacts read_study_facts(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / study_facts_name;
    if (!std::filesystem::is_regular_file(file))
        throw InputError(SourceLocation{folder.string(), 0, 0},
                         std::string("there is no ") + study_facts_name + " in it",
                         "'dmp sweep' with --resume writes it again; finished runs are not run again.");
    const Json document = read_json_object(file);
    const JsonValue json(&document, file);
    StudyFacts facts;
    facts.title = json["title"].text();
    facts.purpose = json["purpose"].text();
    facts.study_file = json["study_file"].text();
    facts.scene_file = json["scene_file"].text();
    facts.scene_title = json["scene_title"].text();
    facts.combination = json["combination"].text();
    facts.is_scattered = json["is_scattered"].truth();
    facts.default_plots = json["default_plots"].truth();
    const double runs = json["runs"].number();
    facts.runs = runs > 0 && runs < 1e9 ? static_cast<std::size_t>(runs) : 0;
    for (const JsonValue& key : json["keys"].elements())
        facts.keys.push_back({key["name"].text(), key["unit"].text(), key["values"].text(), key["is_formula"].truth()});
    for (const JsonValue& result : json["results"].elements())
        facts.results.push_back({result["name"].text(), result["meaning"].text()});
    for (const JsonValue& plot : json["plots"].elements()) facts.plots.push_back(plot_of(plot));
    return facts;
}

}  // namespace dmp::report
