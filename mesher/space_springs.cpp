// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the SpaceBuilder: bodies of springs.
#include <algorithm>
#include <sstream>

#include "base/length_text.hpp"
#include "geometry/local_thickness.hpp"
#include "geometry/mid_surface.hpp"
#include "geometry/surface_pieces.hpp"
#include "mesher/relax.hpp"
#include "mesher/space_builder.hpp"
#include "mesher/spring_bodies.hpp"
#include "mesher/straight_bar.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

namespace {

/// A node nearer than this to its anchor is clamped: the first layer of a solid, which stands half a spacing from its
/// surface, and the edge of a sheet [spacings].
constexpr double solid_clamped_within = 0.75, sheet_clamped_within = 0.25;

/// A solid of cells must be that thick, or it becomes a shell [spacings].
constexpr double thinnest_solid = 2;

/// Fluid that is moved stays this far from walls: its first layer on the lattice is half a spacing from them
/// [spacings].
constexpr double wall_distance = 0.45;

bool is_within(const NearestTriangle& sheet, const Vec& point, double distance) {
    const auto found = sheet.nearest(point);
    return found && found->distance < distance;
}

/// Of a shell whose membrane could not be as stiff as asked for, by more than a tenth; else empty.
std::string softness_text(const Part& part, const MeshReport::SpringLine& line) {
    const double asked = line.shell->membrane_stiffness_asked, is = line.shell->constants.membrane_stiffness();
    if (is >= 0.9 * asked) return {};
    std::ostringstream text;
    text << part.name.value << ": E h lowered from " << asked << " to " << is
         << " N/m, so that two layers can bend as softly as D asks; D is held";
    return text.str();
}

}  // namespace

bool SpaceBuilder::take_as_sheet(const Part& part, const Solid& solid) {
    const double limit = thinnest_solid * spacing_;
    if (local_thickness(solid.surface, spacing_).share_thinner((1 - 1e-9) * limit) <= 0.5) return false;
    // Where most of it is thin, some may be a little thicker.
    SheetSearch found = mid_surface(solid.surface, 1.5 * limit);
    std::ostringstream text;
    text.precision(3);
    if (!found.sheet && scene_.is_of_cells(part)) return false;  // which need no two of them across
    if (!found.sheet) {
        text << "'" << part.name.value << "' is thinner than two spacings, " << length_text(found.thickness) << " near "
             << position_text(found.where) << ", and no sheet that could become a shell: " << found.problem;
        throw InputError(part.name.location, text.str(),
                         "draw the surface in its middle, with `thickness`, or refine particles.spacing to less than "
                         "half of its thickness");
    }
    ThinSolid thin{&part, part, std::move(found.sheet->surface)};
    thin.shell.thickness.value = found.sheet->thickness;
    text << part.name.value << ": a sheet of " << length_text(found.sheet->thickness) << ", from "
         << length_text(found.sheet->least) << " to " << length_text(found.sheet->most)
         << " thick, less than two spacings: it becomes a shell on the surface in "
         << "its middle";
    result_.report.notes.push_back(text.str());
    thin_solids_.push_back(std::move(thin));
    return true;
}

void SpaceBuilder::claim_elastic(const Part& part, const Solid& solid) {
    if (scene_.is_of_cells(part))
        claim_cells(part, solid);
    else
        claim_points(part, solid);
}

