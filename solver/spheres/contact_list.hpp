// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/spheres/contact_memory.hpp"
#include "solver/spheres/sphere_rows.hpp"
#include "solver/spheres/sphere_search.hpp"

namespace dmp::solver {

/// Which law holds between the spheres of two parts.
class PairKinds {
  public:
    explicit PairKinds(std::size_t parts) : parts_(parts), kind_(parts * parts, none) {}
    static constexpr std::int16_t none = -1;  ///< they pass through each other
    void set(std::size_t a, std::size_t b, std::int16_t kind) { kind_[a * parts_ + b] = kind_[b * parts_ + a] = kind; }
    [[nodiscard]] std::int16_t of(std::size_t a, std::size_t b) const { return kind_[a * parts_ + b]; }

  private:
    std::size_t parts_;
    std::vector<std::int16_t> kind_;
};

/// A run of contacts of one thread and one kind.
struct ContactSegment {
    int thread = 0;
    std::int16_t kind = 0;
    std::size_t listed_first = 0, listed_end = 0;  ///< pairs
    std::size_t first = 0, end = 0;                ///< contacts, in whole blocks
};

/// Pairs of spheres that may touch while the list lasts, and of these the contacts: those near enough to touch before
/// the list is next looked through, with their history, side by side. Each pair is there once on a rank. Pairs beyond
/// reach are among the contacts too: laws give them no force. In no particular order (ReproducibleSum).
class ContactList {
  public:
    ContactList(const PairKinds& kinds, std::int16_t kind_count, std::size_t history_width, int threads)
        : kinds_(kinds), kind_count_(kind_count), history_width_(history_width), threads_(threads) {}

    /// Lists all pairs whose surfaces are less than `gap` and both skins apart [m]; skins by row. Contacts have yet to
    /// be looked for.
    void build(const SphereRows& rows, std::span<const ParticleTag> tags, double gap, std::span<const float> skins);

    /// Makes contacts of those that are less than `gap` and both skins apart. Histories are those the contacts had
    /// before or, after build(), those in the memory.
    void prune_list(const SphereRows& rows, double gap, std::span<const float> skins, std::span<const ParticleTag> tags,
                    const ContactMemory* memory);

    /// Calls visit(contact index) for all contacts, without the lanes that nobody fills.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (const ContactSegment& segment : segments_)
            for (std::size_t k = segment.first; k < segment.end; ++k)
                if (low_[k] != nobody_) visit(k, segment.kind);
    }
    [[nodiscard]] std::span<const ContactSegment> segments() const { return segments_; }
    [[nodiscard]] const std::vector<std::int32_t>& low() const { return low_; }
    [[nodiscard]] const std::vector<std::int32_t>& high() const { return high_; }
    /// Whether contact k has come to remember anything; JKR's and Hertz' do once they have touched.
    [[nodiscard]] bool has_history(std::size_t k) const;
    [[nodiscard]] std::array<double, most_history> history_of(std::size_t k) const;
    [[nodiscard]] double* history(std::size_t number) { return history_[number].data(); }
    [[nodiscard]] std::size_t history_width() const { return history_width_; }

    /// Rows of each thread, owned ones and copies, from the first one's to the last one's end.
    [[nodiscard]] std::span<const std::int32_t> bounds() const { return bounds_; }
    /// Ends of contacts that lie with other threads' spheres, of one thread at most.
    [[nodiscard]] std::size_t most_deferred() const { return most_deferred_; }
    [[nodiscard]] bool built() const { return built_; }
    [[nodiscard]] std::size_t pairs() const { return listed_low_.size(); }
    [[nodiscard]] std::size_t contacts() const { return count_; }
    [[nodiscard]] std::size_t bytes() const;
    void forget() { built_ = false; }

  private:
    void find_pairs(const SphereRows& rows, std::span<const ParticleTag> tags, double gap,
                    std::span<const float> skins);
    std::size_t prune_list(ContactSegment& segment, const SphereRows& rows, double gap, std::span<const float> skins,
                           std::span<const ParticleTag> tags, const ContactMemory* memory);

    const PairKinds& kinds_;
    std::int16_t kind_count_;
    std::size_t history_width_;
    int threads_;
    bool built_ = false;
    std::vector<ContactSegment> segments_;
    std::vector<std::int32_t> bounds_;
    std::vector<std::int32_t> listed_low_, listed_high_;  ///< rows, by pair
    std::vector<std::int32_t> contact_of_;                ///< by pair; -1: not near
    std::vector<std::int32_t> low_, high_;                ///< rows, by contact
    std::array<std::vector<double>, most_history> history_, next_history_;
    std::int32_t nobody_ = 0;
    std::size_t most_deferred_ = 0, count_ = 0;
};

}  // namespace dmp::solver
