// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the ParticleBuilder: bodies of springs.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/number_text.hpp"
#include "mesher/particle_builder.hpp"
#include "mesher/spring_bodies.hpp"
#include "mesher/spring_lattice.hpp"
#include "mesher/straight_bar.hpp"

namespace dmp::mesher {

namespace {

/// The end of a curve so near to another lies on it; a solid's node so near to its anchor is clamped, as the first
/// layer stands half a spacing from the surface, and the nearest to a point, which may be missing a cell [spacings].
constexpr double touching = 0.1, clamped_within = 0.75, nearest_within = 1.5;

/// What particles along an open curve stand for: `half` to both sides of it, and half of what they are apart, `along`,
/// beyond its ends [m].
Region outline_of(const Polyline& curve, double along, double half) {
    Polyline right, left;
    const double length = curve.length();
    const auto pieces = std::lround(length / along);
    for (long n = 0; n <= pieces; ++n) {
        const auto [point, tangent] = curve.at(std::min(length, static_cast<double>(n) * along));
        const Vec to_left(-tangent[1], tangent[0], 0);
        const double beyond = n == 0 ? -along / 2 : n == pieces ? along / 2 : 0;
        right.points.emplace_back(point + beyond * tangent - half * to_left);
        left.points.emplace_back(point + beyond * tangent + half * to_left);
    }
    right.points.insert(right.points.end(), left.points.rbegin(), left.points.rend());
    right.closed = true;
    return {"", {right}};
}

/// Signed angle from arm a to arm b.
double angle_between(const Vec& a, const Vec& b) { return std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b)); }

}  // namespace

/// Gives solids what is theirs, before fluids get theirs.
void ParticleBuilder::claim_solids() {
    for (const Part* part : scene_.parts_of(PartKind::elastic)) {
        const Region* region = geometry_.region(part->name);
        if (region == nullptr) continue;
        SpringSolid& solid = solids_.emplace_back(SpringSolid{part, InsideTest(*region), {}, {}, {}});
        if (scene_.is_of_cells(*part))
            claim_cells(solid, *region);
        else
            claim_points(solid);
        for (std::size_t n = 0; n < solid.points.size(); ++n)
            nodes_.add(solid.points[n], {.of_a_solid = true, .anchored = solid.anchored[n]});
        nodes_.sort(spacing_);
    }
}

void ParticleBuilder::claim_points(SpringSolid& solid) {
    const Part* part = solid.part;
    const bool on_cells = !part->bonds_within.given();
    if (on_cells && *scene_.particles.arrangement != Arrangement::square)
        throw InputError(
            scene_.particles.arrangement.location,
            "'" + part->name.value + "' is a solid of springs, whose cells are built on the square lattice only",
            "write particles.arrangement = \"square\", or give the part bonds_within");
    // Of points on the border those on its low sides: as many rows as spacings.
    const Vec a_little = 1e-6 * spacing_ * Vec(1, 0.618, 0);
    const auto is_in = [&](const Vec& point) {
        const Side side = solid.region.side_of(point);
        return side == Side::inside ||
               (side == Side::on_edge && solid.region.side_of(point + a_little) == Side::inside);
    };
    for (const Vec& point : lattice_.points(0))
        if (is_in(point) && !nodes_.any_near(point, 0.5 * spacing_)) solid.points.push_back(point);
    const std::size_t there = solid.points.size();
    if (on_cells && there > 0) {
        const std::vector<bool> whole =
            in_whole_cells(solid.points, lattice_step(), 2, points_in_period(result_.particles, lattice_step()));
        std::size_t k = 0;
        std::erase_if(solid.points, [&](const Vec&) { return !whole[k++]; });
    }
    if (solid.points.empty())
        throw InputError(
            part->name.location,
            "'" + part->name.value + "' is too thin for a solid of springs: no " + (on_cells ? "cell" : "point") +
                " of the lattice fits in it",
            "refine particles.spacing to a third of its thickness, or draw its middle line as a curve, with "
            "mass_per_length");
    if (solid.points.size() < there)
        result_.report.notes.push_back(part->name.value + ": " + std::to_string(there - solid.points.size()) +
                                       " lattice points in it belong to no whole cell of springs and are left out");
    solid.anchored = anchored_nodes(*part, solid.points);
}

