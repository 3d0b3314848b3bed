// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// What FluidStep keeps in a checkpoint.
#include <algorithm>

#include "solver/contact/surface_contact.hpp"
#include "solver/state/loaded_groups.hpp"
#include "solver/time/fluid_step.hpp"

namespace dmp::solver {

void FluidStep::archive(Archive& file) {
    file("fluid/largest_speed", largest_speed_);
    if (settings_.repulsion_strength > 0 && !file.starts_run()) file("fluid/contact_rate", contact_rate_);
    if (settings_.corrected) {
        reference_.archive(file);
        if (file.loading()) check_chambers();
        file("fluid/bodies_shown", bodies_shown_);
    }
    if (!file.starts_run()) archive_accounts(file);
    springs_.archive(file);
    if (file.loading())
        for (const ParticleTag& tag : particles_.of(PartKind::elastic).tags())
            if (!springs_.holds(tag.id)) throw unlike_any_run("an elastic particle that is a node of no body");
    if (surface_contact_ && file.loading()) surface_contact_->find_bodies(springs_);
    if (surface_contact_) surface_contact_->archive(file);
    walls_.archive(file);
    if (species_) species_->archive(file);
    if (file.loading()) neighbours_.forget();
}

void FluidStep::check_chambers() const {
    const ParticleGroup& fluid = particles_.fluid();
    const auto count = static_cast<double>(std::max<std::size_t>(1, reference_.chamber_excess().size()));
    for (std::size_t i = 0; fluid.has(Field::chamber) && i < fluid.owned(); ++i) {
        const double chamber = fluid.data(Field::chamber)[i];
        if (!(chamber >= 0 && chamber < count)) throw unlike_any_run("a particle of a chamber that there is not");
    }
}

/// And what follows from the driving of the last step, which a new run may not have.
void FluidStep::archive_accounts(Archive& file) {
    file("fluid/impulse_of_body_forces", impulses_.of_body_forces);
    file("fluid/impulse_of_fixed", impulses_.of_fixed);
    file("fluid/impulse_of_drag", impulses_.of_drag);
    if (viscosity_) viscosity_->archive(file);
    driving_.archive(file);
}

}  // namespace dmp::solver
