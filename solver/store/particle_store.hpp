// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include "particles/particle_set.hpp"
#include "particles/periodic_images.hpp"
#include "solver/store/fields.hpp"

namespace dmp {

/// The running particles: one array a field and axis, owned particles first (index = id), periodic images after them.
/// Only fields that a model declared exist.
class ParticleStore {
  public:
    explicit ParticleStore(const ParticleSet& particles);

    /// Allocates the fields (zero-filled) that are not there yet.
    void declare(std::initializer_list<Field> fields);
    [[nodiscard]] bool has(Field field) const { return !array(field, 0).empty(); }

    /// The scalar field, or one axis of a vector field, over owned particles and images.
    [[nodiscard]] double* data(Field field, int axis = 0) { return array(field, axis).data(); }
    [[nodiscard]] const double* data(Field field, int axis = 0) const { return array(field, axis).data(); }

    [[nodiscard]] int dimension() const { return dimension_; }
    [[nodiscard]] std::size_t owned() const { return kind_.size(); }
    [[nodiscard]] std::size_t with_images() const { return owned() + images_.size(); }
    [[nodiscard]] ParticleKind kind(std::size_t i) const { return kind_[i]; }
    /// Ids of the owned particles of one kind, ascending.
    [[nodiscard]] const std::vector<int>& ids(ParticleKind kind) const { return ids_[static_cast<std::size_t>(kind)]; }
    /// The particle that index i is, or is an image of.
    [[nodiscard]] int source(int i) const {
        const auto owned_count = static_cast<int>(owned());
        return i < owned_count ? i : images_[static_cast<std::size_t>(i - owned_count)].source;
    }

    /// Moves owned particles into the box along periodic axes and makes the images within `reach` of it anew.
    void renew_images(const Box& box, const std::array<bool, 3>& periodic, double reach);
    /// Copies the fields from the owned particles to their images (positions are shifted by whole periods).
    void refresh_images(std::initializer_list<Field> fields);

    [[nodiscard]] std::size_t bytes_per_particle() const;
    [[nodiscard]] std::vector<Field> declared() const;

  private:
    [[nodiscard]] int axes(Field field) const { return info(field).is_vector ? dimension_ : 1; }
    std::vector<double>& array(Field field, int axis) { return arrays_[static_cast<std::size_t>(field)][axis]; }
    [[nodiscard]] const std::vector<double>& array(Field field, int axis) const {
        return arrays_[static_cast<std::size_t>(field)][axis];
    }

    int dimension_;
    std::vector<ParticleKind> kind_;
    std::array<std::vector<int>, 3> ids_;
    std::vector<PeriodicImage> images_;
    std::array<Coordinates, static_cast<std::size_t>(Field::count)> arrays_;
};

}  // namespace dmp
