// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/points.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "base/csv.hpp"
#include "base/hex_text.hpp"
#include "base/random_number.hpp"
#include "base/text_hash.hpp"
#include "base/unlisted_value.hpp"
#include "scene/read_scene.hpp"
#include "study/formula_value.hpp"
#include "study/varied_value.hpp"

namespace dmp::study {

namespace {

std::vector<std::string> varied_values(const std::vector<VariedKey>& keys, const Point& point) {
    std::vector<std::string> all;
    for (std::size_t k = 0; k < keys.size(); ++k)
        if (keys[k].is_of_scene) all.push_back(*keys[k].key + "=" + point.values[k].toml);
    return all;
}

InputError too_many(const Study& study, const std::string& count) {
    return {SourceLocation{study.file, 0, 0},
            "the study has " + count + " runs, more than the " + std::to_string(most_runs) + " that dmp makes",
            "give fewer values; a Latin hypercube covers many keys with few runs (combine = \"latin_hypercube\")"};
}

std::size_t size_of_grid(const Study& study) {
    std::size_t size = 1;
    for (const Vary& each : study.vary) {
        if (!each.is_axis()) continue;
        size *= each.rows.size();
        if (size > most_runs) throw too_many(study, std::to_string(size) + " or more");
    }
    return size;
}

std::size_t size_of_zip(const Study& study) {
    const Vary* first = nullptr;
    for (const Vary& each : study.vary) {
        if (!each.is_axis()) continue;
        if (first == nullptr) first = &each;
        if (each.rows.size() != first->rows.size())
            throw InputError(each.location,
                             "'" + *each.keys.front().key + "' has " + std::to_string(each.rows.size()) +
                                 " values, and '" + *first->keys.front().key + "', with which it varies together, " +
                                 std::to_string(first->rows.size()),
                             "give both as many, or write combine = \"grid\" for each value with each");
    }
    return first->rows.size();
}

std::size_t size_of(const Study& study) {
    switch (*study.combine) {
        case Combine::grid:
            return size_of_grid(study);
        case Combine::zip:
            return size_of_zip(study);
        case Combine::latin_hypercube:
            return static_cast<std::size_t>(*study.samples);
    }
    unlisted_value(*study.combine);
}

/// Of the scene without what does not act on a run's results: its title, its threads, its pictures.
std::string hash_of(Scene scene) {
    const Scene defaults;
    scene.title = defaults.title;
    scene.run.threads = defaults.run.threads;
    scene.output.pictures = defaults.output.pictures;
    return hex_text(text_hash(resolved_scene(scene)));
}

/// A random order of 0 ... count - 1 that follows from the seed and the axis.
std::vector<std::uint32_t> shuffled(std::size_t count, int seed, std::size_t axis) {
    std::vector<double> keys(count);
    for (std::size_t i = 0; i < count; ++i) keys[i] = random_number({static_cast<std::uint64_t>(seed), axis, 1, i});
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return keys[i]; });
    return order;
}

}  // namespace

Points::Points(const Study& study)
    : study_(study), keys_(study.keys()), size_(size_of(study)), scene_hash_(hash_of(study.scene)) {
    if (size_ > most_runs) throw too_many(study, std::to_string(size_));
    if (*study.combine != Combine::latin_hypercube) return;
    for (std::size_t axis = 0; axis < study.vary.size(); ++axis)
        strata_.push_back(study.vary[axis].is_axis() ? shuffled(size_, *study.seed, axis)
                                                     : std::vector<std::uint32_t>{});
}

std::vector<VariedValue> Points::axis_values(std::size_t axis, std::size_t index) const {
    const Vary& vary = study_.vary[axis];
    switch (*study_.combine) {
        case Combine::grid: {
            for (std::size_t faster = study_.vary.size() - 1; faster > axis; --faster)
                if (study_.vary[faster].is_axis()) index /= study_.vary[faster].rows.size();
            return vary.rows[index % vary.rows.size()];
        }
        case Combine::zip:
            return vary.rows[index];
        case Combine::latin_hypercube:
            break;
    }
    const double within = random_number({static_cast<std::uint64_t>(*study_.seed), axis, 2, index});
    const double part = (strata_[axis][index] + within) / static_cast<double>(size_);  // in [0, 1)
    if (vary.range) return {varied_number(number_of(*vary.range, part, 2), vary.keys[0].unit, vary.range->quoted)};
    // The sum above may be rounded up to 1.
    const auto row = static_cast<std::size_t>(part * static_cast<double>(vary.rows.size()));
    return vary.rows[std::min(row, vary.rows.size() - 1)];
}

std::vector<VariedValue> Points::values_at(std::size_t index) const {
    if (index >= size_) throw std::out_of_range("a run that the study does not have");
    std::vector<VariedValue> values;
    for (std::size_t axis = 0; axis < study_.vary.size(); ++axis) {
        const Vary& vary = study_.vary[axis];
        if (!vary.is_axis()) {
            values.push_back(value_of(vary, keys_, values, formula_values_));
            continue;
        }
        for (VariedValue& value : axis_values(axis, index)) values.push_back(std::move(value));
    }
    return values;
}

Point Points::at(std::size_t index) const {
    Point point{"", values_at(index)};
    std::string lines = scene_hash_ + "\n";
    for (const std::string& each : varied_values(keys_, point)) lines += each + "\n";
    std::string number = std::to_string(index + 1);
    const std::size_t width = std::max<std::size_t>(4, std::to_string(size_).size());
    number.insert(0, width - number.size(), '0');
    point.name = number + "_" + hex_text(text_hash(lines), 8);
    return point;
}

std::vector<std::string> overrides(const Study& study, const Point& point) {
    std::vector<std::string> all = study.overrides, varied = varied_values(study.keys(), point);
    all.insert(all.end(), varied.begin(), varied.end());
    return all;
}

std::string identity_of(const Study& study) {
    std::string lines = hash_of(study.scene) + "\n" + std::string(to_string(*study.combine)) + "\n";
    if (*study.combine == Combine::latin_hypercube)
        lines += std::to_string(*study.samples) + " " + std::to_string(*study.seed) + "\n";
    for (const Vary& vary : study.vary) {
        for (const VariedKey& key : vary.keys) lines += *key.key + "\n";
        for (const auto& row : vary.rows)
            for (const VariedValue& value : row) lines += value.toml + "\n";
        if (vary.range)
            lines += csv_number(vary.range->from) + " " + csv_number(vary.range->to) + " " + vary.keys[0].unit + " " +
                     std::string(to_string(vary.range->scale)) + "\n";
        for (const WrittenText& formula : vary.formulas) lines += formula.text + "\n";
    }
    return hex_text(text_hash(lines));
}

}  // namespace dmp::study
