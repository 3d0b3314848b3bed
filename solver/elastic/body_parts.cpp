// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic/body_parts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

#include "base/errors.hpp"
#include "models/springs/bond_force.hpp"
#include "models/springs/dihedral_force.hpp"
#include "models/springs/hinge_force.hpp"
#include "particles/whole_periods.hpp"
#include "solver/elastic/node_mass.hpp"
#include "solver/elastic/self_contact.hpp"
#include "solver/state/loaded_groups.hpp"

namespace dmp::solver {

std::vector<std::string> body_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const Part* part : scene.parts_of(PartKind::elastic)) names.push_back(*part->name);
    for (const Solidify& rule : scene.solidify) names.push_back(*rule.name);
    for (const Join* join : scene.joins_of_enabled()) names.push_back(*join->name);
    return names;
}

namespace {

InitialSprings::Source source_of(const Part& part, int origin) {
    // A mode of angular frequency omega has the ratio relaxation omega / 2.
    const double relaxation =
        part.damping_ratio.given() ? part.damping_ratio / (std::numbers::pi * part.damping_frequency) : 0;
    return {origin,
            part.damping_ratio.given() ? 0 : *part.bond_damping,
            part.drag,
            part.mass_damping,
            part.elastic_law,
            part.youngs_modulus,
            part.poisson_ratio,
            relaxation,
            part.initial_velocity};
}

}  // namespace

Vec InitialSprings::Source::velocity_at(const Vec& position, int dimension) const {
    Vec velocity = Vec::Zero();
    for (int axis = 0; axis < dimension; ++axis)
        velocity[axis] = (*initial_velocity)[static_cast<std::size_t>(axis)](0, position[0], position[1], position[2]);
    if (!velocity.allFinite()) {
        std::ostringstream problem;
        problem << "initial_velocity is (" << velocity.transpose() << ") m/s at (" << position.transpose() << ") m";
        throw InputError(initial_velocity.location, problem.str(), "correct the formula");
    }
    return velocity;
}

InitialSprings::InitialSprings(const ParticleSet& set, const Scene& scene, double liquid_density)
    : of_part(set.parts.size()) {
    const auto parts = scene.parts_of(PartKind::elastic);
    for (std::size_t number = 0; number < set.parts.size(); ++number) {
        const auto& [name, kind] = set.parts[number];
        if (kind != PartKind::elastic) continue;
        const auto part = std::ranges::find(parts, name, [](const Part* each) { return *each->name; });
        if (part == parts.end())
            throw InputError("the particles have an elastic solid '" + name + "' that is not in the scene",
                             "mesh the scene again");
        of_part[number] = source_of(**part, static_cast<int>(part - parts.begin()));
        of_part[number].may_tear =
            std::ranges::any_of(scene.breaking, [&](const auto& rule) { return *rule.part == name; });
    }
    node_mass = node_masses(scene, set, liquid_density);  // of parts that are known to be in the scene
    const auto joins = scene.joins_of_enabled();
    const auto before = static_cast<int>(body_names(scene).size() - joins.size());
    for (const Bond& bond : set.bonds)
        if (bond.join >= static_cast<int>(joins.size()))
            throw InputError("the particles have bonds of a [[join]] that is not in the scene", "mesh the scene again");
    for (const Join* join : joins) of_join.push_back({before + static_cast<int>(of_join.size()), join->damping});
}

InitialSprings::InitialSprings(const ParticleSet& set, const Part& part)
    : of_part(set.parts.size(), source_of(part, 0)), node_mass(set.mass) {}

namespace {

/// From one particle to another, by the shortest way through periodic sides [m].
Vec apart(const ParticleSet& set, int from, int to) {
    return nearest_image(set.position[to] - set.position[from], set);
}

/// BodyParts::Spring::shift of a spring between these particles.
template <class Law>
std::array<Vec, Law::arms.size()> shift_of(const ParticleSet& set, const std::array<int, Law::nodes>& ids) {
    std::array<Vec, Law::arms.size()> shift;
    for (std::size_t k = 0; k < shift.size(); ++k)
        shift[k] = periods_to_nearest(set.position[ids[Law::arms[k].end]] - set.position[ids[Law::arms[k].start]], set);
    return shift;
}

/// The particles of a body and the wall particles bonded to it, sorted by id.
std::vector<int> nodes_of(const ParticleSet& set, int body) {
    std::vector<int> ids;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.body[i] == body) ids.push_back(static_cast<int>(i));
    for (const Bond& bond : set.bonds) {
        if (set.body[bond.a] == body && set.body[bond.b] < 0) ids.push_back(bond.b);
        if (set.body[bond.b] == body && set.body[bond.a] < 0) ids.push_back(bond.a);
    }
    std::ranges::sort(ids);
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());  // Clang 14 has no std::ranges::unique
    return ids;
}

}  // namespace

