// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/views.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "postproc/group_box.hpp"

namespace dmp::postproc {

namespace {

constexpr double half_slice = 0.75;      // [spacings]; contains at least one layer of a lattice, at any position
constexpr double reach_of_body = 1.5;    // [spacings] out of the fluid's box; walls of two layers extend further
constexpr double alike = 1.1;            // largest ratio of lengths that count as equal
constexpr double radius_in_space = 0.6;  // [spacings]; spheres of a lattice overlap

using Mirrored = std::array<std::array<bool, 2>, 3>;
using Groups = std::vector<const std::optional<FrameGroup>*>;

/// Rigid parts that do not extend out of the fluid's box.
std::vector<std::int32_t> bodies_in(const Box& fluid, const Groups& rigid, double spacing) {
    std::map<std::int32_t, bool> inside;
    const Vec reach = Vec::Constant(reach_of_body * spacing);
    const Box room{fluid.low - reach, fluid.high + reach};
    for (const auto* group : rigid)
        for (std::size_t i = 0; *group && i < (*group)->size(); ++i) {
            const bool here = contains(room, position_of(**group, i), 3);
            const auto [entry, added] = inside.try_emplace((*group)->part[i], here);
            if (!added) entry->second = entry->second && here;
        }
    std::vector<std::int32_t> bodies;
    for (const auto& [part, stays_inside] : inside)
        if (stays_inside) bodies.push_back(part);
    return bodies;
}

bool is_body(const View& view, const FrameGroup& group, std::size_t particle) {
    return std::ranges::binary_search(view.bodies, group.part[particle]);
}

/// Adds the particles selected by `keep` with their fields, in view coordinates, and the bonds whose two ends are
/// kept.
template <class Keep>
void add_seen(std::optional<FrameGroup>& to, const FrameGroup& group, const Viewpoint& from, const Keep& keep) {
    std::vector<std::int32_t> position(group.size(), -1);
    FrameGroup kept;
    kept.name = group.name;
    for (const FrameField& field : group.fields) kept.fields.push_back({field.name, field.unit, field.components, {}});
    for (std::size_t i = 0; i < group.size(); ++i) {
        const Vec at = position_of(group, i);
        if (!is_finite(at) || !keep(i, at)) continue;
        position[i] = static_cast<std::int32_t>(kept.size());
        const Vec as_seen = from(at);
        for (const double coordinate : as_seen) kept.position.push_back(static_cast<float>(coordinate));
        kept.id.push_back(group.id[i]);
        kept.part.push_back(group.part[i]);
        for (std::size_t k = 0; k < group.fields.size(); ++k) {
            const auto components = static_cast<std::ptrdiff_t>(group.fields[k].components);
            const auto first = group.fields[k].values.begin() + static_cast<std::ptrdiff_t>(i) * components;
            kept.fields[k].values.insert(kept.fields[k].values.end(), first, first + components);
        }
    }
    for (std::size_t bond = 0; bond < group.bonds(); ++bond) {
        const std::int32_t a = position[static_cast<std::size_t>(group.bond_ends[2 * bond])];
        const std::int32_t b = position[static_cast<std::size_t>(group.bond_ends[2 * bond + 1])];
        if (a >= 0 && b >= 0) kept.bond_ends.insert(kept.bond_ends.end(), {a, b});
    }
    if (kept.size() > 0) to = std::move(kept);
}

/// Appends particles to a group, or creates it.
void append(std::optional<FrameGroup>& to, std::optional<FrameGroup>&& more) {
    if (!more) return;
    if (!to) {
        to = std::move(more);
        return;
    }
    to->position.insert(to->position.end(), more->position.begin(), more->position.end());
    to->id.insert(to->id.end(), more->id.begin(), more->id.end());
    to->part.insert(to->part.end(), more->part.begin(), more->part.end());
}

/// Chooses the views of a fluid in 3-D.
class Chooser {
  public:
    Chooser(const RunFolder& run, const Mirrored& mirrored)
        : run_(run), mirrored_(mirrored), first_(run.read(0)), last_(run.read(run.frames() - 1)) {
        fluid_ = empty_box();
        include(fluid_, first_.fluid);
        if (is_empty(fluid_)) fluid_ = run.area();
        bodies_ = bodies_in(fluid_, {&run.walls(), &first_.moving_walls}, first_.spacing);
        for (const auto* group : {&first_.solid, &run.walls(), &first_.moving_walls})
            for (std::size_t i = 0; *group && i < (*group)->size(); ++i)
                if (const Vec position = position_of(**group, i);
                    is_finite(position) &&
                    (group == &first_.solid || std::ranges::binary_search(bodies_, (*group)->part[i])))
                    standing_.push_back(position);
    }

