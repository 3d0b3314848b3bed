// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/species/species_transport.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include "base/unlisted_value.hpp"
#include "particles/periodic_images.hpp"
#include "solver/implicit/species_system.hpp"
#include "solver/state/loaded_groups.hpp"
#include "solver/store/sums_over.hpp"
#include "solver/sweeps/reproducible_sum.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

std::vector<const Part*> parts_by_number(const Scene& scene, const ParticleSet& set) {
    std::vector<const Part*> parts;
    for (const auto& info : set.parts) parts.push_back(&scene.part_of_particles(info.name));
    return parts;
}

/// A formula's value; throws where it is none of a concentration.
double concentration_at(const std::string& of, const Value<Expression>& formula, double t, const Vec& at) {
    const double value = (*formula)(t, at[0], at[1], at[2]);
    if (value >= 0 && std::isfinite(value)) return value;
    std::ostringstream problem;
    problem << of << " is " << value << " at x = " << at[0] << ", y = " << at[1] << ", z = " << at[2] << " m, t = " << t
            << " s; a concentration is a number and not negative";
    throw InputError(formula.location, problem.str(), "correct the formula");
}

/// By part number [1/s].
std::vector<double> rates_of_uptake(const Species& species, const std::vector<const Part*>& parts) {
    std::vector<double> rates;
    for (const Part* part : parts) {
        const Value<double>* rate = species.uptake_in(*part);
        rates.push_back(rate != nullptr ? **rate : 0);
    }
    return rates;
}

/// One for all fluids, or -1.
double common_diffusivity(const Scene& scene, const Species& species) {
    const auto fluids = scene.parts_of(PartKind::fluid);
    const double first = **species.diffusivity.of(*fluids.front()->name);
    const bool alike =
        std::ranges::all_of(fluids, [&](const Part* part) { return **species.diffusivity.of(*part->name) == first; });
    return alike ? first : -1;
}

bool is_implicit(SpeciesStepping stepping) {
    switch (stepping) {
        case SpeciesStepping::explicitly:
            return false;
        case SpeciesStepping::implicitly:
            return true;
    }
    unlisted_value(stepping);
}

}  // namespace

SpeciesTransport::SpeciesTransport(const Scene& scene, const ParticleSet& set, ParticleStore& particles,
                                   const PairSettings& settings, std::vector<double> rest_density, const Ranks& ranks)
    : given_(scene.species),
      rest_density_(std::move(rest_density)),
      ranks_(ranks),
      threads_(settings.threads),
      implicit_(is_implicit(scene.numerics.species_stepping)),
      tolerance_(scene.numerics.species_tolerance),
      one_density_(std::ranges::all_of(rest_density_, [&](double one) { return one == rest_density_.front(); })) {
    for (const Species& species : given_) {
        CarriedSpecies carried;
        carried.number = static_cast<int>(species_.size());
        carried.diffusivity = common_diffusivity(scene, species);
        for (const Part* part : scene.parts_of(PartKind::rigid)) {
            const bool conducts = species.diffusivity_in(*part) != nullptr;
            carried.with_rigid |= conducts || species.wall_concentration.of(*part->name) != nullptr ||
                                  species.wall_flux.of(*part->name) != nullptr;
            conducts_in_solids_ |= conducts;
        }
        for (const Part* part : scene.parts_of(PartKind::elastic)) {
            const bool conducts = species.diffusivity_in(*part) != nullptr;
            carried.with_elastic |= conducts || species.wall_concentration.of(*part->name) != nullptr;
            conducts_in_solids_ |= conducts;
        }
        species_.push_back(carried);
    }
    declare(scene, particles);
    const auto parts = parts_by_number(scene, set);
    for (CarriedSpecies& carried : species_) {
        const Species& species = given_[static_cast<std::size_t>(carried.number)];
        fill(species, set, parts, particles, carried);
        fill_surfaces(scene, species, set, particles, carried);
        carried.largest_amount = at_least_something(ranks_.largest(carried.largest_amount));
        carried.largest_concentration = ranks_.largest(carried.largest_concentration);
        carried.largest_diffusivity = ranks_.largest(carried.largest_diffusivity);
        // Amounts in whole quanta, as those that are handed over are.
        const ReproducibleSum whole(carried.largest_amount);
        for (ParticleGroup& group : particles.groups()) {
            if (!group.has(Field::species_amount)) continue;
            double* amount = group.data(Field::species_amount, carried.number);
            for (std::size_t i = 0; i < group.owned(); ++i) amount[i] = whole(amount[i]);
        }
        uptake_.emplace_back(carried.number, rates_of_uptake(species, parts), carried.largest_amount, threads_);
        at_start_.push_back(held_by_particles(particles, static_cast<std::size_t>(carried.number)));
    }
    largest_volume_ = ranks_.largest(largest_volume_);
    excess_.assign(species_.size(), 0);
}

