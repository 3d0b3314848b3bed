// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/limit_study.hpp"

#include <algorithm>
#include <utility>

#include "study/written_study.hpp"

namespace dmp::study {

LimitStudy::LimitStudy(std::vector<Dial> dials, std::map<std::string, std::string> repeat)
    : dials_(std::move(dials)), repeat_(std::move(repeat)) {
    for (std::size_t dial = 0; dial < dials_.size(); ++dial) {
        begins_.push_back(size());
        for (std::size_t rung = 1; rung <= dials_[dial].rungs.size(); ++rung) places_.push_back({dial, rung});
    }
}

std::optional<std::size_t> LimitStudy::repeat() const {
    if (repeat_.empty()) return {};
    return own + 1;
}

std::optional<DialPlace> LimitStudy::place_of(std::size_t run) const {
    if (run < first_rung()) return {};
    return places_.at(run - first_rung());
}

std::size_t LimitStudy::run_of(std::size_t dial, std::size_t rung) const {
    return rung == 0 ? own : begins_.at(dial) + rung - 1;
}

std::vector<double> LimitStudy::costs() const {
    std::vector<double> costs(first_rung(), 1.0);
    for (const DialPlace& place : places_) costs.push_back(dials_[place.dial].rungs[place.rung - 1].cost);
    return costs;
}

std::vector<std::string> LimitStudy::overrides(const DialPlace& place) const {
    std::vector<std::string> all;
    const Dial& dial = dials_[place.dial];
    for (std::size_t k = 0; k < dial.keys.size(); ++k)
        all.push_back(dial.keys[k].key + "=" + dial.rungs[place.rung - 1].toml[k]);
    return all;
}

std::string LimitStudy::text(const std::string& scene, const std::string& title,
                             const std::vector<std::string>& overrides, const std::filesystem::path& folder) const {
    std::map<std::string, std::vector<std::string>> columns;
    for (const Dial& dial : dials_)
        for (const DialKey& key : dial.keys) columns[key.key] = std::vector(size(), key.own_toml);
    for (const auto& [key, value] : repeat_)
        if (const auto column = columns.find(key); column != columns.end()) column->second[*repeat()] = value;
    for (std::size_t run = first_rung(); run < size(); ++run) {
        const DialPlace place = *place_of(run);
        const Dial& dial = dials_[place.dial];
        for (std::size_t k = 0; k < dial.keys.size(); ++k)
            columns[dial.keys[k].key][run] = dial.rungs[place.rung - 1].toml[k];
    }
    for (const auto& [key, value] : values_set(overrides))
        columns.emplace(key, std::vector(size(), value));  // not what the dials turn: their own values have it
    WrittenStudy study;
    study.comment = "Written by 'dmp limits': the scene's own settings, and values of its dials, of which few are run.";
    study.title = "Limits: " + title;
    study.purpose = "Where the models of the scene end; limits.json has what was found.";
    study.scene = scene;
    study.left_out.insert(RunOutput::checkpoint);
    study.columns.assign(columns.begin(), columns.end());
    return study_text(study, folder);
}

}  // namespace dmp::study
