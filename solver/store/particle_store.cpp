// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/store/particle_store.hpp"

namespace dmp {

ParticleStore::ParticleStore(const ParticleSet& particles) : dimension_(particles.dimension) {
    kind_.reserve(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) {
        kind_.push_back(particles.kind(i));
        ids_[static_cast<std::size_t>(kind_.back())].push_back(static_cast<int>(i));
    }
    declare({Field::position, Field::velocity, Field::force, Field::mass, Field::volume});
    for (std::size_t i = 0; i < particles.size(); ++i) {
        for (int axis = 0; axis < dimension_; ++axis) array(Field::position, axis)[i] = particles.position[i][axis];
        array(Field::mass, 0)[i] = particles.mass[i];
        array(Field::volume, 0)[i] = particles.volume[i];
    }
}

void ParticleStore::declare(std::initializer_list<Field> fields) {
    for (const Field field : fields)
        for (int axis = 0; axis < axes(field); ++axis) array(field, axis).resize(with_images(), 0.0);
}

void ParticleStore::renew_images(const Box& box, const std::array<bool, 3>& periodic, double reach) {
    Coordinates& position = arrays_[static_cast<std::size_t>(Field::position)];
    for (int axis = 0; axis < dimension_; ++axis)
        if (periodic[axis])
            for (std::size_t i = 0; i < owned(); ++i)
                position[axis][i] = wrapped(position[axis][i], box.low[axis], box.high[axis]);
    images_ = periodic_images(position, owned(), box, periodic, reach);
    for (const Field field : declared())
        for (int axis = 0; axis < axes(field); ++axis) array(field, axis).resize(with_images());
    for (const Field field : declared()) refresh_images({field});
}

void ParticleStore::refresh_images(std::initializer_list<Field> fields) {
    for (const Field field : fields)
        for (int axis = 0; axis < axes(field); ++axis) {
            double* values = data(field, axis);
            double* image_values = values + owned();
            for (std::size_t k = 0; k < images_.size(); ++k) image_values[k] = values[images_[k].source];
            if (field != Field::position) continue;
            for (std::size_t k = 0; k < images_.size(); ++k) image_values[k] += images_[k].shift[axis];
        }
}

std::size_t ParticleStore::bytes_per_particle() const {
    std::size_t bytes = sizeof(ParticleKind) + sizeof(int);
    for (const Field field : declared()) bytes += static_cast<std::size_t>(axes(field)) * sizeof(double);
    return bytes;
}

std::vector<Field> ParticleStore::declared() const {
    std::vector<Field> fields;
    for (std::size_t f = 0; f < arrays_.size(); ++f)
        if (!arrays_[f][0].empty()) fields.push_back(static_cast<Field>(f));
    return fields;
}

}  // namespace dmp
