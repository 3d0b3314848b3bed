// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_view.hpp"

#include "cli/uses.hpp"
#include "mesher/bond_report.hpp"

namespace dmp::cli {

MeshLook mesh_look(const ParticleSet& particles, const MeshDetail& detail, const std::string& title) {
    MeshLook look;
    look.title = title;
    look.dimension = particles.dimension;
    look.spacing = particles.spacing;
    look.position = particles.position;
    look.kernel_sum = detail.kernel_sum;
    look.surface_error = detail.surface_error;
    look.valence = valence(particles);
    look.kind.reserve(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const ParticleKind kind = particles.kind(i);
        look.kind.push_back(kind == ParticleKind::fluid   ? MeshLook::Kind::fluid
                            : kind == ParticleKind::rigid ? MeshLook::Kind::wall
                                                          : MeshLook::Kind::solid);
    }
    for (const Bond& bond : particles.bonds) {
        const Vec apart =
            particles.position[static_cast<std::size_t>(bond.a)] - particles.position[static_cast<std::size_t>(bond.b)];
        if (apart.norm() < 2 * bond.rest_length) look.bond_ends.insert(look.bond_ends.end(), {bond.a, bond.b});
    }
    return look;
}

}  // namespace dmp::cli