void SpeciesTransport::declare(const Scene& scene, ParticleStore& particles) {
    const auto any = [&](bool CarriedSpecies::*member) {
        return std::ranges::any_of(species_, [=](const CarriedSpecies& one) { return one.*member; });
    };
    const int count = static_cast<int>(species_.size());
    for (ParticleGroup& group : particles.groups()) {
        const bool is_fluid = group.kind() == PartKind::fluid;
        if (!is_fluid &&
            !any(group.kind() == PartKind::rigid ? &CarriedSpecies::with_rigid : &CarriedSpecies::with_elastic))
            continue;
        group.declare(Field::species_amount, count);
        group.declare(Field::concentration, count);
        const bool alike =
            std::ranges::all_of(species_, [](const CarriedSpecies& one) { return one.diffusivity >= 0; });
        const bool solids = any(&CarriedSpecies::with_rigid) || any(&CarriedSpecies::with_elastic);
        if (!is_fluid || solids || !alike) group.declare(Field::species_diffusivity, count);
        if (!is_fluid) group.declare(Field::species_wall, count);
        if (*scene.numerics.shifting > 0 || *scene.numerics.transport_velocity) group.declare({Field::species_change});
        if (is_implicit(scene.numerics.species_stepping))
            group.declare(
                {Field::species_change, Field::species_residual, Field::species_direction, Field::species_diagonal});
    }
}

void SpeciesTransport::fill(const Species& species, const ParticleSet& set, const std::vector<const Part*>& parts,
                            ParticleStore& particles, CarriedSpecies& carried) {
    const std::string what = "species '" + *species.name + "': concentration";
    for (ParticleGroup& group : particles.groups()) {
        if (!group.has(Field::species_amount)) continue;
        for (std::size_t i = 0; i < group.owned(); ++i) {
            const ParticleTag& tag = group.tags()[i];
            const Part& part = *parts[tag.part];
            const Value<double>* diffusivity = species.diffusivity_in(part);
            if (diffusivity == nullptr) continue;
            carried.largest_diffusivity = std::max(carried.largest_diffusivity, **diffusivity);
            largest_volume_ = std::max(largest_volume_, 1.5 * rest_volume(group, i));
            if (group.has(Field::species_diffusivity))
                group.data(Field::species_diffusivity, carried.number)[i] = **diffusivity;
            const Value<Expression>* formula = species.concentration.of(*part.name);
            if (formula == nullptr) continue;
            const double start = concentration_at(what, *formula, 0, set.position[static_cast<std::size_t>(tag.id)]);
            const double amount = start * rest_volume(group, i);
            group.data(Field::species_amount, carried.number)[i] = amount;
            carried.largest_amount = std::max(carried.largest_amount, amount);
            carried.largest_concentration = std::max(carried.largest_concentration, start);
        }
    }
}

