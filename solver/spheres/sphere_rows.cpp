// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_rows.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::solver {

namespace {

/// Of a fixed sphere: the effective mass is then that of the other one to the last bit.
const double no_limit = std::ldexp(1.0, 60);

}  // namespace

void SphereRows::take(const ParticleGroup& group, const std::vector<bool>& fixed_by_id) {
    owned_ = group.owned();
    motion_.resize(group.total() + 2);
    loads_.resize(group.total() + 2);
    flight_.end(owned_);
    const double *mass = group.data(Field::mass), *radius = group.data(Field::radius);
    for (int axis = 0; axis < 3; ++axis) {
        const double *x = group.data(Field::position, axis), *v = group.data(Field::velocity, axis),
                     *spin = group.data(Field::angular_velocity, axis), *force = group.data(Field::contact_force, axis),
                     *torque = group.data(Field::contact_torque, axis);
        for (std::size_t i = 0; i < group.total(); ++i) {
            motion_[i].position.c[axis] = x[i];
            motion_[i].velocity.c[axis] = v[i];
            motion_[i].spin.c[axis] = spin[i];
            loads_[i].force.c[axis] = force[i];
            loads_[i].torque.c[axis] = torque[i];
        }
    }
    double largest = 1e-300;
    for (std::size_t i = 0; i < group.total(); ++i) {
        const bool fixed = fixed_by_id[static_cast<std::size_t>(group.tags()[i].id)];
        motion_[i].position.c[3] = radius[i];
        motion_[i].velocity.c[3] = fixed ? no_limit * mass[i] : mass[i];
        motion_[i].spin.c[3] = fixed ? 0 : 1 / mass[i];
        largest = std::max(largest, radius[i]);
    }
    for (std::size_t k = 0; k < 2; ++k) {
        SphereMotion& nobody = motion_[group.total() + k];
        nobody = {};
        nobody.position.c[0] = k == 0 ? 0 : 1000 * largest;
        nobody.position.c[3] = largest;
        nobody.velocity.c[3] = 1;
        loads_[group.total() + k] = {};
    }
}

void SphereRows::give(ParticleGroup& group) {
    land();
    for (int axis = 0; axis < 3; ++axis) {
        double *x = group.data(Field::position, axis), *v = group.data(Field::velocity, axis),
               *spin = group.data(Field::angular_velocity, axis), *force = group.data(Field::contact_force, axis),
               *torque = group.data(Field::contact_torque, axis);
        for (std::size_t i = 0; i < owned_; ++i) {
            x[i] = motion_[i].position.c[axis];
            v[i] = motion_[i].velocity.c[axis];
            spin[i] = motion_[i].spin.c[axis];
            force[i] = loads_[i].force.c[axis];
            torque[i] = loads_[i].torque.c[axis];
        }
    }
}

}  // namespace dmp::solver