BodyParts initial_body(const ParticleSet& set, const InitialSprings& drawn, int body, double contact_range) {
    const std::vector<double>& mass = drawn.node_mass;
    BodyParts parts;
    std::unordered_map<int, int> local;
    std::vector<Vec> positions;
    for (const int id : nodes_of(set, body)) {
        local[id] = static_cast<int>(parts.nodes.size());
        const InitialSprings::Source& source = drawn.of_part[set.part[id]];
        BodyParts::Node node;
        node.id = id;
        node.of_wall = set.body[id] < 0;
        node.fixed = set.fixed[id] != 0;
        node.origin = source.origin;
        node.mass = mass[id];
        node.drag = source.drag_of(set.mass[id]);
        node.position = node.position_before = node.rest_position = set.position[id];
        if (!node.fixed && !node.of_wall) node.velocity = source.velocity_at(node.position, set.dimension);
        node.surface = set.surface(static_cast<std::size_t>(id));
        parts.nodes.push_back(node);
        positions.push_back(set.position[id]);
    }

    double longest = 0;
    for (const Bond& bond : set.bonds) {
        if (set.body[bond.a] != body && set.body[bond.b] != body) continue;
        const InitialSprings::Source& source =
            bond.join >= 0 ? drawn.of_join.at(bond.join) : drawn.of_part[set.part[bond.a]];
        const Spring spring(bond.stiffness, source.damping, reduced_mass(mass[bond.a], mass[bond.b]));
        parts.bonds.push_back({{local.at(bond.a), local.at(bond.b)},
                               bond.rest_length,
                               spring.stiffness,
                               spring.dashpot,
                               source.origin,
                               shift_of<BondForce<3>>(set, {bond.a, bond.b})});
        longest = std::max(longest, bond.rest_length);
    }
    for (const Hinge& hinge : set.hinges) {
        if (set.body[hinge.centre] != body) continue;
        const auto inertia = [&](int end) { return mass[end] * apart(set, hinge.centre, end).squaredNorm(); };
        const InitialSprings::Source& source = drawn.of_part[set.part[hinge.centre]];
        const Spring spring(hinge.stiffness, source.damping, reduced_mass(inertia(hinge.a), inertia(hinge.b)));
        parts.hinges.push_back({{local.at(hinge.a), local.at(hinge.centre), local.at(hinge.b)},
                                hinge.rest_angle,
                                spring.stiffness,
                                spring.dashpot,
                                source.origin,
                                shift_of<HingeForce<3>>(set, {hinge.a, hinge.centre, hinge.b})});
    }
    for (const Dihedral& dihedral : set.dihedrals) {
        if (set.body[dihedral.b] != body) continue;
        if (set.dimension != 3)
            throw InputError("'" + set.parts[set.part[dihedral.b]].name + "' has dihedrals, and there are none in 2-D",
                             "write dimension = 3, or leave them out");
        const Vec axis = apart(set, dihedral.b, dihedral.c).normalized();
        const auto inertia = [&](int end) { return mass[end] * axis.cross(apart(set, dihedral.b, end)).squaredNorm(); };
        const InitialSprings::Source& source = drawn.of_part[set.part[dihedral.b]];
        const Spring spring(dihedral.stiffness, source.damping, reduced_mass(inertia(dihedral.a), inertia(dihedral.d)));
        parts.dihedrals.push_back(
            {{local.at(dihedral.a), local.at(dihedral.b), local.at(dihedral.c), local.at(dihedral.d)},
             dihedral.rest_angle,
             spring.stiffness,
             spring.dashpot,
             source.origin,
             shift_of<DihedralForce>(set, {dihedral.a, dihedral.b, dihedral.c, dihedral.d})});
    }
    if (contact_range > 0)
        parts.held_apart = pairs_within(positions, set.dimension, neighbourhood_of_contact(contact_range, longest));
    return parts;
}

namespace {

[[noreturn]] void refuse_damaged_bodies() {
    throw InputError("the checkpoint's elastic bodies are damaged", "start the run anew");
}

/// A sequence of numbers, for reading and for writing.
class Stream {
  public:
    Stream(std::vector<double>& numbers, bool reading) : numbers_(numbers), reading_(reading) {}
    [[nodiscard]] bool at_end() const { return next_ == numbers_.size(); }

    void operator()(double& value) {
        if (reading_) {
            if (at_end()) refuse_damaged_bodies();
            value = numbers_[next_++];
        } else {
            numbers_.push_back(value);
        }
    }
    void operator()(int& value) { through<int>(value); }
    void operator()(bool& value) { through<bool>(value); }
    void operator()(Vec& value) {
        for (int axis = 0; axis < 3; ++axis) (*this)(value[axis]);
    }
    template <class T, class Each>
    void list(std::vector<T>& values, const Each& each) {
        auto size = static_cast<int>(values.size());
        (*this)(size);
        // Each entry takes a number at least.
        if (reading_ && (size < 0 || static_cast<std::size_t>(size) > numbers_.size() - next_)) refuse_damaged_bodies();
        values.resize(static_cast<std::size_t>(size));
        for (T& value : values) each(value);
    }

