// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "models/dem/contact_constants.hpp"
#include "models/dem/contact_law.hpp"
#include "solver/parallel/resources.hpp"
#include "solver/spheres/sphere_rows.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

/// What the longest law remembers of a contact: two vectors and a radius.
inline constexpr std::size_t most_history = 7;
/// Contacts are worked on so many at a time at most; lists are padded to it.
inline constexpr std::size_t contact_block = 8;

/// A load that one thread has for a sphere that is another one's.
struct DeferredLoad {
    SphereLoad load;
    std::int32_t row = 0;
};

/// How time enters into contact forces.
struct ContactTime {
    double dt = 0;       ///< the step that has led here [s]
    double half_dt = 0;  ///< how long ago velocities were these [s]
};

/// One run of contacts of one pair of materials, of one thread. Contacts fill blocks; nobody's rows fill the last one.
struct ContactJob {
    const SphereMotion* motion = nullptr;
    SphereLoad* loads = nullptr;
    const std::int32_t* low = nullptr;   ///< rows, of the sphere with the lower id: "i" of the law
    const std::int32_t* high = nullptr;  ///< "j"
    std::size_t first = 0, end = 0;      ///< contacts, in whole blocks
    std::array<double*, most_history> history{};
    ContactConstants<double> constants;
    ContactTime time;
    ReproducibleSum force_rounding{1}, torque_rounding{1};
    std::int32_t first_row = 0, end_row = 0;  ///< the thread's own spheres; loads on others are deferred
    DeferredLoad* deferred = nullptr;
    std::size_t deferred_count = 0;  ///< grows
    double largest_force = 0;        ///< grows: along the normal [N]
};

using ContactSweep = void (*)(ContactJob&);

/// The loop over contacts with this law as compiled for one vector unit; only to be called on a processor that has it.
template <VectorUnit unit>
ContactSweep compiled_contact_sweep(const ContactModel& model);

/// The same for the unit chosen at run time.
ContactSweep contact_sweep(const ContactModel& model, VectorUnit unit);

/// How many numbers the law remembers.
int history_values(const ContactModel& model);
/// Energy that a contact with this overlap and effective radius [m] stores, `history` being what the law remembers [J].
double contact_energy(const ContactModel& model, const ContactConstants<double>& pair, double overlap, double radius,
                      std::span<const double> history);
/// Largest gap across which a force acts between bodies of this effective radius [m]; 0: only where they touch.
double contact_reach(const ContactModel& model, const ContactConstants<double>& pair, double radius);

}  // namespace dmp::solver