    [[nodiscard]] std::vector<View> views() const {
        int longest = 0;
        fluid_.extent().maxCoeff(&longest);
        const Vec middle = in_round_numbers(middle_of_whole(longest));
        const int across = axis_to_cut(longest, middle);
        const int other = 3 - longest - across;
        // x to the right, z up, where possible in 2-D
        const int right = std::min(longest, other), up = std::max(longest, other);
        std::vector<View> views;
        const auto slice = [&](int to_right, int upward, const Vec& origin) {
            const Viewpoint cut = along(to_right, upward, origin);
            views.push_back({View::Shows::slice, cut, cut, cut(run_.area()),
                             slice_text(to_right, upward, origin, run_.area().extent().maxCoeff()), bodies_});
        };
        if (first_.fluid) {
            slice(right, up, middle);
            Vec section = middle;
            section[longest] = fullest_position(longest, middle);
            section = in_round_numbers(section);
            slice(right == longest ? across : right, right == longest ? up : across, section);
        }
        if (!standing_.empty()) views.push_back(opened(behind(along(right, up, middle), across), longest));
        return views;
    }

  private:
    /// The middle along the axis; along the other axes the middle or, if there is one, a plane of symmetry, half a
    /// spacing from the particles.
    [[nodiscard]] Vec middle_of_whole(int longest) const {
        Vec middle = (fluid_.low + fluid_.high) / 2;
        for (int axis = 0; axis < 3; ++axis) {
            if (axis == longest) continue;
            if (mirrored_[axis][0])
                middle[axis] = fluid_.low[axis] - first_.spacing / 2;
            else if (mirrored_[axis][1])
                middle[axis] = fluid_.high[axis] + first_.spacing / 2;
        }
        return middle;
    }

    /// The cut with the fluid behind it: mirrored if all fluid would be in front of it, at a plane of symmetry.
    [[nodiscard]] Viewpoint behind(Viewpoint cut, int across) const {
        const bool towards_high = cut.axes(2, across) > 0;
        if (mirrored_[across][0] ? towards_high : mirrored_[across][1] && !towards_high) cut.axes.row(2) *= -1;
        return cut;
    }

    /// Rounded, to avoid positions a hundredth of a spacing from 0; planes of symmetry are known less accurately.
    [[nodiscard]] Vec in_round_numbers(Vec position) const {
        for (int axis = 0; axis < 3; ++axis) {
            const double unit = first_.spacing / (mirrored_[axis][0] || mirrored_[axis][1] ? 4 : 20);
            position[axis] = unit * std::round(position[axis] / unit);
        }
        return position;
    }

    /// Of the two planes along the longest axis the larger one. If they are equally large, the one that cuts the
    /// objects in the fluid into more pieces (across struts, not along them), or cuts more of them.
    [[nodiscard]] int axis_to_cut(int longest, const Vec& middle) const {
        const int a = longest == 1 ? 0 : 1, b = 3 - longest - a;
        const Vec extent = fluid_.extent();
        if (extent[a] * alike < extent[b]) return a;
        if (extent[b] * alike < extent[a]) return b;
        const Section of_a = section(a, middle), of_b = section(b, middle);
        if (of_a.pieces != of_b.pieces) return of_a.pieces > of_b.pieces ? a : b;
        return static_cast<double>(of_b.particles) > alike * static_cast<double>(of_a.particles) ? b : a;
    }

    /// The section of the objects in the fluid by a slice perpendicular to an axis: the number of particles, and of
    /// pieces of four or more particles that are three spacings apart.
    struct Section {
        std::size_t particles = 0, pieces = 0;
    };
    [[nodiscard]] Section section(int axis, const Vec& middle) const {
        constexpr double cell = 1.5;  // [spacings]; neighbours are in the same cell or in adjacent ones
        Section result;
        std::map<std::array<long, 2>, std::size_t> cells;
        for (const Vec& position : standing_) {
            if (!in_slice(position[axis] - middle[axis])) continue;
            ++result.particles;
            const Vec at = (position - middle) / (cell * first_.spacing);
            ++cells[{std::lround(at[(axis + 1) % 3]), std::lround(at[(axis + 2) % 3])}];
        }
        while (!cells.empty()) {
            std::size_t particles = 0;
            std::vector<std::array<long, 2>> ahead;
            const auto reach = [&](const std::array<long, 2>& at) {
                const auto here = cells.find(at);
                if (here == cells.end()) return;
                particles += here->second;
                ahead.push_back(at);
                cells.erase(here);
            };
            reach(std::array(cells.begin()->first));
            while (!ahead.empty()) {
                const auto [x, y] = ahead.back();
                ahead.pop_back();
                for (const long i : {-1L, 0L, 1L})
                    for (const long j : {-1L, 0L, 1L}) reach({x + i, y + j});
            }
            if (particles >= 4) ++result.pieces;
        }
        return result;
    }

    [[nodiscard]] bool in_slice(double distance) const { return std::abs(distance) <= half_slice * first_.spacing; }