void SpeciesTransport::fill_surfaces(const Scene& scene, const Species& species, const ParticleSet& set,
                                     ParticleStore& particles, CarriedSpecies& carried) {
    for (std::size_t number = 0; number < set.parts.size(); ++number)
        for (const bool held : {true, false}) {
            const PartKind kind = set.parts[number].kind;
            const ByPart<Expression>& surfaces = held ? species.wall_concentration : species.wall_flux;
            const Value<Expression>* formula = surfaces.of(set.parts[number].name);
            if (formula == nullptr || (kind != PartKind::rigid && kind != PartKind::elastic)) continue;
            carried.has_flux |= !held;
            carried.surfaces.push_back({static_cast<std::uint16_t>(number), kind, **formula, held});
            ParticleGroup& group = particles.of(kind);
            constexpr int times = 16;
            for (std::size_t i = 0; i < group.owned(); ++i) {
                if (group.tags()[i].part != number) continue;
                group.data(Field::species_wall, carried.number)[i] = held ? 1 : -1;
                const Vec& at = set.position[static_cast<std::size_t>(group.tags()[i].id)];
                for (int k = 0; k <= ((*formula)->depends_on_time() ? times : 0); ++k) {
                    const double t = scene.run.duration * k / times;
                    const double volume = group.data(Field::volume)[i];
                    const double amount =
                        held
                            ? concentration_at("species '" + *species.name + "': wall_concentration", *formula, t, at) *
                                  volume
                            : std::abs((**formula)(t, at[0], at[1], at[2])) * volume / set.spacing * scene.run.duration;
                    carried.largest_amount = std::max(carried.largest_amount, amount);
                    if (held) carried.largest_concentration = std::max(carried.largest_concentration, amount / volume);
                }
            }
        }
}

double SpeciesTransport::rest_volume(const ParticleGroup& group, std::size_t i) const {
    if (group.kind() != PartKind::fluid) return group.data(Field::volume)[i];
    return group.data(Field::mass)[i] / rest_density_[group.tags()[i].part];
}

double SpeciesTransport::concentration(const ParticleGroup& group, std::size_t i, std::size_t species) const {
    return group.data(Field::species_amount, static_cast<int>(species))[i] / rest_volume(group, i);
}

bool SpeciesTransport::is_surface(const ParticleGroup& group, std::size_t i, std::size_t species) const {
    return group.has(Field::species_wall) && group.data(Field::species_wall, static_cast<int>(species))[i] != 0;
}

void SpeciesTransport::start(ParticleStore& particles, double t, double dt) {
    show(particles, t);
    for (SpeciesUptake& uptake : uptake_) uptake.take(particles, dt, SpeciesUptake::When::before_supply);
}

void SpeciesTransport::show(ParticleStore& particles, double t) const {
    const ParticleSpace& space = particles.space();
    for (const CarriedSpecies& species : species_) {
        for (ParticleGroup& group : particles.groups()) {
            if (!group.has(Field::concentration)) continue;
            double* concentration = group.data(Field::concentration, species.number);
            const double* amount = group.data(Field::species_amount, species.number);
            const auto count = static_cast<std::ptrdiff_t>(group.owned());
            if (group.kind() == PartKind::fluid && one_density_) {
                const double* mass = group.data(Field::mass);
                const double density = rest_density_.front();
#pragma omp parallel for num_threads(threads_) schedule(static)
                for (std::ptrdiff_t i = 0; i < count; ++i) concentration[i] = amount[i] / (mass[i] / density);
                continue;
            }
#pragma omp parallel for num_threads(threads_) schedule(static)
            for (std::ptrdiff_t i = 0; i < count; ++i)
                concentration[i] = amount[i] / rest_volume(group, static_cast<std::size_t>(i));
        }
        for (const CarriedSpecies::Surface& surface : species.surfaces) {
            const bool by_position = surface.value.depends_on_position();
            const double everywhere = by_position ? 0 : surface.value(t);
            ParticleGroup& group = particles.of(surface.kind);
            double* concentration = group.data(Field::concentration, species.number);
            for (std::size_t i = 0; i < group.owned(); ++i) {
                if (group.tags()[i].part != surface.part) continue;
                std::array<double, 3> x{};
                for (int axis = 0; by_position && axis < group.dimension(); ++axis) {
                    const double at = group.data(Field::position, axis)[i];
                    // Wherever it was wrapped last.
                    x[axis] = space.periodic[axis] ? wrapped(at, space.box.low[axis], space.box.high[axis]) : at;
                }
                concentration[i] = by_position ? surface.value(t, x[0], x[1], x[2]) : everywhere;
            }
        }
    }
}

bool SpeciesTransport::stays(const CarriedSpecies& species, const ShiftStep& shift) {
    return species.largest_diffusivity == 0 && !species.with_rigid && shift.per_sum == 0;
}

