// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "base/simd/lanes.hpp"
#include "models/dem/contact_law.hpp"
#include "solver/spheres/columns.hpp"
#include "solver/spheres/contact_job.hpp"

namespace dmp::solver {

/// The loop over contacts: L contacts side by side, each once. Velocities are those of the middle of the step that led
/// to the present places; so the directions in which two surfaces slide on each other are taken at the middle too
/// (Vyas, Ottino, Lueptow & Umbanhowar 2025: else a small sphere drifts on a large one), but where the history is
/// LAMMPS'.
template <class L, ContactModel model>
class ContactKernel {
    using Law = ContactLaw<model>;
    static constexpr std::size_t kept = Law::history_values;
    /// Vectors of contacts whose loads are handed out together: laws are chains of roots and quotients, and a processor
    /// looks the farther ahead into the next one, the less lies between them.
    static constexpr std::size_t together = 4;

  public:
    /// One function all through: values stay in registers from law to law.
    [[gnu::flatten]] static void run(ContactJob& job) {
        L largest(0.0);
        std::array<Loads, together> loads;
        for (std::size_t k = job.first; k < job.end; k += together * L::width) {
            const std::size_t count = std::min(together, (job.end - k) / L::width);
            for (std::size_t n = 0; n < count; ++n) {
                fetch_ahead(job, k + n * L::width);
                loads[n] = contacts_at(job, k + n * L::width, largest);
            }
            for (std::size_t n = 0; n < count; ++n) hand_out(job, k + n * L::width, loads[n]);
        }
        for (std::size_t lane = 0; lane < L::width; ++lane)
            if (largest[lane] > job.largest_force) job.largest_force = largest[lane];
    }

  private:
    using V = Vector<L, 3>;
    using Cols = Columns<L>;
    struct Loads {
        typename Cols::Four force, torque_i, torque_j;
    };

    /// The rows of some blocks ahead, on their way from memory while this block is worked on.
    static void fetch_ahead(const ContactJob& job, std::size_t k) {
        constexpr std::size_t ahead = 3 * contact_block;
        if (k + ahead + L::width > job.end) return;
        for (std::size_t lane = 0; lane < L::width; ++lane)
            for (const std::int32_t row : {job.low[k + ahead + lane], job.high[k + ahead + lane]}) {
                const auto* motion = reinterpret_cast<const char*>(job.motion + row);
                __builtin_prefetch(motion);
                __builtin_prefetch(motion + 64);
                __builtin_prefetch(job.loads + row, 1);
            }
    }

    static V three(const typename Cols::Four& four) { return {{four[0], four[1], four[2]}}; }
    static typename Cols::Four four(const V& v) { return {v[0], v[1], v[2], L(0.0)}; }
    static V across(const V& v, const V& n) { return v - dot(v, n) * n; }

    static Loads contacts_at(ContactJob& job, std::size_t k, L& largest) {
        const double* rows = job.motion->position.c;
        const std::int32_t *low = job.low + k, *high = job.high + k;
        const auto position_i = Cols::load(rows, motion_width, low), position_j = Cols::load(rows, motion_width, high);
        const auto moving_i = Cols::load(rows + 4, motion_width, low),
                   moving_j = Cols::load(rows + 4, motion_width, high);
        const auto spin_i = Cols::load(rows + 8, motion_width, low), spin_j = Cols::load(rows + 8, motion_width, high);
        const V separation = three(position_i) - three(position_j);
        const L distance = sqrt(dot(separation, separation));
        const SpherePoint<L> i{three(moving_i), three(spin_i), position_i[3], moving_i[3]},
            j{three(moving_j), three(spin_j), position_j[3], moving_j[3]};
        auto contact = contact_of_spheres<Law>(i, j, separation, distance);
        const Levers<L> arm{Law::lever(i.radius, contact.radius, contact.overlap),
                            Law::lever(j.radius, contact.radius, contact.overlap)};
        if constexpr (Law::Tangential::centred) {
            const V relative = i.velocity - j.velocity, around = arm.i * i.spin + arm.j * j.spin;
            const V before = separation - L(job.time.half_dt) * relative;
            const V n = (L(1.0) / sqrt(dot(before, before))) * before;
            contact.slip = across(across(relative, n) - cross(around, n), contact.normal);
        }
        typename Law::template History<L> history;
        for (std::size_t n = 0; n < kept; ++n) history[n] = L::load(job.history[n] + k);
        const ContactForce<L> force = Law::law(contact, job.constants, history, job.time.dt);
        for (std::size_t n = 0; n < kept; ++n) history[n].store(job.history[n] + k, L::width);
        largest = max(largest, max(force.normal, -force.normal));
        const V twist = force.torque(L(1.0), contact.normal);
        return {four(job.force_rounding(force.on_i(contact.normal))),
                four(job.torque_rounding(arm.i * twist + force.rolling)),
                four(job.torque_rounding(arm.j * twist - force.rolling))};
    }

    static void hand_out(ContactJob& job, std::size_t k, const Loads& loads) {
        using Quad = typename Cols::Quad;
        std::array<Quad, L::width> force, torque_i, torque_j;
        Cols::for_each_row(loads.force, [&](std::size_t lane, Quad row) { force[lane] = row; });
        Cols::for_each_row(loads.torque_i, [&](std::size_t lane, Quad row) { torque_i[lane] = row; });
        Cols::for_each_row(loads.torque_j, [&](std::size_t lane, Quad row) { torque_j[lane] = row; });
        for (std::size_t lane = 0; lane < L::width; ++lane) {
            add(job, job.low[k + lane], force[lane], torque_i[lane]);
            add(job, job.high[k + lane], -force[lane], torque_j[lane]);
        }
    }

    static void add(ContactJob& job, std::int32_t row, typename Cols::Quad force, typename Cols::Quad torque) {
        if (row >= job.first_row && row < job.end_row) [[likely]] {
            double* load = job.loads[row].force.c;
            Cols::write(load, Cols::read(load) + force);
            Cols::write(load + 4, Cols::read(load + 4) + torque);
            return;
        }
        DeferredLoad& later = job.deferred[job.deferred_count++];
        later.row = row;
        Cols::write(later.load.force.c, force);
        Cols::write(later.load.torque.c, torque);
    }
};

}  // namespace dmp::solver
