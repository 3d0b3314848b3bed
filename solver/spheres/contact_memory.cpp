// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/contact_memory.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "solver/state/loaded_groups.hpp"

namespace dmp::solver {

void ContactMemory::exchange(const Ranks& ranks, const std::vector<std::vector<RememberedContact>>& to_each) {
    for (const auto& received : ranks.exchange(to_each))
        contacts_.insert(contacts_.end(), received.begin(), received.end());
}

void ContactMemory::sort() {
    std::fill(first_.begin(), first_.end(), 0);
    for (const RememberedContact& contact : contacts_) ++first_[static_cast<std::size_t>(contact.low) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
    sorted_.resize(contacts_.size());
    for (std::size_t k = 0; k < contacts_.size(); ++k)
        sorted_[static_cast<std::size_t>(next[static_cast<std::size_t>(contacts_[k].low)]++)] = {contacts_[k].high, k};
}

void ContactMemory::archive(Archive& file, const std::string& name, const Ranks& ranks,
                            std::vector<RememberedContact>& own) const {
    constexpr std::size_t width = 2 + most_history;
    std::vector<double> flat;
    if (!file.loading()) {
        std::vector<RememberedContact> all = ranks.gather_to_first(own);
        std::ranges::sort(all, {}, [](const RememberedContact& c) { return std::tuple(c.low, c.high); });
        for (const RememberedContact& contact : all) {
            flat.push_back(static_cast<double>(contact.low));
            flat.push_back(static_cast<double>(contact.high));
            flat.insert(flat.end(), contact.history.begin(), contact.history.end());
        }
    }
    file(name, flat);
    if (!file.loading()) return;
    if (flat.size() % width != 0) throw unlike_any_run("a part of a contact");
    check_finite(flat, "a contact");
    own.assign(flat.size() / width, {});
    for (std::size_t k = 0; k < own.size(); ++k) {
        own[k].low = loaded_whole(flat[k * width], 0, ids(), "a sphere in contact");
        own[k].high = loaded_whole(flat[k * width + 1], 0, ids(), "a sphere in contact");
        std::copy_n(flat.begin() + static_cast<std::ptrdiff_t>(k * width + 2), most_history, own[k].history.begin());
    }
}

}  // namespace dmp::solver