/// Where nothing is shifted.
SpeciesSums SpeciesTransport::sums_of(const CarriedSpecies& species, double dt) {
    SpeciesSums sums;
    sums.species = sums.array_of_values = sums.array_of_result = species.number;
    sums.adds = true;
    sums.time = dt;
    sums.largest_term = species.largest_amount;
    sums.with_rigid = species.with_rigid;
    sums.with_elastic = species.with_elastic;
    sums.diffusivity = species.diffusivity;
    return sums;
}

void SpeciesTransport::add_shift(const ShiftStep& shift, SpeciesSums& sums) {
    if (shift.per_sum == 0) return;
    sums.adds = false;
    sums.result = Field::species_change;
    sums.array_of_result = 0;
    sums.shift_per_sum = shift.per_sum;
    sums.longest_shift = shift.longest;
}

std::optional<SpeciesSums> SpeciesTransport::along(const PairSweeps& sweeps, double dt, const ShiftStep& shift) const {
    if (implicit_) return {};
    for (const CarriedSpecies& species : species_) {
        if (stays(species, shift)) continue;
        SpeciesSums sums = sums_of(species, dt);
        add_shift(shift, sums);
        if (sweeps.can_fuse(sums)) return sums;
    }
    return {};
}

void SpeciesTransport::advance(ParticleStore& particles, Neighbours& neighbours, const PairSweeps& sweeps, double dt,
                               const ShiftStep& shift, const std::optional<SpeciesSums>& along) {
    if (along && shift.per_sum != 0) hand_over(species_[static_cast<std::size_t>(along->species)], particles);
    for (const CarriedSpecies& species : species_) {
        if (stays(species, shift) || (along && along->species == species.number)) continue;
        SpeciesSums sums = sums_of(species, dt);
        // What acts in the end is the flux of the solution, which keeps the amount whatever the tolerance.
        if (implicit_) solve(species, particles, neighbours, sweeps, sums);
        add_shift(shift, sums);
        sweeps.species(particles, {neighbours.list(), neighbours.within_solids()}, sums);
        if (shift.per_sum != 0) hand_over(species, particles);
    }
    for (SpeciesUptake& uptake : uptake_) uptake.take(particles, dt, SpeciesUptake::When::after_supply);
}

/// Adds to the amounts what particles have taken, less the excess.
void SpeciesTransport::hand_over(const CarriedSpecies& species, ParticleStore& particles) {
    const ReproducibleSum whole(species.largest_amount);
    ParticleGroup& fluid = particles.fluid();
    double* amount = fluid.data(Field::species_amount, species.number);
    double* change = fluid.data(Field::species_change);
    auto [excess, turnover] = sums_of_multiples<2>(fluid, threads_, [=](std::ptrdiff_t i, auto& sum) {
        // The slope of a steep front may ask for more than there is.
        change[i] = std::max(change[i], -amount[i]);
        sum[0] += change[i];
        sum[1] += std::abs(change[i]);
    });
    for (ParticleGroup& group : particles.groups()) {
        // Those that take no part hold the change of another species.
        if (!(group.kind() == PartKind::rigid     ? species.with_rigid
              : group.kind() == PartKind::elastic ? species.with_elastic
                                                  : false))
            continue;
        for (std::size_t i = 0; i < group.owned(); ++i) {
            const double taken = group.data(Field::species_change)[i];
            group.data(Field::species_amount, species.number)[i] += taken;
            excess.add(taken);
        }
    }
    ranks_.sum(excess);
    ranks_.sum(turnover);
    double& waiting = excess_[static_cast<std::size_t>(species.number)];
    excess.add(waiting);
    const double share = turnover.value() > 0 ? excess.value() / turnover.value() : 0;
    auto [given_back] = sums_of_multiples<1>(fluid, threads_, [=](std::ptrdiff_t i, auto& sum) {
        const double back = whole(std::min(share * std::abs(change[i]), amount[i] + change[i]));
        amount[i] += change[i] - back;
        sum[0] -= back;
    });
    ranks_.sum(given_back);
    excess.add(given_back);
    waiting = excess.value();
}