void ParticleBuilder::add_solid(const SpringSolid& solid, int part_number, MeshReport::SpringLine& line) {
    line.anchored = static_cast<std::size_t>(std::ranges::count(solid.anchored, true));
    if (solid.cells) return add_cells(solid, part_number, line);
    if (solid.part->bonds_within.given()) return add_unbonded(solid, part_number, line);
    const SolidBody body = solid_body(*solid.part, solid.points, lattice_step(), result_.particles);
    line.cells = {body.constants, body.stiffened};
    line.particle_mass = body.mass.front();
    const std::size_t first = result_.particles.size();
    const int bodies_before = bodies_;
    const std::vector<int> piece = pieces_of(body.lattice, bodies_);
    for (std::size_t node = 0; node < solid.points.size(); ++node)
        add_particle(part_number, {solid.points[node], body.volume[node], body.mass[node], piece[node],
                                   solid.anchored[node], Vec::Zero(), 0});
    line.bodies = bodies_ - bodies_before;
    add_elastic_of(body.lattice, first, result_.particles, line);
}

/// Nodes that bond_solids() is to bond once they are where they stay.
void ParticleBuilder::add_unbonded(const SpringSolid& solid, int part_number, MeshReport::SpringLine& line) {
    const double volume = lattice_.cell_area();
    line.particle_mass = volume * solid.part->density;
    for (std::size_t node = 0; node < solid.points.size(); ++node)
        add_particle(part_number,
                     {solid.points[node], volume, line.particle_mass, bodies_, solid.anchored[node], Vec::Zero(), 0});
    ++bodies_;
}

/// Of a solid: those next to the named points or the curve, and the one nearest to each point.
std::vector<bool> ParticleBuilder::anchored_nodes(const Part& part, const std::vector<Vec>& nodes) const {
    std::vector<bool> anchored(nodes.size(), false);
    if (part.anchor->empty()) return anchored;
    const double reach = clamped_within * spacing_;
    const auto points = geometry_.points.find(part.anchor);
    if (points != geometry_.points.end()) {
        for (const Vec& anchor : points->second) {
            const auto distance = [&](const Vec& node) { return (node - anchor).norm(); };
            const auto nearest = std::ranges::min_element(nodes, {}, distance);
            if (distance(*nearest) < nearest_within * spacing_)
                anchored[static_cast<std::size_t>(nearest - nodes.begin())] = true;
            for (std::size_t k = 0; k < nodes.size(); ++k)
                if (distance(nodes[k]) < reach) anchored[k] = true;
        }
    } else {
        const NearestCurve held_by(*geometry_.curve_set(part.anchor), reach);
        for (std::size_t k = 0; k < nodes.size(); ++k) anchored[k] = held_by.nearest(nodes[k]).has_value();
    }
    if (std::ranges::find(anchored, true) == anchored.end())
        throw InputError(part.anchor.location,
                         "no node of '" + part.name.value + "' is next to '" + part.anchor.value + "'",
                         "draw the part so that it touches what it is anchored to");
    return anchored;
}

