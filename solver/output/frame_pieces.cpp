// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/frame_pieces.hpp"

#include <algorithm>
#include <numeric>

namespace dmp::solver {

namespace {

template <class T>
std::vector<T> in_order(const std::vector<T>& values, const std::vector<std::size_t>& order) {
    const std::size_t components = order.empty() ? 0 : values.size() / order.size();
    std::vector<T> sorted;
    sorted.reserve(values.size());
    for (const std::size_t k : order)
        for (std::size_t c = 0; c < components; ++c) sorted.push_back(values[k * components + c]);
    return sorted;
}

template <class T>
void append(std::vector<T>& values, const std::vector<T>& more) {
    values.insert(values.end(), more.begin(), more.end());
}

bool same_fields(const std::vector<FrameField>& one, const std::vector<FrameField>& other) {
    return std::ranges::equal(one, other, [](const FrameField& a, const FrameField& b) {
        return a.name == b.name && a.unit == b.unit && a.components == b.components;
    });
}

void append_fields(std::vector<FrameField>& fields, const std::vector<FrameField>& more) {
    for (std::size_t n = 0; n < fields.size(); ++n) append(fields[n].values, more[n].values);
}

void append_group(FrameGroup& group, const FrameGroup& more) {
    const auto before = static_cast<std::int32_t>(group.size());
    append(group.id, more.id);
    append(group.part, more.part);
    append(group.position, more.position);
    append_fields(group.fields, more.fields);
    for (const std::int32_t end : more.bond_ends) group.bond_ends.push_back(before + end);
    append_fields(group.bond_fields, more.bond_fields);
    for (const std::int32_t corner : more.triangles) group.triangles.push_back(before + corner);
}

}  // namespace

void sort_by_id(FrameGroup& group) {
    if (std::ranges::is_sorted(group.id)) return;
    std::vector<std::size_t> order(group.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t k) { return group.id[k]; });
    group.id = in_order(group.id, order);
    group.part = in_order(group.part, order);
    group.position = in_order(group.position, order);
    for (FrameField& field : group.fields) field.values = in_order(field.values, order);

    std::vector<std::int32_t> position(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) position[order[k]] = static_cast<std::int32_t>(k);
    for (auto* corners : {&group.bond_ends, &group.triangles})
        for (std::int32_t& corner : *corners) corner = position[static_cast<std::size_t>(corner)];
}

std::string add_piece(Frame& frame, Frame&& piece) {
    if (piece.time != frame.time || piece.step != frame.step)
        return "of step " + std::to_string(piece.step) + ", not " + std::to_string(frame.step);
    if (piece.spacing != frame.spacing || piece.parts != frame.parts) return "of another run";
    for (FrameGroup& more : piece.groups) {
        const auto group = std::ranges::find(frame.groups, more.name, &FrameGroup::name);
        if (group == frame.groups.end()) {
            frame.groups.push_back(std::move(more));
            continue;
        }
        if (!same_fields(group->fields, more.fields) || !same_fields(group->bond_fields, more.bond_fields))
            return "with other fields in the group '" + more.name + "'";
        append_group(*group, more);
    }
    return "";
}

std::string finish_pieces(Frame& frame) {
    for (FrameGroup& group : frame.groups) {
        sort_by_id(group);
        const auto twice = std::ranges::adjacent_find(group.id);
        if (twice != group.id.end())
            return "particle " + std::to_string(*twice) + " of the group '" + group.name + "' is in two pieces";
    }
    return "";
}

}  // namespace dmp::solver
