// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/uninitialized.hpp"
#include "particles/particle_set.hpp"
#include "solver/store/fields.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Who a particle is. Travels with it.
struct ParticleTag {
    std::int64_t id = 0;     ///< unique over all kinds and ranks, for the whole run
    std::int32_t body = -1;  ///< spring body it belongs to; -1: none
    std::uint16_t part = 0;  ///< index into ParticleSpace::parts
    friend bool operator==(const ParticleTag&, const ParticleTag&) = default;
};

/// The particles of one kind that this rank works on: one array a field and axis. First those it owns, [0, owned()),
/// spatially sorted; then copies of particles near by, [owned(), total()): periodic images and other ranks' particles.
/// Only fields that a model declared exist. Arrays have room for a vector's width behind their end, so that a cluster's
/// lanes may be loaded whole.
class ParticleGroup {
  public:
    ParticleGroup(PartKind kind, int dimension) : kind_(kind), dimension_(dimension) {
        for (auto& arrays : arrays_) arrays.resize(3);
    }

    [[nodiscard]] PartKind kind() const { return kind_; }
    [[nodiscard]] int dimension() const { return dimension_; }
    [[nodiscard]] std::size_t owned() const { return owned_; }
    [[nodiscard]] std::size_t total() const { return tags_.size(); }
    [[nodiscard]] bool empty() const { return owned_ == 0; }

    /// Allocates the fields (zero-filled) that are not there yet.
    void declare(const FieldList& fields);
    /// The same for a field of `arrays` arrays (residence_time: one a region).
    void declare(Field field, int arrays);
    [[nodiscard]] bool has(Field field) const { return declared_[static_cast<std::size_t>(field)] > 0; }
    /// The declared fields that particles take along, in the order of Field.
    [[nodiscard]] FieldList state() const;
    [[nodiscard]] FieldList declared() const;
    /// Arrays of a field: as many as were declared, else 1 or the dimension.
    [[nodiscard]] int axes(Field field) const {
        return has(field) ? declared_[static_cast<std::size_t>(field)] : info(field).is_vector ? dimension_ : 1;
    }

    /// The scalar field, or one axis of a vector field, over owned particles and copies.
    [[nodiscard]] double* data(Field field, int axis = 0) { return array(field, axis).data(); }
    [[nodiscard]] const double* data(Field field, int axis = 0) const { return array(field, axis).data(); }
    [[nodiscard]] std::span<ParticleTag> tags() { return tags_; }
    [[nodiscard]] std::span<const ParticleTag> tags() const { return tags_; }

    /// Makes room: the first `owned` particles and then `copies`. Particles that were there keep their values; those of
    /// new ones have yet to be written.
    void resize(std::size_t owned, std::size_t ghosts);
    /// Owned particle k becomes what order[k] was; owned ones that are not in `order` and all copies go.
    void reorder(std::span<const std::int32_t> order, int threads = 1);

    [[nodiscard]] std::size_t bytes() const;

  private:
    using Array = std::vector<double>;
    [[nodiscard]] Array& array(Field field, int axis) { return arrays_[static_cast<std::size_t>(field)][axis]; }
    [[nodiscard]] const Array& array(Field field, int axis) const {
        return arrays_[static_cast<std::size_t>(field)][axis];
    }

    PartKind kind_;
    int dimension_;
    std::size_t owned_ = 0;
    Uninitialized<ParticleTag> tags_;  ///< written by the threads that will read them
    std::array<int, static_cast<std::size_t>(Field::count)> declared_{};             ///< arrays; 0: none
    std::array<std::vector<Array>, static_cast<std::size_t>(Field::count)> arrays_;  ///< three or more each
    Array moved_;  ///< where an array is put in a new order
};

}  // namespace dmp::solver
