// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/read_plot.hpp"

#include <algorithm>
#include <tuple>

#include "base/nearest_name.hpp"
#include "study/reference_points.hpp"
#include "study/toml_table.hpp"
#include "study/values_taken.hpp"

namespace dmp::study {

namespace {

std::vector<std::string> names_of_keys(const Study& study) {
    std::vector<std::string> names;
    for (const VariedKey& key : study.keys()) names.push_back(*key.key);
    return names;
}

/// What the keys of a study take, by name.
class Keys {
  public:
    Keys(const Study& study, const Points& points)
        : names_(names_of_keys(study)), taken_(values_taken(study, points)) {}

    /// Throws InputError where the study does not vary this key, or only sets it.
    [[nodiscard]] const ValuesTaken& varying(const Value<std::string>& key) const {
        const auto found = std::ranges::find(names_, *key);
        if (found == names_.end()) {
            const std::string nearest = nearest_name(*key, names_);
            throw InputError(key.location, "the study does not vary '" + *key + "'",
                             nearest.empty() ? "it varies " + quoted_list(names_) : "did you mean '" + nearest + "'?");
        }
        const ValuesTaken& taken = taken_[static_cast<std::size_t>(found - names_.begin())];
        if (taken.varies()) return taken;
        std::vector<std::string> varying;
        for (std::size_t k = 0; k < names_.size(); ++k)
            if (taken_[k].varies()) varying.push_back(names_[k]);
        throw InputError(key.location, "'" + *key + "' has the same value in all runs",
                         varying.empty() ? "give it more values" : "these vary: " + quoted_list(varying));
    }

  private:
    std::vector<std::string> names_;
    std::vector<ValuesTaken> taken_;
};

std::string result_called(const Value<std::string>& name, const Study& study) {
    std::vector<std::string> names;
    for (const Result& result : study.results) names.push_back(*result.name);
    if (std::ranges::find(names, *name) != names.end()) return *name;
    const std::string nearest = nearest_name(*name, names);
    throw InputError(name.location, "the study has no result '" + *name + "'",
                     names.empty()     ? "it has none at all: add [[result]]"
                     : nearest.empty() ? "its results are " + quoted_list(names)
                                       : "did you mean '" + nearest + "'?");
}

/// A logarithmic axis for a key, which all of its values must have a place on.
void need_logarithm(const ValuesTaken& taken, const std::string& key, const SourceLocation& location) {
    for (const VariedValue& value : taken.values)
        if (!value.quantity || !(value.quantity->si > 0))
            throw InputError(
                location, "'" + key + "' takes the value " + value.cell + ", which has no place on a logarithmic axis",
                "remove \"x\" from 'log', or take a key with numbers above 0");
}

void read_axes(const TomlTable& table, const ValuesTaken& taken, Plot& plot) {
    const TomlNode* given = table.find("log");
    if (given == nullptr) {
        plot.log_x = taken.log_range;
        return;
    }
    const std::vector<PlotAxis> axes = list_of<PlotAxis>().read(*given, "plot.log");
    plot.log_x = std::ranges::find(axes, PlotAxis::x) != axes.end();
    plot.log_y = std::ranges::find(axes, PlotAxis::y) != axes.end();
    if (plot.log_x) need_logarithm(taken, plot.key, given->location);
}

void read_lines(const TomlTable& table, const Keys& keys, Plot& plot) {
    if (table.find("lines_by") == nullptr) return;
    const Value<std::string> key = table.need("lines_by", text_not_empty());
    if (*key == plot.key)
        throw InputError(key.location, "'" + *key + "' is along x already",
                         "give another key for the lines, or leave 'lines_by' out");
    const ValuesTaken& taken = keys.varying(key);
    if (taken.count > most_lines)
        throw InputError(key.location,
                         "'" + *key + "' takes " + std::to_string(taken.count) + " values, and no more than " +
                             std::to_string(most_lines) + " lines can be told apart",
                         "give a key with fewer values");
    plot.lines_by = *key;
}

Plot read_plot(const TomlNode& node, const Study& study, const Keys& keys) {
    const TomlTable table(node, "plot", {"title", "result", "key", "lines_by", "log", "reference"});
    Plot plot;
    plot.location = table.location();
    plot.title = *table.read("title", text_not_empty(), Value<std::string>());
    plot.result = result_called(table.need("result", name()), study);
    const Value<std::string> key = table.need("key", text_not_empty());
    const ValuesTaken& taken = keys.varying(key);
    plot.key = *key;
    read_axes(table, taken, plot);
    read_lines(table, keys, plot);
    if (const TomlNode* reference = table.find("reference")) {
        if (!taken.are_numbers())
            throw InputError(reference->location, "plot.reference: the values of '" + plot.key + "' are no numbers",
                             "remove it: there is no place for its points");
        plot.reference = read_reference(*reference, plot, study);
    }
    return plot;
}

/// Indices of the keys to plot over, the best one first: numbers before names, those with many values before those with
/// few.
std::vector<std::size_t> by_preference(const std::vector<std::string>& names, const std::vector<ValuesTaken>& taken) {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < names.size(); ++k)
        if (taken[k].varies()) order.push_back(k);
    const auto rank = [&](std::size_t k) {
        return std::tuple(taken[k].is_formula, is_seed(names[k]), !taken[k].are_numbers());
    };
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return rank(a) != rank(b) ? rank(a) < rank(b) : taken[a].count > taken[b].count;
    });
    return order;
}

}  // namespace

bool is_seed(const std::string& key) { return last_word(key) == "seed"; }

std::vector<Plot> read_plots(const TomlNode& document, const Study& study, const Points& points) {
    std::vector<Plot> plots;
    const std::vector<const TomlNode*> tables = tables_of(document, "plot");
    if (tables.empty()) return plots;
    const Keys keys(study, points);
    for (const TomlNode* node : tables) plots.push_back(read_plot(*node, study, keys));
    return plots;
}

std::vector<Plot> default_plots(const Study& study, const Points& points) {
    const std::vector<std::string> names = names_of_keys(study);
    const std::vector<ValuesTaken> taken = values_taken(study, points);
    const std::vector<std::size_t> order = by_preference(names, taken);
    std::vector<Plot> plots;
    if (order.empty()) return plots;
    const auto plot_of = [&](const Result& result, std::size_t key) {
        Plot& plot = plots.emplace_back();
        plot.result = *result.name;
        plot.key = names[key];
        plot.log_x = taken[key].log_range;
    };
    for (const Result& result : study.results) {
        if (*study.combine == Combine::latin_hypercube) {
            for (const std::size_t key : order)
                if (!is_seed(names[key])) plot_of(result, key);
            continue;
        }
        plot_of(result, order.front());
        // What varies along with the first key makes no lines of its own.
        if (*study.combine == Combine::zip) continue;
        for (std::size_t k = 1; k < order.size() && plots.back().lines_by.empty(); ++k)
            if (taken[order[k]].count <= most_lines && !taken[order[k]].is_formula && !is_seed(names[order[k]]))
                plots.back().lines_by = names[order[k]];
    }
    return plots;
}

}  // namespace dmp::study
