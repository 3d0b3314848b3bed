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

/// Identity of a particle. Moves with it.
struct ParticleTag {
    std::int64_t id = 0;     ///< unique over all kinds and ranks, for the whole run
    std::int32_t body = -1;  ///< elastic body that it belongs to; -1: none
    std::uint16_t part = 0;  ///< index into ParticleSpace::parts
    friend bool operator==(const ParticleTag&, const ParticleTag&) = default;
};

/// The particles of one kind on this rank: one array per field and axis. Owned particles come first, [0, owned()),
/// spatially sorted; then ghost particles, [owned(), total()): periodic images and particles of other ranks. Only
/// declared fields exist. Arrays are padded by a vector's width, so that all lanes of a cluster can be loaded.
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

    /// Allocates those of the fields that do not exist yet, filled with zeros.
    void declare(const FieldList& fields);
    /// The same for a field with `arrays` arrays (residence_time: one per region).
    void declare(Field field, int arrays);
    [[nodiscard]] bool has(Field field) const { return declared_[static_cast<std::size_t>(field)] > 0; }
    /// The declared state fields, which move with the particles, in the order of Field.
    [[nodiscard]] FieldList state() const;
    [[nodiscard]] FieldList declared() const;
    /// Number of arrays of a field: as declared, otherwise as its shape asks for.
    [[nodiscard]] int axes(Field field) const {
        return has(field) ? declared_[static_cast<std::size_t>(field)] : arrays_of(field, dimension_);
    }

    /// The scalar field, or one axis of a vector field, over owned particles and ghosts.
    [[nodiscard]] double* data(Field field, int axis = 0) { return array(field, axis).data(); }
    [[nodiscard]] const double* data(Field field, int axis = 0) const { return array(field, axis).data(); }
    [[nodiscard]] std::span<ParticleTag> tags() { return tags_; }
    [[nodiscard]] std::span<const ParticleTag> tags() const { return tags_; }

    /// Resizes to `owned` particles followed by `ghosts` ghosts. Existing particles keep their values; the values of
    /// new ones must be set by the caller.
    void resize(std::size_t owned, std::size_t ghosts);
    /// Moves owned particle order[k] to index k; drops owned particles that are not in `order`, and all ghosts.
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
    Uninitialized<ParticleTag> tags_;  ///< first written by the threads that read them later
    std::array<int, static_cast<std::size_t>(Field::count)> declared_{};             ///< arrays; 0: none
    std::array<std::vector<Array>, static_cast<std::size_t>(Field::count)> arrays_;  ///< at least three each
    Array moved_;                                                                    ///< buffer for reordering an array
};

}  // namespace dmp::solver
