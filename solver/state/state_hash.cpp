// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/state/state_hash.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <numeric>
#include <vector>

#include "particles/periodic_images.hpp"

namespace dmp {

namespace {

/// Everything the hash is about, of one particle.
struct Record {
    std::int64_t id;
    std::array<double, 7> values;  ///< position, velocity, density; unused axes 0
};

void append(const ParticleGroup& group, const ParticleSpace& space, std::vector<Record>& records) {
    for (std::size_t i = 0; i < group.owned(); ++i) {
        Record record{group.tags()[i].id, {}};
        for (int axis = 0; axis < group.dimension(); ++axis) {
            const double x = group.data(Field::position, axis)[i];
            record.values[axis] = space.periodic[axis] ? wrapped(x, space.box.low[axis], space.box.high[axis]) : x;
            record.values[3 + axis] = group.data(Field::velocity, axis)[i];
        }
        if (group.has(Field::density)) record.values[6] = group.data(Field::density)[i];
        records.push_back(record);
    }
}

}  // namespace

std::string state_hash(const ParticleStore& particles, const Ranks& ranks) {
    std::vector<Record> records;
    for (const ParticleGroup& group : particles.groups()) append(group, particles.space(), records);
    records = ranks.gather_to_first(records);
    std::sort(records.begin(), records.end(), [](const Record& a, const Record& b) { return a.id < b.id; });

    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const Record& record : records)
        for (const double value : record.values) {
            auto bits = std::bit_cast<std::uint64_t>(value);
            for (int byte = 0; byte < 8; ++byte, bits >>= 8) hash = (hash ^ (bits & 0xff)) * 0x100000001b3ULL;
        }
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
    return text.data();
}

}  // namespace dmp
