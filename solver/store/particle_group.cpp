// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/store/particle_group.hpp"

#include <algorithm>

namespace dmp::solver {

namespace {

constexpr std::size_t lanes_behind_the_end = 16;

/// Resizes. If this needs new memory, reserves a little more instead of twice as much, because the number of ghosts
/// varies.
template <class Vector>
void resize_with_room(Vector& values, std::size_t size) {
    if (size > values.capacity()) values.reserve(size + size / 16);
    values.resize(size, {});
}

}  // namespace

void ParticleGroup::declare(const FieldList& fields) {
    for (const Field field : fields) declare(field, axes(field));
}

void ParticleGroup::declare(Field field, int arrays) {
    const auto index = static_cast<std::size_t>(field);
    declared_[index] = arrays;
    arrays_[index].resize(std::max<std::size_t>(arrays_[index].size(), static_cast<std::size_t>(arrays)));
    for (int axis = 0; axis < arrays; ++axis) array(field, axis).resize(total() + lanes_behind_the_end);
}

FieldList ParticleGroup::declared() const {
    FieldList fields;
    for (std::size_t f = 0; f < declared_.size(); ++f)
        if (declared_[f] > 0) fields.push_back(static_cast<Field>(f));
    return fields;
}

FieldList ParticleGroup::state() const {
    FieldList fields = declared();
    std::erase_if(fields, [](Field field) { return !info(field).is_state; });
    return fields;
}

void ParticleGroup::resize(std::size_t owned, std::size_t ghosts) {
    owned_ = owned;
    resize_with_room(tags_, owned + ghosts);
    for (const Field field : declared())
        for (int axis = 0; axis < axes(field); ++axis)
            resize_with_room(array(field, axis), total() + lanes_behind_the_end);
}

void ParticleGroup::reorder(std::span<const std::int32_t> order, int threads) {
    Uninitialized<ParticleTag> tags;
    tags.reserve(tags_.capacity());  // with space for ghosts
    tags.resize(order.size());
    const auto count = static_cast<std::ptrdiff_t>(order.size());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::ptrdiff_t k = 0; k < count; ++k) tags[k] = tags_[order[k]];
    tags_ = std::move(tags);
    owned_ = order.size();
    for (const Field field : declared())
        for (int axis = 0; axis < axes(field); ++axis) {
            Array& values = array(field, axis);
            moved_.reserve(values.capacity());
            moved_.resize(order.size() + lanes_behind_the_end);
            if (info(field).is_state) {
#pragma omp parallel for num_threads(threads) schedule(static)
                for (std::ptrdiff_t k = 0; k < count; ++k) moved_[k] = values[order[k]];
            }
            values.swap(moved_);
        }
}

std::size_t ParticleGroup::bytes() const {
    std::size_t bytes = tags_.capacity() * sizeof(ParticleTag) + moved_.capacity() * sizeof(double);
    for (const auto& field : arrays_)
        for (const Array& values : field) bytes += values.capacity() * sizeof(double);
    return bytes;
}

}  // namespace dmp::solver
