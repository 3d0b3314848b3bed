// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "particles/periodic_images.hpp"
#include "solver/parallel/domain.hpp"
namespace dmp {
class Halo {
  public:
    Halo(const Ranks&, const ParticleSpace& space) : space_(space) {}
    void build(ParticleGroup& group, const Domain&, double reach) {
        Coordinates points;
        for (int axis = 0; axis < space_.dimension; ++axis)
            points[axis].assign(group.data(Field::position, axis), group.data(Field::position, axis) + group.owned());
        images_ = periodic_images(points, group.owned(), space_.box, space_.periodic, reach);
        group.resize(group.owned(), images_.size());
        for (std::size_t k = 0; k < images_.size(); ++k)
            group.tags()[group.owned() + k] = group.tags()[images_[k].source];
        exchange(group, group.declared());
    }
    void exchange(ParticleGroup& group, const FieldList& fields) {
        for (const Field field : fields)
            for (int axis = 0; axis < group.axes(field); ++axis) {
                double* values = group.data(field, axis);
                for (std::size_t k = 0; k < images_.size(); ++k)
                    values[group.owned() + k] =
                        values[images_[k].source] + (field == Field::position ? images_[k].shift[axis] : 0.0);
            }
    }

  private:
    ParticleSpace space_;
    std::vector<PeriodicImage> images_;
};
}  // namespace dmp
