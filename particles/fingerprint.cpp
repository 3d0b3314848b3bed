// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/fingerprint.hpp"

#include <array>
#include <string_view>

#include "base/hex_text.hpp"
#include "base/text_hash.hpp"

namespace dmp::particles {

namespace {

/// Hashes numbers in blocks, each with that of the blocks before it: a set takes no memory a second time.
class Hash {
  public:
    template <class T>
    void add(const T& value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
        if (bytes_.size() >= block) fold();
    }
    void add(const Vec& vector) {
        for (int axis = 0; axis < 3; ++axis) add(vector[axis]);
    }
    void add(const std::string& text) {
        add(text.size());
        bytes_ += text;
    }
    template <class T>
    void add_all(const std::vector<T>& values) {
        add(values.size());
        for (const T& value : values) add(value);
    }
    std::string text() {
        fold();
        return hex_text(hash_);
    }

  private:
    static constexpr std::size_t block = 65536;

    void fold() {
        bytes_.append(reinterpret_cast<const char*>(&hash_), sizeof(hash_));
        hash_ = text_hash(bytes_);
        bytes_.clear();
    }

    std::string bytes_;
    std::uint64_t hash_ = 0;
};

void add_space(Hash& hash, const ParticleSpace& space) {
    hash.add(space.dimension);
    hash.add(space.spacing);
    hash.add(space.box.low);
    hash.add(space.box.high);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        hash.add(space.periodic.at(axis));
        for (const bool mirrored : space.mirrored.at(axis)) hash.add(mirrored);
    }
    hash.add(space.parts.size());
    for (const auto& part : space.parts) {
        hash.add(part.name);
        hash.add(part.kind);
    }
    hash.add(space.wall_planes.size());
    for (const WallPlane& plane : space.wall_planes) {
        hash.add(plane.part);
        hash.add(plane.point);
        hash.add(plane.normal);
    }
    hash.add_all(space.wall_corners);
    hash.add(space.wall_triangles.size());
    for (const WallTriangle& triangle : space.wall_triangles)
        for (const int number : {triangle.part, triangle.a, triangle.b, triangle.c}) hash.add(number);
    if (space.contact_pieces.empty()) return;  // others keep the fingerprint they had
    hash.add_all(space.contact_points);
    hash.add(space.contact_pieces.size());
    for (const ContactPiece& piece : space.contact_pieces) {
        for (const int number : {piece.part, piece.a, piece.b, piece.c}) hash.add(number);
        hash.add(piece.thickness);
    }
}

void add_springs(Hash& hash, const ParticleSet& set) {
    hash.add(set.bonds.size());
    for (const Bond& bond : set.bonds) {
        for (const int number : {bond.a, bond.b, bond.join}) hash.add(number);
        hash.add(bond.rest_length);
    }
    hash.add(set.hinges.size());
    for (const Hinge& hinge : set.hinges) {
        for (const int number : {hinge.a, hinge.centre, hinge.b}) hash.add(number);
        hash.add(hinge.rest_angle);
    }
    hash.add(set.dihedrals.size());
    for (const Dihedral& dihedral : set.dihedrals) {
        for (const int number : {dihedral.a, dihedral.b, dihedral.c, dihedral.d}) hash.add(number);
        hash.add(dihedral.rest_angle);
    }
}

/// Nothing where there are none, so that sets without cells keep the fingerprint they always had.
void add_cells(Hash& hash, const ParticleSet& set) {
    if (set.cells.empty()) return;
    hash.add(set.cell_nodes.size());
    for (const CellNode& node : set.cell_nodes) {
        hash.add(node.position);
        hash.add(node.fixed);
        for (const bool on_plane : node.on_plane) hash.add(on_plane);
    }
    hash.add(set.cells.size());
    for (const SolidCell& cell : set.cells) {
        hash.add(cell.particle);
        hash.add(cell.periods);
        for (const int node : cell.node) hash.add(node);
        for (const Vec& vector : {cell.size, cell.centroid, cell.moment}) hash.add(vector);
    }
}

}  // namespace

std::string fingerprint(const ParticleSet& set) {
    Hash hash;
    add_space(hash, set);
    hash.add_all(set.position);
    hash.add_all(set.volume);
    hash.add_all(set.part);
    hash.add_all(set.body);
    hash.add_all(set.fixed);
    hash.add_all(set.seated);
    hash.add_all(set.wall_normal);
    hash.add_all(set.wall_distance);
    if (!set.opposite_distance.empty()) hash.add_all(set.opposite_distance);  // others keep the fingerprint they had
    hash.add_all(set.radius);
    add_springs(hash, set);
    add_cells(hash, set);
    return hash.text();
}

}  // namespace dmp::particles