void SpeciesTransport::solve(const CarriedSpecies& species, ParticleStore& particles, Neighbours& neighbours,
                             const PairSweeps& sweeps, const SpeciesSums& of_step) {
    const std::function<double(const ParticleGroup&, std::size_t)> volume = [&](const auto& group, std::size_t i) {
        const SpeciesUptake& uptake = uptake_[static_cast<std::size_t>(species.number)];
        return rest_volume(group, i) / uptake.share_kept(group.tags()[i].part, of_step.time);
    };
    SpeciesSums sums = of_step;
    // Of two particles that all but touch.
    sums.largest_term = at_least_something(-sweeps.kernel_slope(0) * 2 * species.largest_diffusivity * of_step.time *
                                           largest_volume_ * largest_volume_);
    SpeciesSystem system({particles, neighbours, sweeps, ranks_, threads_, volume}, sums);
    const long most = patience(system.condition(), tolerance_);
    long iterations = 0;
    constexpr int most_cycles = 10;
    for (int cycle = 0;; ++cycle) {
        const double error = system.true_error(), scale = system.scale();
        if (error <= tolerance_ * scale) break;
        if (cycle == most_cycles || !std::isfinite(error)) give_up(species, error / scale, iterations);
        iterations += conjugate_gradients(system, 0.5 * tolerance_ * scale, most).iterations;
    }
    ++solves_.solves;
    solves_.iterations += iterations;
    solves_.most_iterations = std::max<std::int64_t>(solves_.most_iterations, iterations);
}

void SpeciesTransport::give_up(const CarriedSpecies& species, double error, long iterations) const {
    std::ostringstream problem;
    problem << "implicit diffusion of '" << *given_[static_cast<std::size_t>(species.number)].name
            << "': the concentrations' error is still " << error << " of them after " << iterations
            << " iterations, more than numerics.species_tolerance = " << tolerance_;
    throw UnsolvedSpecies(problem.str(),
                          "raise numerics.species_tolerance (rounding alone leaves about 1e-15 times the step over the "
                          "explicit limit), or lower numerics.step_factor");
}

double SpeciesTransport::taken_by_surfaces(const ParticleStore& particles, std::size_t species,
                                           std::optional<std::uint16_t> part) const {
    ExactSum sum;
    for (const ParticleGroup& group : particles.groups())
        for (std::size_t i = 0; group.has(Field::species_wall) && i < group.owned(); ++i)
            if (is_surface(group, i, species) && (!part || group.tags()[i].part == *part))
                sum.add(group.data(Field::species_amount, static_cast<int>(species))[i]);
    ranks_.sum(sum);
    return sum.value();
}

double SpeciesTransport::held_by_particles(const ParticleStore& particles, std::size_t species) const {
    ExactSum sum;
    for (const ParticleGroup& group : particles.groups())
        for (std::size_t i = 0; group.has(Field::species_amount) && i < group.owned(); ++i)
            if (!is_surface(group, i, species))
                sum.add(group.data(Field::species_amount, static_cast<int>(species))[i]);
    ranks_.sum(sum);
    return sum.value();
}

double SpeciesTransport::taken_up(std::size_t species, std::optional<std::uint16_t> part) const {
    return uptake_[species].taken(ranks_, part);
}

std::vector<SpeciesBalance> SpeciesTransport::balances(const ParticleStore& particles) const {
    std::vector<SpeciesBalance> all;
    for (std::size_t s = 0; s < species_.size(); ++s)
        all.push_back({*given_[s].name, given_[s].amount_unit(), at_start_[s], held_by_particles(particles, s),
                       -taken_by_surfaces(particles, s), taken_up(s)});
    return all;
}

void SpeciesTransport::archive(Archive& file) {
    for (const CarriedSpecies& species : species_)
        file.same("species/largest_amount_" + std::to_string(species.number), species.largest_amount,
                  "the largest amount of a species that a particle is expected to hold");
    file("species/at_start", at_start_);
    file("species/excess", excess_);
    if (at_start_.size() != species_.size() || excess_.size() != species_.size())
        throw unlike_any_run("amounts of more or fewer species than the scene has");
    for (std::size_t s = 0; s < uptake_.size(); ++s) uptake_[s].archive(file, *given_[s].name, ranks_);
    file("species/solves", solves_.solves);
    file("species/iterations", solves_.iterations);
    file("species/most_iterations", solves_.most_iterations);
}

}  // namespace dmp::solver
