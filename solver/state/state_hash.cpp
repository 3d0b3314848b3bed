// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/state/state_hash.hpp"

#include <bit>
#include <cstdint>
#include <cstdio>

namespace dmp {

std::string state_hash(const ParticleStore& particles) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    const auto add = [&hash](double value) {
        auto bits = std::bit_cast<std::uint64_t>(value);
        for (int byte = 0; byte < 8; ++byte, bits >>= 8) hash = (hash ^ (bits & 0xff)) * 0x100000001b3ULL;
    };
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        for (const Field field : {Field::position, Field::velocity})
            for (int axis = 0; axis < particles.dimension(); ++axis) add(particles.data(field, axis)[i]);
        add(particles.data(Field::density)[i]);
    }
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
    return text.data();
}

}  // namespace dmp