void ParticleBuilder::add_elastic(const Part& part) {
    const int number = add_part(part, PartKind::elastic);
    MeshReport::SpringLine line;
    line.part = part.name;
    const auto solid = std::ranges::find(solids_, &part, &SpringSolid::part);
    const std::size_t first = result_.particles.size();
    if (solid != solids_.end()) {
        add_solid(*solid, number, line);
        if (!solid->cells) {
            std::vector<Vec> corners;
            for (const Polyline& loop : geometry_.region(part.name)->loops)
                corners.insert(corners.end(), loop.points.begin(), loop.points.end());
            share_drawn_mass(part, geometry_.region(part.name)->area(), corners, first, result_.particles, line,
                             result_.report);
        }
        if (solid->cells) line.bar = bar_of(part, *geometry_.region(part.name), *solid->cells);
        if (!solid->cells) note_open_ends(result_.particles, first, part.name, true, result_.report);
        result_.report.springs.push_back(line);
        return;
    }
    line.axial_stiffness_asked = strip_stiffness(part).axial;
    for (const Polyline& piece : geometry_.curve_set(part.name)->pieces) add_ladder(part, number, piece, line);
    note_open_ends(result_.particles, first, part.name, false, result_.report);
    if (!part.anchor->empty() && line.anchored == 0) {
        const bool to_points = geometry_.points.contains(part.anchor);
        throw InputError(part.anchor.location,
                         to_points ? "no point of '" + part.anchor.value + "' lies on '" + part.name.value + "'"
                                   : "no end of '" + part.name.value + "' lies on '" + part.anchor.value + "'",
                         to_points ? "put the anchor points on the curve in the geometry"
                                   : "let the curve begin or end on it in the geometry");
    }
    if (std::abs(line.axial_stiffness / line.axial_stiffness_asked - 1) > 1e-9) {
        std::ostringstream text;
        const bool lowered = line.axial_stiffness < line.axial_stiffness_asked;
        // In tension the part is so many times as soft, or as stiff.
        const double ratio = line.axial_stiffness / line.axial_stiffness_asked;
        const StripRows strip = strip_rows(part, scene_);
        text << part.name.value << ": EA " << (lowered ? "lowered" : "raised") << " from " << line.axial_stiffness_asked
             << " to " << line.axial_stiffness << " N, " << number_text(100 * ratio, 3) << " % of that, so that "
             << (strip.count == 2 ? "two" : std::to_string(strip.count)) << " rows " << strip.apart << " m apart can "
             << (part.shear_stiffness.given() ? "hold GA"
                 : lowered                    ? "bend as softly as EI asks"
                                              : "resist shear by cross bonds")
             << "; EI is held";
        const bool matters = std::abs(ratio - 1) > 0.1;
        (matters ? result_.report.warnings : result_.report.notes).push_back(text.str());
    }
    result_.report.springs.push_back(line);
}

bool ParticleBuilder::goes_on_through_a_side(const Polyline& curve) const {
    const Vec apart = curve.points.back() - curve.points.front();
    const Vec rest = nearest_image(apart, result_.particles);
    return (apart - rest).norm() > spacing_ && rest.norm() < touching * spacing_;
}

