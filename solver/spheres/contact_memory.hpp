// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "solver/parallel/ranks.hpp"
#include "solver/spheres/contact_job.hpp"
#include "solver/state/archive.hpp"

namespace dmp::solver {

/// What a contact remembers, by the ids of its two spheres: so it outlives lists, orders and ranks.
struct RememberedContact {
    std::int64_t low = 0, high = 0;  ///< ids
    std::array<double, most_history> history{};
};

/// Contacts between two lists.
class ContactMemory {
  public:
    /// Ids are below `ids`.
    explicit ContactMemory(std::size_t ids) : first_(ids + 1) {}

    void clear() { contacts_.clear(); }
    void add(const RememberedContact& contact) { contacts_.push_back(contact); }
    [[nodiscard]] const std::vector<RememberedContact>& contacts() const { return contacts_; }

    /// Sends each rank what it will own a sphere of: `to_each[rank]`. All ranks take part.
    void exchange(const Ranks& ranks, const std::vector<std::vector<RememberedContact>>& to_each);

    /// To be called between the last add() or exchange() and find().
    void sort();
    /// Null: these two do not touch.
    [[nodiscard]] const RememberedContact* find(std::int64_t low, std::int64_t high) const {
        const auto id = static_cast<std::size_t>(low);
        for (std::int32_t k = first_[id]; k < first_[id + 1]; ++k)
            if (sorted_[k].high == high) return &contacts_[sorted_[k].contact];
        return nullptr;
    }

    /// Ids are below it.
    [[nodiscard]] std::int64_t ids() const { return static_cast<std::int64_t>(first_.size()) - 1; }

    /// All contacts, each once: saving, `own` are this rank's; loading, every rank gets all. Throws InputError for ids
    /// of no spheres.
    void archive(Archive& file, const std::string& name, const Ranks& ranks, std::vector<RememberedContact>& own) const;

  private:
    struct ByLow {
        std::int64_t high = 0;  ///< id
        std::size_t contact = 0;
    };
    std::vector<RememberedContact> contacts_;
    std::vector<ByLow> sorted_;
    std::vector<std::int32_t> first_;  ///< of each low id
};

}  // namespace dmp::solver