  private:
    template <class T>
    void through(T& value) {
        auto number = static_cast<double>(value);
        (*this)(number);
        const double end = std::ldexp(1.0, std::numeric_limits<T>::digits);  // a maximum may round up to it
        if (!(number >= static_cast<double>(std::numeric_limits<T>::min()) && number < end)) refuse_damaged_bodies();
        value = static_cast<T>(number);
    }
    std::vector<double>& numbers_;
    bool reading_;
    std::size_t next_ = 0;
};

void archive_surface(Stream& through, SolidSurface& surface) {
    auto& [normal, depth, opposite] = surface;  // all: one more does not compile
    through(normal);
    through(depth);
    through(opposite);
}

void archive_cell(Stream& through, BodyParts::Cell& cell) {
    auto& [id, node, shift, size, centroid, moment, volume, mass, law, youngs_modulus, poisson_ratio, relaxation, drag,
           origin, surface] = cell;  // all: one more does not compile
    through(id);
    for (int& corner : node) through(corner);
    for (Vec& of_corner : shift) through(of_corner);
    for (Vec* vector : {&size, &centroid, &moment}) through(*vector);
    auto number = static_cast<int>(law.number());
    through(number);
    if (number < 0 || static_cast<std::size_t>(number) >= ElasticLaws::size) refuse_damaged_bodies();
    law = ElasticLaw(static_cast<std::size_t>(number));
    for (double* value : {&volume, &mass, &youngs_modulus, &poisson_ratio, &relaxation, &drag}) through(*value);
    through(origin);
    archive_surface(through, surface);
}

/// Whether all springs and pairs are between nodes that the body has.
bool joins_own_nodes(const BodyParts& body) {
    const auto own = [&](int node) { return node >= 0 && static_cast<std::size_t>(node) < body.nodes.size(); };
    const auto all_own = [&](const auto& springs) {
        return std::ranges::all_of(springs, [&](const auto& spring) { return std::ranges::all_of(spring.node, own); });
    };
    const auto& [nodes, bonds, hinges, dihedrals, cells, faces, held_apart] = body;  // all: one more does not compile
    const std::size_t particles = cells.empty() ? nodes.size() : cells.size();
    const auto is_particle = [&](int k) { return k >= 0 && static_cast<std::size_t>(k) < particles; };
    const auto is_cell = [&](int k) { return k >= 0 && static_cast<std::size_t>(k) < cells.size(); };
    return all_own(bonds) && all_own(hinges) && all_own(dihedrals) && all_own(cells) &&
           std::ranges::all_of(faces,
                               [&](const auto& face) {
                                   return std::ranges::all_of(face.cell, is_cell) && face.axis >= 0 && face.axis < 3;
                               }) &&
           std::ranges::all_of(held_apart,
                               [&](const auto& pair) { return is_particle(pair.first) && is_particle(pair.second); });
}

}  // namespace

void archive(Archive& file, const std::string& name, std::vector<BodyParts>& bodies) {
    std::vector<double> numbers;
    if (file.loading()) file(name, numbers);
    Stream through(numbers, file.loading());
    const auto springs = [&](auto& list) {
        through.list(list, [&](auto& spring) {
            for (int& node : spring.node) through(node);
            through(spring.rest);
            through(spring.stiffness);
            through(spring.dashpot);
            through(spring.origin);
            for (Vec& of_arm : spring.shift) through(of_arm);
        });
    };
    if (file.loading()) bodies.clear();
    through.list(bodies, [&](BodyParts& body) {
        auto& [nodes, bonds, hinges, dihedrals, cells, faces, held_apart] = body;
        through.list(nodes, [&](BodyParts::Node& node) {
            through(node.id);
            through(node.fixed);
            through(node.of_wall);
            for (bool& on_plane : node.on_plane) through(on_plane);
            through(node.origin);
            through(node.mass);
            through(node.drag);
            for (Vec* vector : {&node.position, &node.velocity, &node.position_before, &node.rest_position})
                through(*vector);
            archive_surface(through, node.surface);
        });
        springs(bonds);
        springs(hinges);
        springs(dihedrals);
        through.list(cells, [&](BodyParts::Cell& cell) { archive_cell(through, cell); });
        through.list(faces, [&](BodyParts::Face& face) {
            for (int& cell : face.cell) through(cell);
            through(face.axis);
        });
        through.list(held_apart, [&](std::pair<int, int>& pair) {
            through(pair.first);
            through(pair.second);
        });
    });
    if (!file.loading()) file(name, numbers);
    if (file.loading() && !std::ranges::all_of(bodies, joins_own_nodes))
        throw unlike_any_run("springs between nodes that are not there");
}

}  // namespace dmp::solver