void ParticleBuilder::add_ladder(const Part& part, int part_number, const Polyline& curve,
                                 MeshReport::SpringLine& line) {
    constexpr int fewest_columns = 5;
    if (curve.closed)
        throw InputError(part.name.location,
                         "'" + part.name.value + "' has a closed curve, and springs run along open ones only",
                         "leave a gap in the curve in the geometry");
    const StripRows strip = strip_rows(part, scene_);
    const int rows = strip.count;
    Ladder ladder = ladder_along(curve, spacing_, strip);
    const bool goes_on = goes_on_through_a_side(curve);
    if (goes_on) ladder.nodes.resize(ladder.nodes.size() - rows);  // the last column is the first one, a period on
    if (ladder.columns() < fewest_columns) {
        std::ostringstream problem;
        problem << "a curve of '" << part.name.value << "' is " << curve.length() << " m long, " << ladder.columns()
                << " columns of particles; at least " << fewest_columns << " are needed to bend";
        throw InputError(part.name.location, problem.str(), "refine particles.spacing or draw a longer curve");
    }
    constexpr std::size_t enough_cells = 8;
    if (const std::size_t cells = ladder.columns() - 1; !goes_on && cells < enough_cells) {
        std::ostringstream text;
        text << "a curve of '" << part.name.value << "' is " << cells
             << " cells long, which bend in their middles only: clamped at one end it swings about "
             << std::lround(180.0 / static_cast<double>(cells * cells))
             << " % too slowly; take a smaller particles.spacing";
        result_.report.warnings.push_back(text.str());
    }
    const LadderConstants constants = ladder_constants(part, ladder.along, strip.apart, rows);
    const int body = bodies_++;
    strips_.push_back({{"", {curve}}, strip.thickness() / 2, strip.apart > spacing_ || rows > 2});
    if (strips_.back().is_thick) strips_.back().outline = outline_of(curve, ladder.along, strip.thickness() / 2);
    ParticleSet& set = result_.particles;

    std::vector<Vec> middles;
    middles.reserve(static_cast<std::size_t>(ladder.columns()));
    for (int column = 0; column < ladder.columns(); ++column)
        middles.emplace_back(0.5 * (ladder.nodes[rows * column] + ladder.nodes[rows * column + rows - 1]));
    const std::vector<bool> anchored = anchored_columns(part, curve, middles, ladder.along);

    const int first = static_cast<int>(set.size());
    const double mass = part.mass_per_length * ladder.along / rows;
    for (int n = 0; n < rows * ladder.columns(); ++n) {
        const int column = n / rows;
        // The strip ends in its last column, which has half a cell; in the liquid's sums it reaches half a spacing on.
        const bool is_at_an_end = column == 0 || column + 1 == ladder.columns();
        add_particle(part_number, {ladder.nodes[n], strip.apart * ladder.along,
                                   is_at_an_end && !goes_on ? mass / 2 : mass, body, anchored[column], Vec::Zero(), 0});
        nodes_.add(ladder.nodes[n], {.of_a_solid = false, .anchored = anchored[column]});
    }
    nodes_.sort(spacing_);

    const auto bond = [&](int a, int b, double stiffness) {
        set.bonds.push_back({a, b, nearest_image(set.position[a] - set.position[b], set).norm(), stiffness});
        ++line.bonds;
    };
    const auto hinge = [&](int a, int centre, int b) {
        const double rest = angle_between(nearest_image(set.position[a] - set.position[centre], set),
                                          nearest_image(set.position[b] - set.position[centre], set));
        set.hinges.push_back({a, centre, b, rest, constants.hinge_stiffness});
        ++line.hinges;
    };
    for (int c = 0; c < ladder.columns(); ++c) {
        const bool is_last = c + 1 == ladder.columns();
        const int column = first + rows * c, next_column = is_last ? first : column + rows;
        for (int row = 0; row + 1 < rows; ++row) bond(column + row, column + row + 1, constants.rung_stiffness);
        if (is_last && !goes_on) break;
        for (int row = 0; row < rows; ++row) bond(column + row, next_column + row, constants.bond_stiffness);
        for (int row = 0; row + 1 < rows; ++row) {
            const int left = column + row, right = left + 1, next_left = next_column + row, next_right = next_left + 1;
            if (constants.cross_stiffness > 0) {
                bond(left, next_right, constants.cross_stiffness);
                bond(right, next_left, constants.cross_stiffness);
            }
            if (constants.hinge_stiffness == 0) continue;
            hinge(next_left, left, right);
            hinge(left, right, next_right);
            hinge(right, next_right, next_left);
            hinge(next_right, next_left, left);
        }
    }
    ++line.bodies;
    line.anchored += static_cast<std::size_t>(rows * std::count(anchored.begin(), anchored.end(), true));
    line.bond_stiffness = constants.bond_stiffness;
    line.hinge_stiffness = constants.hinge_stiffness;
    line.cross_stiffness = constants.cross_stiffness;
    line.bending_stiffness = constants.bending_stiffness();
    line.axial_stiffness = constants.axial_stiffness();
    line.shear_stiffness = constants.shear_stiffness();
    line.particle_mass = mass;
}

std::vector<Vec> ParticleBuilder::anchors_of(const Part& part, const Polyline& curve) const {
    if (part.anchor->empty()) return {};
    const auto points = geometry_.points.find(part.anchor);
    if (points != geometry_.points.end()) return points->second;
    const NearestCurve held_by(*geometry_.curve_set(part.anchor), touching * spacing_);
    std::vector<Vec> ends;
    for (const Vec& end : {curve.points.front(), curve.points.back()})
        if (held_by.nearest(end)) ends.push_back(end);
    return ends;
}

std::vector<bool> ParticleBuilder::anchored_columns(const Part& part, const Polyline& curve,
                                                    const std::vector<Vec>& middles, double along) const {
    std::vector<bool> anchored(middles.size(), false);
    for (const Vec& anchor : anchors_of(part, curve)) {
        const auto distance = [&](const Vec& middle) {
            return nearest_image(middle - anchor, result_.particles).norm();
        };
        const auto nearest = std::min_element(middles.begin(), middles.end(),
                                              [&](const Vec& a, const Vec& b) { return distance(a) < distance(b); });
        if (distance(*nearest) < 0.51 * along) anchored[static_cast<std::size_t>(nearest - middles.begin())] = true;
    }
    return anchored;
}

}  // namespace dmp::mesher