/// Takes the lattice points inside the solid that belong to whole cells; the others stay for what is drawn there too.
void SpaceBuilder::claim_points(const Part& part, const Solid& solid) {
    const bool on_cells = !part.bonds_within.given();
    if (on_cells && *scene_.particles.arrangement != Arrangement::square)
        throw InputError(
            scene_.particles.arrangement.location,
            "'" + part.name.value + "' is a solid of springs, whose cells are built on the cubic lattice only",
            "write particles.arrangement = \"square\", or give the part bonds_within");
    const std::int16_t owner = owner_of_wall(walls_.size() + spring_solids_.size());
    claim(solid.surface, owner);
    SpringSolid& taken = spring_solids_.emplace_back(SpringSolid{&part, {}});
    std::vector<std::size_t> position;
    std::size_t index = 0;
    for_each_point([&](std::int16_t here, const auto& at) {
        if (here == owner) {
            const Vec point = at();
            if (is_beyond_a_plane(point)) {
                owner_[index] = nobody;
            } else {
                position.push_back(index);
                taken.points.push_back(point);
            }
        }
        ++index;
    });
    const std::vector<bool> whole =
        on_cells ? in_whole_cells(taken.points, lattice_step(), 3, points_in_period(result_.particles, lattice_step()))
                 : std::vector<bool>(taken.points.size(), true);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < position.size(); ++k)
        if (whole[k]) {
            taken.points[kept++] = taken.points[k];
        } else {
            owner_[position[k]] = nobody;
            in_no_cell_.push_back(position[k]);
        }
    taken.points.resize(kept);
    if (kept == 0)
        throw InputError(part.name.location,
                         "'" + part.name.value + "' is too thin for a solid of springs: no " +
                             (on_cells ? "cell" : "point") + " of the lattice fits in it",
                         "refine particles.spacing to a third of its thickness, or draw it as a surface, with "
                         "`thickness`, to make it a shell");
    if (kept < position.size())
        result_.report.notes.push_back(part.name.value + ": " + std::to_string(position.size() - kept) +
                                       " lattice points in it belong to no whole cell of springs and are left out");
}

/// Takes what the sheet's shell fills, a spacing to both sides, from the fluids.
void SpaceBuilder::clear_for_shell(const TriangleSurface& sheet) {
    const NearestTriangle& nearest = shells_.emplace_back(sheet, (0.5 + keep_from_nodes) * spacing_);
    std::size_t index = 0;
    for_each_point([&](std::int16_t here, const auto& at) {
        if (here >= 0 && is_within(nearest, at(), spacing_)) {
            ++taken_[static_cast<std::size_t>(here)];
            owner_[index] = in_a_shell;
        }
        ++index;
    });
}

/// Between a shell and the wall that it meets, fluid next to the wall cannot move away from the shell's nodes, half a
/// spacing beside the sheet.
bool SpaceBuilder::is_in_a_wedge(const Vec& point) const {
    const auto reaches = [&](const NearestTriangle& sheet) { return sheet.nearest(point).has_value(); };
    if (!std::ranges::any_of(shells_, reaches)) return false;
    const WallPoint wall = surface_at(point);
    return wall.wall >= 0 && wall.surface.distance < spacing_;
}

/// What is too near to a shell's nodes there is taken from the fluids, too.
void SpaceBuilder::clear_wedges() {
    std::size_t index = 0;
    for_each_point([&](std::int16_t here, const auto& at) {
        if (here >= 0 && is_in_a_wedge(at())) {
            ++taken_[static_cast<std::size_t>(here)];
            owner_[index] = in_a_shell;
        }
        ++index;
    });
}

void SpaceBuilder::add_elastic(const Part& part) {
    ParticleSet& set = result_.particles;
    const auto number = static_cast<int>(set.parts.size());
    set.parts.push_back({part.name, PartKind::elastic});
    MeshReport::SpringLine line;
    line.part = part.name;
    const std::size_t first = set.size();
    const auto solid = std::ranges::find(spring_solids_, &part, &SpringSolid::part);
    if (solid != spring_solids_.end() && solid->cells) {
        add_cells(*solid, number, line);
        line.bar = bar_of(part, geometry_.solid(part.name)->surface, *solid->cells);
        result_.report.springs.push_back(line);
        return;
    }
    if (solid != spring_solids_.end() && part.bonds_within.given()) {
        // bond_solids() bonds them once they are where they stay.
        line.particle_mass = lattice_->cell_volume() * part.density;
        for (const Vec& point : solid->points) add_particle(point, number, part.density);
        std::fill(set.body.begin() + static_cast<std::ptrdiff_t>(first), set.body.end(), bodies_++);
    } else if (solid != spring_solids_.end()) {
        const SolidBody body = solid_body(part, solid->points, lattice_step(), set);
        line.cells = {body.constants, body.stiffened};
        line.particle_mass = body.mass.front();
        add_body(body, number, line);
    } else {
        const auto thin = std::ranges::find(thin_solids_, &part, &ThinSolid::part);
        const bool is_thick_in_cad_model = thin != thin_solids_.end();
        const Part& of = is_thick_in_cad_model ? thin->shell : part;
        const TriangleSurface& surface =
            is_thick_in_cad_model ? thin->middle : geometry_.surface_set(part.name)->surface;
        const auto anchor =
            anchor_of(part) == nullptr
                ? std::nullopt
                : std::optional<NearestTriangle>(std::in_place, *anchor_of(part), sheet_clamped_within * spacing_);
        const auto is_clamped = [&](const Vec& point) { return anchor && anchor->nearest(point).has_value(); };
        const SurfacePieces pieces(surface);
        for (const SurfacePiece& piece : pieces.all()) {
            const ShellBody body = shell_body(of, part_of(surface, piece.triangles), set, is_clamped);
            line.shell = {body.constants, body.membrane_stiffness_asked};
            line.particle_mass = of.density * of.thickness * spacing_ * spacing_ / 2;
            add_body(body, number, line);
        }
        if (std::string text = softness_text(part, line); !text.empty())
            result_.report.warnings.push_back(std::move(text));
    }
    if (solid != spring_solids_.end()) {
        const TriangleSurface& surface = geometry_.solid(part.name)->surface;
        share_drawn_mass(part, surface.enclosed_volume(), surface.corners, first, set, line, result_.report);
    }
    clamp(part, first, line);
    note_open_ends(set, first, part.name, solid != spring_solids_.end(), result_.report);
    result_.report.springs.push_back(line);
}

