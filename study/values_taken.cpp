// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/values_taken.hpp"

#include <algorithm>
#include <set>

#include "study/varied_value.hpp"

namespace dmp::study {

namespace {

/// Adds those that are not there.
class Distinct {
  public:
    explicit Distinct(ValuesTaken& taken) : taken_(taken) {}
    void add(const VariedValue& value) {
        if (!seen_.insert(value.cell).second) return;
        taken_.values.push_back(value);
        taken_.count = taken_.values.size();
    }

  private:
    ValuesTaken& taken_;
    std::set<std::string> seen_;
};

ValuesTaken of_range(const Study& study, const VariedKey& key, const NumberRange& range) {
    ValuesTaken taken;
    for (const double end : {range.from, range.to}) taken.values.push_back(varied_number(end, key.unit, range.quoted));
    taken.count = static_cast<std::size_t>(*study.samples);
    taken.log_range = range.scale == Scale::log && range.from > 0;
    return taken;
}

}  // namespace

bool ValuesTaken::are_numbers() const {
    return std::ranges::all_of(values, [](const VariedValue& value) { return value.quantity.has_value(); });
}

std::vector<ValuesTaken> values_taken(const Study& study, const Points& points) {
    std::vector<ValuesTaken> all;
    for (const Vary& vary : study.vary) {
        for (std::size_t column = 0; column < vary.keys.size(); ++column) {
            if (vary.range) {
                all.push_back(of_range(study, vary.keys[column], *vary.range));
                continue;
            }
            ValuesTaken& taken = all.emplace_back();
            Distinct distinct(taken);
            for (const auto& row : vary.rows) distinct.add(row[column]);
            taken.log_range = vary.log_range;
            if (vary.is_axis()) continue;
            taken.is_formula = true;
            const std::size_t key = all.size() - 1;
            for (std::size_t index = 0; index < points.size(); ++index) distinct.add(points.values_at(index)[key]);
        }
    }
    return all;
}

}  // namespace dmp::study
