// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/contact_list.hpp"

#include <algorithm>

namespace dmp::solver {

namespace {

std::size_t in_blocks(std::size_t count) { return (count + contact_block - 1) / contact_block * contact_block; }

/// Pairs whose rows are on their way from memory.
constexpr std::size_t fetched_ahead = 24;

}  // namespace

/// Pairs by thread and kind.
void ContactList::find_pairs(const SphereRows& rows, std::span<const ParticleTag> tags, double gap,
                             std::span<const float> skins) {
    const SphereSearch search(rows, gap, skins);
    const auto total = static_cast<std::int32_t>(rows.total());
    bounds_.clear();
    for (int t = 0; t <= threads_; ++t)
        bounds_.push_back(static_cast<std::int32_t>(static_cast<std::int64_t>(total) * t / threads_));
    std::vector<std::vector<NearSpheres>> found(static_cast<std::size_t>(threads_));
#pragma omp parallel for num_threads(threads_) schedule(static, 1)
    for (int t = 0; t < threads_; ++t)
        search.append_near(bounds_[t], bounds_[t + 1], found[static_cast<std::size_t>(t)]);

    const auto kind_of = [&](const NearSpheres& pair) {
        return kinds_.of(tags[pair.finder].part, tags[pair.other].part);
    };
    const auto kind_count = static_cast<std::size_t>(kind_count_);
    segments_.assign(static_cast<std::size_t>(threads_) * kind_count, {});
    std::size_t listed = 0, contacts = 0;
    for (std::size_t t = 0; t < found.size(); ++t) {
        std::vector<std::size_t> of_kind(kind_count, 0);
        for (const NearSpheres& pair : found[t])
            if (const auto kind = kind_of(pair); kind != PairKinds::none) ++of_kind[static_cast<std::size_t>(kind)];
        for (std::size_t kind = 0; kind < kind_count; ++kind) {
            segments_[t * kind_count + kind] = {static_cast<int>(t),
                                                static_cast<std::int16_t>(kind),
                                                listed,
                                                listed + of_kind[kind],
                                                contacts,
                                                contacts};
            listed += of_kind[kind];
            contacts += in_blocks(of_kind[kind]);
        }
    }
    listed_low_.resize(listed);
    listed_high_.resize(listed);
    contact_of_.assign(listed, -1);
    low_.resize(contacts);
    high_.resize(contacts);
    for (std::size_t n = 0; n < history_width_; ++n) {
        history_[n].resize(contacts);
        next_history_[n].resize(contacts);
    }
    most_deferred_ = 0;
#pragma omp parallel for num_threads(threads_) schedule(static, 1)
    for (int t = 0; t < threads_; ++t) {
        std::vector<std::size_t> next;
        for (std::size_t kind = 0; kind < kind_count; ++kind)
            next.push_back(segments_[static_cast<std::size_t>(t) * kind_count + kind].listed_first);
        std::size_t deferred = 0;
        const auto is_own = [&](std::int32_t row) { return row >= bounds_[t] && row < bounds_[t + 1]; };
        for (const NearSpheres& pair : found[static_cast<std::size_t>(t)]) {
            const auto kind = kind_of(pair);
            if (kind == PairKinds::none) continue;
            const std::size_t k = next[static_cast<std::size_t>(kind)]++;
            const bool in_order = tags[pair.finder].id < tags[pair.other].id;
            listed_low_[k] = in_order ? pair.finder : pair.other;
            listed_high_[k] = in_order ? pair.other : pair.finder;
            deferred += (is_own(pair.finder) ? 0 : 1) + (is_own(pair.other) ? 0 : 1);
        }
#pragma omp critical
        most_deferred_ = std::max(most_deferred_, deferred + 2 * contact_block * kind_count);
    }
}

void ContactList::build(const SphereRows& rows, std::span<const ParticleTag> tags, double gap,
                        std::span<const float> skins) {
    find_pairs(rows, tags, gap, skins);
    nobody_ = rows.nobody();
    built_ = true;
}

std::size_t ContactList::prune_list(ContactSegment& segment, const SphereRows& rows, double gap,
                                    std::span<const float> skins, std::span<const ParticleTag> tags,
                                    const ContactMemory* memory) {
    const auto motion = rows.motion();
    std::size_t next = segment.first;
    for (std::size_t pair = segment.listed_first; pair < segment.listed_end; ++pair) {
        const std::int32_t i = listed_low_[pair], j = listed_high_[pair];
        if (pair + fetched_ahead < segment.listed_end) {
            __builtin_prefetch(&motion[listed_low_[pair + fetched_ahead]]);
            __builtin_prefetch(&motion[listed_high_[pair + fetched_ahead]]);
        }
        const double *a = motion[i].position.c, *b = motion[j].position.c;
        const double dx = a[0] - b[0], dy = a[1] - b[1], dz = a[2] - b[2],
                     touch = a[3] + b[3] + skins[i] + skins[j] + gap;
        const std::int32_t before = contact_of_[pair];
        contact_of_[pair] = -1;
        if (dx * dx + dy * dy + dz * dz >= touch * touch) continue;
        low_[next] = i;
        high_[next] = j;
        const RememberedContact* remembered = memory != nullptr ? memory->find(tags[i].id, tags[j].id) : nullptr;
        for (std::size_t n = 0; n < history_width_; ++n)
            next_history_[n][next] = before >= 0             ? history_[n][before]
                                     : remembered != nullptr ? remembered->history[n]
                                                             : 0.0;
        contact_of_[pair] = static_cast<std::int32_t>(next++);
    }
    const std::size_t count = next - segment.first;
    segment.end = segment.first + in_blocks(count);
    for (; next < segment.end; ++next) {
        low_[next] = nobody_;
        high_[next] = nobody_ + 1;
        for (std::size_t n = 0; n < history_width_; ++n) next_history_[n][next] = 0;
    }
    return count;
}

void ContactList::prune_list(const SphereRows& rows, double gap, std::span<const float> skins,
                             std::span<const ParticleTag> tags, const ContactMemory* memory) {
    std::size_t count = 0;
#pragma omp parallel for num_threads(threads_) schedule(static, 1) reduction(+ : count)
    for (int t = 0; t < threads_; ++t)
        for (ContactSegment& segment : segments_)
            if (segment.thread == t) count += prune_list(segment, rows, gap, skins, tags, memory);
    count_ = count;
    std::swap(history_, next_history_);
}

bool ContactList::has_history(std::size_t k) const {
    for (std::size_t n = 0; n < history_width_; ++n)
        if (history_[n][k] != 0) return true;
    return false;
}

std::array<double, most_history> ContactList::history_of(std::size_t k) const {
    std::array<double, most_history> values{};
    for (std::size_t n = 0; n < history_width_; ++n) values[n] = history_[n][k];
    return values;
}

std::size_t ContactList::bytes() const {
    std::size_t bytes = (listed_low_.capacity() + listed_high_.capacity() + contact_of_.capacity() + low_.capacity() +
                         high_.capacity()) *
                        sizeof(std::int32_t);
    for (std::size_t n = 0; n < most_history; ++n)
        bytes += (history_[n].capacity() + next_history_[n].capacity()) * sizeof(double);
    return bytes;
}

}  // namespace dmp::solver