std::vector<Sheet> SpaceBuilder::sheets() const {
    std::vector<Sheet> sheets;
    for (const Part* part : scene_.parts_of(PartKind::elastic)) {
        if (std::ranges::find(spring_solids_, part, &SpringSolid::part) != spring_solids_.end()) continue;
        const auto thin = std::ranges::find(thin_solids_, part, &ThinSolid::part);
        if (thin != thin_solids_.end())
            sheets.push_back({part, thin->shell.thickness, {}, thin->middle});
        else
            sheets.push_back({part, part->thickness, {}, geometry_.surface_set(part->name)->surface});
    }
    return sheets;
}

void SpaceBuilder::add_body(const SpringBody& body, int part, MeshReport::SpringLine& line) {
    ParticleSet& set = result_.particles;
    const std::size_t first = set.size();
    const int bodies_before = bodies_;
    const std::vector<int> piece = pieces_of(body.lattice, bodies_);
    for (std::size_t node = 0; node < body.lattice.nodes.size(); ++node) {
        add_particle(body.lattice.nodes[node], part, 0);
        set.volume.back() = body.volume[node];
        set.mass.back() = body.mass[node];
        set.body.back() = piece[node];
    }
    line.bodies += bodies_ - bodies_before;
    add_elastic_of(body.lattice, first, set, line);
}

void SpaceBuilder::clamp(const Part& part, std::size_t first, MeshReport::SpringLine& line) {
    if (part.anchor->empty()) return;
    ParticleSet& set = result_.particles;
    const double clamped_within = line.shell ? sheet_clamped_within : solid_clamped_within;
    const NearestTriangle anchor(*anchor_of(part), clamped_within * spacing_);
    for (std::size_t i = first; i < set.size(); ++i) {
        // A shell's nodes stand half a spacing beside its sheet, whose edge is what touches the anchor.
        const Vec position =
            line.shell ? Vec((set.position[i] + set.position[first + ((i - first) ^ 1U)]) / 2) : set.position[i];
        if (!anchor.nearest(position)) continue;
        set.fixed[i] = 1;
        ++line.anchored;
    }
    if (line.anchored == 0) {
        std::ostringstream problem;
        problem << "no node of '" << part.name.value << "' is within " << clamped_within << " spacings of '"
                << part.anchor.value << "'";
        throw InputError(part.anchor.location, problem.str(),
                         "draw the part so that it touches what it is anchored to");
    }
}

bool SpaceBuilder::may_stand(const Vec& point) const {
    if (is_beyond_a_plane(point)) return false;
    const auto wall = surface_at(point);
    if (wall.wall >= 0 && wall.surface.distance < wall_distance * spacing_) return false;
    return !is_in_a_shell(point);
}

/// Within a spacing of its surface, where its nodes stand.
bool SpaceBuilder::is_in_a_shell(const Vec& point) const {
    return std::ranges::any_of(shells_,
                               [&](const NearestTriangle& shell) { return is_within(shell, point, spacing_); });
}

}  // namespace dmp::mesher
