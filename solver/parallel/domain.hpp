// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>

#include "particles/periodic_images.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_group.hpp"
namespace dmp {
class Domain {
  public:
    Domain(const Ranks&, const ParticleSpace& space) : space_(space) {}
    void migrate(std::span<ParticleGroup> groups) {
        for (auto& group : groups)
            for (int axis = 0; axis < space_.dimension; ++axis)
                if (space_.periodic[axis]) {
                    double* x = group.data(Field::position, axis);
                    for (std::size_t i = 0; i < group.owned(); ++i)
                        x[i] = wrapped(x[i], space_.box.low[axis], space_.box.high[axis]);
                }
    }

  private:
    ParticleSpace space_;
};
}  // namespace dmp
