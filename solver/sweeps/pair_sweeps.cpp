// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/sweeps/pair_sweeps.hpp"

#include <stdexcept>

#include "base/unlisted_value.hpp"
#include "models/sph/viscous_laws.hpp"
#include "solver/parallel/with_vector_unit.hpp"
#include "solver/sweeps/compiled_sweeps.hpp"

namespace dmp::solver {

namespace {

/// Whether particles of solids have a density and a pressure of their own.
bool solids_have_a_state(WallModel model) {
    switch (model) {
        case WallModel::plain:
            return true;
        case WallModel::extrapolated:
            return false;
    }
    unlisted_value(model);
}

void declare_fields(const PairSettings& settings, ParticleStore& particles) {
    const bool with_state = solids_have_a_state(settings.walls.model), contact = settings.repulsion_strength > 0;
    for (ParticleGroup& group : particles.groups()) {
        const bool is_fluid = group.kind() == PartKind::fluid;
        if (is_fluid || with_state) group.declare({Field::density, Field::pressure});
        if ((is_fluid && !settings.density.by_summation) || with_state) group.declare({Field::density_rate});
        if (is_fluid) group.declare({Field::viscosity});
        if (is_fluid && settings.shifting > 0) group.declare({Field::shift});
        if (is_fluid && settings.transport_velocity) group.declare({Field::shift, Field::transport_velocity});
        if (is_fluid && settings.gradient_correction)
            group.declare({Field::correction, Field::correction_off_diagonal});
        if (is_fluid && settings.corrected)
            group.declare({Field::mean_correction, Field::velocity_gradient, Field::density_gradient,
                           Field::next_density_gradient, Field::reduced_pressure, Field::off_walls});
        if (is_fluid && settings.corrected && settings.several_fluids) group.declare({Field::fluid_number});
        if (group.kind() == PartKind::elastic && settings.dry_bodies)
            group.declare({Field::whole_pressure, Field::level_force});
        if (is_fluid && settings.chambers) group.declare({Field::chamber});
        if (contact) group.declare({Field::contact_range});
        if (contact && !is_fluid) group.declare({Field::wall_contact_range});
        if (settings.viscosity.implicit) group.declare({Field::viscous_force});
        if (settings.viscosity.implicit && group.kind() != PartKind::rigid)
            group.declare(
                {Field::viscous_velocity, Field::viscous_residual, Field::viscous_direction, Field::viscous_diagonal});
        if (group.kind() == PartKind::elastic && (!with_state || settings.corrected))
            group.declare({Field::wall_normal, Field::wall_distance, Field::opposite_distance, Field::held,
                           Field::surface_gradient});
        if (group.kind() != PartKind::rigid) continue;
        group.declare({Field::wall_normal, Field::wall_distance});
        if (settings.walls.slip) group.declare({Field::wall_slip});
        if (settings.walls.moving && !with_state) group.declare({Field::wall_acceleration});
        if (settings.corrected && (settings.walls.moving || settings.walls.sliding))
            group.declare({Field::wall_motion, Field::surface_gradient});
        if (settings.corrected && (settings.walls.slip || settings.walls.sliding)) group.declare({Field::wall_sliding});
    }
}

template <VectorUnit unit>
std::unique_ptr<PairSweeps> sweeps_for(const PairSettings& settings, int dimension) {
    switch (settings.kernel) {
        case KernelKind::wendland_c2:
            return compiled_sweeps<unit, KernelLoops::wendland_c2>(settings, dimension);
        case KernelKind::wendland_c4:
        case KernelKind::lucy:
        case KernelKind::cubic_spline:
        case KernelKind::quintic_spline:
            return compiled_sweeps<unit, KernelLoops::any>(settings, dimension);
    }
    unlisted_value(settings.kernel);
}

}  // namespace

std::unique_ptr<PairSweeps> make_pair_sweeps(const PairSettings& settings, ParticleStore& particles) {
    const bool needs_gradient = settings.viscosity.law.visit([]<class Law>() { return models::needs_gradient<Law>(); });
    if (needs_gradient && !settings.corrected)
        throw std::logic_error("this viscous law needs the velocity gradient of the corrected scheme");
    declare_fields(settings, particles);
    return with_vector_unit(settings.vector_unit,
                            [&]<VectorUnit unit>() { return sweeps_for<unit>(settings, particles.dimension()); });
}

}  // namespace dmp::solver
