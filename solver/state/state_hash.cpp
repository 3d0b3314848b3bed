// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/state/state_hash.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "particles/periodic_images.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

/// FNV-1a (64 bit), one byte after another.
class Fnv {
  public:
    void add(std::uint64_t bits) {
        for (int byte = 0; byte < 8; ++byte, bits >>= 8) hash_ = (hash_ ^ (bits & 0xff)) * 0x100000001b3ULL;
    }
    /// With MurmurHash3's finaliser applied, so that sums of hashes distinguish different sets.
    [[nodiscard]] std::uint64_t stirred() const {
        std::uint64_t hash = hash_;
        for (const std::uint64_t factor : {0xff51afd7ed558ccdULL, 0xc4ceb9fe1a85ec53ULL}) {
            hash ^= hash >> 33;
            hash *= factor;
        }
        return hash ^ (hash >> 33);
    }

  private:
    std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

/// Hash of a particle's id, position (in the box, along periodic axes), velocity and density.
std::uint64_t hash_of(const ParticleGroup& group, const ParticleSpace& space, std::size_t i) {
    Fnv hash;
    hash.add(static_cast<std::uint64_t>(group.tags()[i].id));
    for (int axis = 0; axis < group.dimension(); ++axis) {
        const double x = group.data(Field::position, axis)[i], v = group.data(Field::velocity, axis)[i];
        // A fluid particle beyond a plane of symmetry is equivalent to its image.
        const double shown = space.periodic[axis]              ? wrapped(x, space.box.low[axis], space.box.high[axis])
                             : group.kind() == PartKind::fluid ? space.mirrored_back(x, axis)
                                                               : x;
        hash.add(std::bit_cast<std::uint64_t>(shown));
        hash.add(std::bit_cast<std::uint64_t>(space.is_mirrored(axis) && shown != x ? -v : v));
    }
    if (group.has(Field::angular_velocity))
        for (int axis = 0; axis < 3; ++axis)
            hash.add(std::bit_cast<std::uint64_t>(group.data(Field::angular_velocity, axis)[i]));
    if (group.has(Field::density)) hash.add(std::bit_cast<std::uint64_t>(group.data(Field::density)[i]));
    for (int s = 0; group.has(Field::species_amount) && s < group.axes(Field::species_amount); ++s)
        hash.add(std::bit_cast<std::uint64_t>(group.data(Field::species_amount, s)[i]));
    return hash.stirred();
}

}  // namespace

std::string state_hash(std::span<const ParticleGroup> groups, const ParticleSpace& space, const Ranks& ranks) {
    std::uint64_t own = 0;
    for (const ParticleGroup& group : groups)
        for (std::size_t i = 0; i < group.owned(); ++i) own += hash_of(group, space, i);
    std::uint64_t hash = 0;
    for (const std::uint64_t part : ranks.gather_to_first(std::vector{own})) hash += part;
    std::array<char, 17> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
    return text.data();
}

}  // namespace dmp::solver
