// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <random>
#include <vector>

#include "solver/store/particle_store.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// A disordered crowd of all kinds of particles, fluid with a wall and two spring bodies strewn among it, all shaken by
/// a third of a spacing: 20 x 20 of them in 2-D, 8 x 8 x 8 in 3-D.
inline ParticleSet crowd(int dimension, std::array<bool, 3> periodic, unsigned seed = 1) {
    constexpr double spacing = 0.1;
    const int side = dimension == 3 ? 8 : 20;
    ParticleSet set;
    set.dimension = dimension;
    set.spacing = spacing;
    set.periodic = periodic;
    set.parts = {{"water", PartKind::fluid}, {"wall", PartKind::rigid}, {"flags", PartKind::elastic}};
    for (int axis = 0; axis < dimension; ++axis) set.box.high[axis] = side * spacing;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const int count = dimension == 3 ? side * side * side : side * side;
    for (int k = 0; k < count; ++k) {
        const std::array<int, 3> cell{k % side, k / side % side, k / side / side};
        Vec position = Vec::Zero(), normal = Vec::Zero();
        for (int axis = 0; axis < dimension; ++axis) {
            position[axis] = (cell[axis] + 0.5 + 0.33 * unit(random)) * spacing;
            normal[axis] = unit(random);
        }
        const int pick = static_cast<int>(random() % 8);
        const int part = pick < 5 ? 0 : pick < 6 ? 1 : 2;
        set.position.push_back(position);
        set.part.push_back(part);
        set.body.push_back(part == 2 ? pick - 6 : -1);
        set.volume.push_back((dimension == 3 ? spacing : 1) * spacing * spacing * (1 + 0.1 * unit(random)));
        set.mass.push_back(1000 * set.volume.back());
        set.fixed.push_back(part == 1 ? 1 : 0);
        set.seated.push_back(0);
        set.wall_normal.push_back(part == 1 ? Vec(normal.normalized()) : Vec(Vec::Zero()));
        set.wall_distance.push_back(part == 1 ? spacing * (1.5 + unit(random)) : 0);
    }
    return set;
}

/// Looks up the owned particles of a store by id, wherever they lie in it now.
class ById {
  public:
    explicit ById(ParticleStore& particles) : positions_(particles.owned()) {
        for (ParticleGroup& group : particles.groups())
            for (std::size_t i = 0; i < group.owned(); ++i)
                positions_.at(static_cast<std::size_t>(group.tags()[i].id)) = {&group, static_cast<std::int32_t>(i)};
    }

    [[nodiscard]] std::size_t size() const { return positions_.size(); }
    [[nodiscard]] ParticleGroup& group(std::size_t id) const { return *positions_[id].group; }
    /// In its group.
    [[nodiscard]] std::int32_t index(std::size_t id) const { return positions_[id].index; }
    [[nodiscard]] double& value(Field field, std::size_t id, int axis = 0) const {
        return group(id).data(field, axis)[index(id)];
    }
    [[nodiscard]] Vec vector(Field field, std::size_t id) const {
        Vec values = Vec::Zero();
        for (int axis = 0; axis < group(id).dimension(); ++axis) values[axis] = value(field, id, axis);
        return values;
    }

  private:
    struct Point {
        ParticleGroup* group = nullptr;
        std::int32_t index = 0;
    };
    std::vector<Point> positions_;
};

/// Two owned particles, by id, of which the second or an image of it is near the first.
struct Meeting {
    std::size_t i, j;
    std::array<int, 3> periods;  ///< that the image of j was moved by
    Vec separation;              ///< x_i - x_j, to the image
};

/// Calls visit(Meeting) for every ordered pair of owned particles, once for each periodic image of j that lies within
/// `reach`; a particle meets its own images but not itself. Slow and plain: the oracle of neighbour lists.
template <class Visit>
void for_all_pairs(ParticleStore& particles, double reach, const Visit& visit) {
    const ParticleSpace& space = particles.space();
    std::vector<std::array<int, 3>> shifts{{0, 0, 0}};
    for (int axis = 0; axis < space.dimension; ++axis) {
        const auto before = shifts;
        for (std::array<int, 3> shift : before)
            for (const int periods : {-1, 1}) {
                shift[axis] = periods;
                if (space.periodic[axis]) shifts.push_back(shift);
            }
    }
    const ById by_id(particles);
    std::vector<Vec> position;
    for (std::size_t id = 0; id < by_id.size(); ++id) position.push_back(by_id.vector(Field::position, id));
    const Vec period = space.box.extent();
    for (const std::array<int, 3>& shift : shifts) {
        const Vec moved(shift[0] * period[0], shift[1] * period[1], shift[2] * period[2]);
        for (std::size_t i = 0; i < position.size(); ++i)
            for (std::size_t j = 0; j < position.size(); ++j) {
                const Vec separation = position[i] - (position[j] + moved);
                if (separation.squaredNorm() < reach * reach && !(i == j && moved.isZero(0)))
                    visit(Meeting{i, j, shift, separation});
            }
    }
}

/// Two particles that the lists leave out: walls among themselves, and nodes of one spring body.
inline bool never_meet(const ParticleSet& set, std::size_t i, std::size_t j) {
    if (set.kind(i) != set.kind(j)) return false;
    return set.kind(i) == PartKind::rigid || (set.kind(i) == PartKind::elastic && set.body[i] == set.body[j]);
}

}  // namespace dmp::tests