    /// Position at which a slice perpendicular to the axis cuts most of the objects in the fluid; of several such
    /// positions the middle one.
    [[nodiscard]] double fullest_position(int axis, const Vec& middle) const {
        Box around = empty_box();
        for (const Vec& position : standing_) include(around, position);
        if (is_empty(around)) return middle[axis];
        const double low = around.low[axis];
        std::map<long, std::size_t> count;
        for (const Vec& position : standing_) ++count[std::lround((position[axis] - low) / first_.spacing)];
        const std::size_t most =
            std::ranges::max_element(count, {}, [](const auto& bin) { return bin.second; })->second;
        std::vector<long> full;
        for (const auto& [bin, particles] : count)
            if (10 * particles >= 9 * most) full.push_back(bin);
        return low + first_.spacing * static_cast<double>(full[full.size() / 2]);
    }

    /// The objects in the fluid, with fluid before and behind them for half the width of the fluid.
    [[nodiscard]] View opened(const Viewpoint& cut, int longest) const {
        View view{View::Shows::opened, cut, aslant(cut), empty_box(), "cut open, oblique view", bodies_};
        Box around = empty_box();
        for (const Vec& position : standing_) include(around, position);
        include(around, last_.solid, &run_.area());
        Vec extent = fluid_.extent();
        for (int axis = 0; axis < 3; ++axis)
            if (mirrored_[axis][0] || mirrored_[axis][1]) extent[axis] *= 2;
        extent[longest] = 0;
        const Vec margin = Vec::Unit(longest) * (extent.maxCoeff() / 2);
        const Box whole = run_.area();
        view.low = std::max(around.low[longest] - margin[longest], whole.low[longest]);
        view.high = std::min(around.high[longest] + margin[longest], whole.high[longest]);
        view.axis = longest;
        const Box limit = view.from(whole);  // excludes particles far away
        for (const RunFrame* frame : {&first_, &last_}) {
            const Seen shown = seen(view, *frame, run_.walls());
            for (const auto* group :
                 {&shown.walls, &shown.frame.moving_walls, &shown.frame.bodies, &shown.frame.solid, &shown.frame.fluid})
                include(view.area, *group, &limit);
        }
        const Vec rim = Vec::Constant(first_.spacing);
        view.area = {view.area.low - rim, view.area.high + rim};
        return view;
    }

    const RunFolder& run_;
    const Mirrored mirrored_;
    const RunFrame first_, last_;
    Box fluid_;
    std::vector<std::int32_t> bodies_;
    std::vector<Vec> standing_;  ///< objects in the fluid: elastic bodies and rigid parts
};

}  // namespace

std::vector<View> cameras(const RunFolder& run, const Mirrored& mirrored) {
    if (run.flat() || run.of_spheres()) return {{View::Shows::everything, {}, {}, run.area(), "", {}}};
    return Chooser(run, mirrored).views();
}

Seen seen(const View& view, const RunFrame& frame, const std::optional<FrameGroup>& walls) {
    if (view.shows == View::Shows::everything) return {frame, walls};
    const bool opened = view.shows == View::Shows::opened;
    const double slab = half_slice * frame.spacing * (1 + 1e-6);
    const auto of_surroundings = [&](const Vec& position) {
        const double before = view.cut(position).z();
        if (!opened) return std::abs(before) <= slab;
        return before <= slab && position[view.axis] >= view.low && position[view.axis] <= view.high;
    };
    const auto of_standing = [&](const Vec& position) { return opened || of_surroundings(position); };
    Seen result;
    result.frame.time = frame.time;
    result.frame.spacing = frame.spacing;
    // in an opened view the fluid is cut slightly deeper, so that objects in the cut protrude
    const auto of_fluid = [&](const Vec& position) {
        return of_surroundings(position) && (!opened || view.cut(position).z() <= -0.25 * frame.spacing);
    };
    if (frame.fluid)
        add_seen(result.frame.fluid, *frame.fluid, view.from,
                 [&](std::size_t, const Vec& position) { return of_fluid(position); });
    if (frame.solid)
        add_seen(result.frame.solid, *frame.solid, view.from,
                 [&](std::size_t, const Vec& position) { return of_standing(position); });
    for (const auto* group : {&walls, &frame.moving_walls}) {
        if (!*group) continue;
        const FrameGroup& rigid = **group;
        add_seen(
            group == &walls ? result.walls : result.frame.moving_walls, rigid, view.from,
            [&](std::size_t i, const Vec& position) { return !is_body(view, rigid, i) && of_surroundings(position); });
        std::optional<FrameGroup> bodies;
        add_seen(bodies, rigid, view.from,
                 [&](std::size_t i, const Vec& position) { return is_body(view, rigid, i) && of_standing(position); });
        append(result.frame.bodies, std::move(bodies));
    }
    return result;
}

std::vector<ParticleLayer> layers_of(const View& view, const Seen& seen, const std::string& field,
                                     const ColourScale& scale) {
    std::vector<ParticleLayer> layers = layers_of(seen.frame, seen.walls, field, scale);
    if (view.shows == View::Shows::opened)
        for (ParticleLayer& layer : layers)
            layer.radii.assign(layer.colour.size(), static_cast<float>(radius_in_space * seen.frame.spacing));
    return layers;
}

}  // namespace dmp::postproc
