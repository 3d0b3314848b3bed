// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "particles/particle_set.hpp"
#include "solver/store/particle_group.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// Particles whose every value is a function of their id and of how often they moved, so that every rank knows what
/// every other is to hold. Places are whole multiples of a power of two, kept as integers.
class MovingParticles {
  public:
    using Cell = std::array<std::int64_t, 3>;
    static constexpr double quantum = 1.0 / (1 << 16);

    MovingParticles(int dimension, std::array<bool, 3> periodic, std::int64_t count, unsigned seed) : random_(seed) {
        space.dimension = dimension;
        space.spacing = 0.05;
        space.periodic = periodic;
        space.parts = {{"some", PartKind::fluid}};
        for (int axis = 0; axis < dimension; ++axis) {
            low_[axis] = std::array{-20000, 65536, -131072}[axis];
            cells_[axis] = std::array{65536, 32768, 49152}[axis];
            space.box.low[axis] = static_cast<double>(low_[axis]) * quantum;
            space.box.high[axis] = static_cast<double>(low_[axis] + cells_[axis]) * quantum;
        }
        positions_.resize(static_cast<std::size_t>(count));
        for (Cell& position : positions_)
            for (int axis = 0; axis < dimension; ++axis) position[axis] = low_[axis] + random(0, cells_[axis] - 1);
    }

    /// Everyone moves by up to `most`, in quanta, along each axis, out of the box too where it is not periodic.
    void move(std::int64_t most) {
        ++moves_;
        for (Cell& position : positions_)
            for (int axis = 0; axis < space.dimension; ++axis) {
                position[axis] += random(-most, most);
                if (space.periodic[axis])
                    position[axis] =
                        low_[axis] + ((position[axis] - low_[axis]) % cells_[axis] + cells_[axis]) % cells_[axis];
            }
    }
    /// Values change, places do not.
    void change_values() { ++moves_; }

    [[nodiscard]] std::int64_t count() const { return static_cast<std::int64_t>(positions_.size()); }
    [[nodiscard]] Vec position(std::int64_t id) const {
        Vec at = Vec::Zero();
        for (int axis = 0; axis < space.dimension; ++axis)
            at[axis] = static_cast<double>(positions_[id][axis]) * quantum;
        return at;
    }
    [[nodiscard]] double value(std::int64_t id, Field field, int axis) const {
        if (field == Field::position) return position(id)[axis];
        if (id % 17 == 0) return -0.0;
        return std::sqrt(static_cast<double>(3 * id + axis) + 0.1 * moves_) + static_cast<double>(field);
    }
    [[nodiscard]] static ParticleTag tag(std::int64_t id) {
        return {id, static_cast<std::int32_t>(id % 5) - 1, static_cast<std::uint16_t>(id % 3)};
    }

    /// A group that owns these particles and nothing else, all fields written.
    [[nodiscard]] ParticleGroup group(const std::vector<std::int64_t>& ids,
                                      PartKind kind = PartKind::fluid) const {
        ParticleGroup made(kind, space.dimension);
        made.declare({Field::position, Field::velocity, Field::density, Field::pressure});
        made.resize(ids.size(), 0);
        for (std::size_t i = 0; i < ids.size(); ++i) made.tags()[i] = tag(ids[i]);
        write(made, made.declared());
        return made;
    }
    /// The values that owned particles have now.
    void write(ParticleGroup& group, const FieldList& fields) const {
        for (const Field field : fields)
            for (int axis = 0; axis < group.axes(field); ++axis)
                for (std::size_t i = 0; i < group.owned(); ++i)
                    group.data(field, axis)[i] = value(group.tags()[i].id, field, axis);
    }

    /// True: these fields of particle i are what they are to be, bit for bit; but for `shift`, the position.
    [[nodiscard]] testing::AssertionResult holds(const ParticleGroup& group, std::size_t i, const FieldList& fields,
                                                 const Vec& shift = Vec::Zero()) const {
        const std::int64_t id = group.tags()[i].id;
        if (id < 0 || id >= count()) return testing::AssertionFailure() << "there is no particle " << id;
        if (group.tags()[i] != tag(id)) return testing::AssertionFailure() << "the tag of particle " << id;
        for (const Field field : fields)
            for (int axis = 0; axis < group.axes(field); ++axis) {
                double expected = value(id, field, axis);
                if (field == Field::position && shift[axis] != 0) expected += shift[axis];
                const double found = group.data(field, axis)[i];
                if (std::bit_cast<std::uint64_t>(found) != std::bit_cast<std::uint64_t>(expected))
                    return testing::AssertionFailure() << info(field).name << " of particle " << id << ", axis " << axis
                                                       << ": " << found << " instead of " << expected;
            }
        return testing::AssertionSuccess();
    }

    ParticleSpace space;

  private:
    std::int64_t random(std::int64_t least, std::int64_t most) {
        return std::uniform_int_distribution<std::int64_t>(least, most)(random_);
    }

    std::mt19937_64 random_;
    Cell low_{}, cells_{};
    std::vector<Cell> positions_;
    int moves_ = 0;
};

/// The ids below `count` that are this rank's when they are dealt out like cards.
inline std::vector<std::int64_t> dealt(std::int64_t count, int rank, int ranks) {
    std::vector<std::int64_t> ids;
    for (std::int64_t id = rank; id < count; id += ranks) ids.push_back(id);
    return ids;
}

inline std::string name_of(int dimension, const std::array<bool, 3>& periodic) {
    std::string name = std::to_string(dimension) + "-D, periodic along";
    for (int axis = 0; axis < 3; ++axis)
        if (periodic[axis]) name += std::string(" ") + "xyz"[axis];
    return name;
}

/// Every combination of periodic axes.
inline std::vector<std::array<bool, 3>> combinations(int dimension) {
    std::vector<std::array<bool, 3>> all;
    for (int bits = 0; bits < 1 << dimension; ++bits)
        all.push_back({(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0});
    return all;
}

}  // namespace dmp::tests
