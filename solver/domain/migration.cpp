// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/domain/migration.hpp"

#include <array>
#include <bit>
#include <cstring>

namespace dmp::solver {

namespace {

/// A message between two ranks. For each group: the number of particles, their tags, and then their values by field
/// and axis, all in words of 8 bytes.
using Message = std::vector<double>;

constexpr std::size_t tag_words = sizeof(ParticleTag) / sizeof(double);
static_assert(sizeof(ParticleTag) == tag_words * sizeof(double));

double count_as_word(std::size_t count) { return std::bit_cast<double>(static_cast<std::uint64_t>(count)); }
std::size_t word_as_count(double word) { return static_cast<std::size_t>(std::bit_cast<std::uint64_t>(word)); }

void write(Message& message, const ParticleGroup& group, const std::vector<std::int32_t>& particles) {
    message.push_back(count_as_word(particles.size()));
    for (const std::int32_t i : particles) {
        std::array<double, tag_words> words{};
        std::memcpy(words.data(), &group.tags()[i], sizeof(ParticleTag));
        message.insert(message.end(), words.begin(), words.end());
    }
    for (const Field field : group.state())
        for (int axis = 0; axis < group.axes(field); ++axis) {
            const double* values = group.data(field, axis);
            for (const std::int32_t i : particles) message.push_back(values[i]);
        }
}

/// Appends the particles stored at `word` to the owned ones and moves `word` past them.
void read(const double*& word, ParticleGroup& group) {
    const std::size_t count = word_as_count(*word++), first = group.owned();
    if (count == 0) return;
    group.resize(first + count, 0);
    std::memcpy(static_cast<void*>(group.tags().data() + first), word, count * sizeof(ParticleTag));
    word += count * tag_words;
    for (const Field field : group.state())
        for (int axis = 0; axis < group.axes(field); ++axis) {
            std::memcpy(group.data(field, axis) + first, word, count * sizeof(double));
            word += count;
        }
}

void remove(ParticleGroup& group, const std::vector<std::int32_t>& leaving) {
    if (leaving.empty()) {
        group.resize(group.owned(), 0);
        return;
    }
    std::vector<std::int32_t> staying;
    staying.reserve(group.owned() - leaving.size());
    std::size_t next = 0;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(group.owned()); ++i)
        if (next < leaving.size() && leaving[next] == i)
            ++next;
        else
            staying.push_back(i);
    group.reorder(staying);
}

}  // namespace

void send_particles(const Ranks& ranks, const std::vector<ParticleGroup*>& groups,
                    const std::vector<Departures>& departures) {
    const auto size = static_cast<std::size_t>(ranks.size());
    std::vector<bool> has_any(size);
    for (const Departures& leaving : departures)
        for (const int rank : leaving.to) has_any[static_cast<std::size_t>(rank)] = true;

    std::vector<Message> to_each(size);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const Departures& leaving = departures[g];
        std::vector<std::vector<std::int32_t>> by_rank(size);
        for (std::size_t k = 0; k < leaving.to.size(); ++k) by_rank[leaving.to[k]].push_back(leaving.particles[k]);
        for (std::size_t rank = 0; rank < size; ++rank)
            if (has_any[rank]) write(to_each[rank], *groups[g], by_rank[rank]);
    }
    for (std::size_t g = 0; g < groups.size(); ++g) remove(*groups[g], departures[g].particles);

    for (const Message& message : ranks.exchange(to_each)) {
        if (message.empty()) continue;
        const double* word = message.data();
        for (ParticleGroup* group : groups) read(word, *group);
    }
}

}  // namespace dmp::solver
