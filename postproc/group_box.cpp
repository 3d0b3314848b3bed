// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/group_box.hpp"

#include <algorithm>
#include <limits>

namespace dmp::postproc {

Vec position_of(const FrameGroup& group, std::size_t particle) {
    const float* position = &group.position[3 * particle];
    return {position[0], position[1], position[2]};
}

bool is_finite(const Vec& position) { return position.allFinite(); }

const FrameField* find_field(const FrameGroup& group, const std::string& name) {
    const auto found = std::ranges::find_if(group.fields, [&](const FrameField& field) { return field.name == name; });
    return found == group.fields.end() ? nullptr : &*found;
}

Box empty_box() {
    constexpr double far = std::numeric_limits<double>::infinity();
    return {Vec::Constant(far), Vec::Constant(-far)};
}

bool is_empty(const Box& box) { return box.low.x() > box.high.x(); }

bool contains(const Box& box, const Vec& position, int dimension) {
    for (int axis = 0; axis < dimension; ++axis)
        if (!(position[axis] >= box.low[axis] && position[axis] <= box.high[axis])) return false;
    return true;
}

void include(Box& box, const Vec& position) {
    box.low = box.low.cwiseMin(position);
    box.high = box.high.cwiseMax(position);
}

void include(Box& box, const std::optional<FrameGroup>& group, const Box* limit) {
    if (!group) return;
    const FrameField* radius = find_field(*group, "radius");
    for (std::size_t i = 0; i < group->size(); ++i) {
        const Vec position = position_of(*group, i);
        if (!is_finite(position) || (limit != nullptr && !contains(*limit, position, 3))) continue;
        const Vec reach = Vec::Constant(radius != nullptr ? static_cast<double>(radius->values[i]) : 0);
        include(box, position - reach);
        include(box, position + reach);
    }
}

}  // namespace dmp::postproc
