// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_view.hpp"

#include "cli/uses.hpp"
#include "mesher/bond_report.hpp"

namespace dmp::cli {

MeshView mesh_view(const ParticleSet& particles, const MeshDetail& detail, const std::string& title) {
    MeshView mesh;
    mesh.title = title;
    mesh.dimension = particles.dimension;
    mesh.spacing = particles.spacing;
    mesh.position = particles.position;
    mesh.kernel_sum = detail.kernel_sum;
    mesh.surface_error = detail.surface_error;
    mesh.valence = valence(particles);
    mesh.kind.reserve(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const PartKind kind = particles.kind(i);
        mesh.kind.push_back(kind == PartKind::fluid   ? MeshView::Kind::fluid
                            : kind == PartKind::rigid ? MeshView::Kind::wall
                                                          : MeshView::Kind::solid);
    }
    for (const Bond& bond : particles.bonds) {
        const Vec apart =
            particles.position[static_cast<std::size_t>(bond.a)] - particles.position[static_cast<std::size_t>(bond.b)];
        if (apart.norm() < 2 * bond.rest_length) mesh.bond_ends.insert(mesh.bond_ends.end(), {bond.a, bond.b});
    }
    return mesh;
}

}  // namespace dmp::cli
