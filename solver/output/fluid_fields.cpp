// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/fluid_fields.hpp"

#include <cmath>

#include "particles/periodic_images.hpp"

namespace dmp::solver {

namespace {

Eigen::Matrix3d rate_of_strain(const Eigen::Matrix3d& gradient) { return 0.5 * (gradient + gradient.transpose()); }

}  // namespace

bool is_shown_mirrored(const ParticleGroup& particles, const ParticleSpace& space, int axis, std::size_t i) {
    if (particles.kind() != PartKind::fluid || axis >= space.dimension || !space.is_mirrored(axis)) return false;
    const double x = particles.data(Field::position, axis)[i];
    return space.mirrored_back(x, axis) != x;
}

Vec shown_place(const ParticleGroup& particles, const ParticleSpace& space, std::size_t i) {
    Vec place = Vec::Zero();
    for (int axis = 0; axis < space.dimension; ++axis) {
        double x = particles.data(Field::position, axis)[i];
        if (space.periodic[axis]) x = wrapped(x, space.box.low[axis], space.box.high[axis]);
        place[axis] = is_shown_mirrored(particles, space, axis, i) ? space.mirrored_back(x, axis) : x;
    }
    return place;
}

double von_mises(const std::array<double, 6>& s) {
    const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
    return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

template <class ValuesOf>
FluidValues FluidFields::each(const char* name, const char* unit, int components, const ValuesOf& values_of) {
    FluidValues out{name, unit, components, {}};
    const std::size_t count = particles_.fluid().owned();
    out.values.reserve(count * static_cast<std::size_t>(components));
    for (std::size_t i = 0; i < count; ++i)
        for (const double value : values_of(i)) out.values.push_back(value);
    return out;
}

FluidValues FluidFields::stored(Field field) const {
    const ParticleGroup& fluid = particles_.fluid();
    const FieldInfo& about = info(field);
    FluidValues out{std::string(about.name), std::string(about.unit), about.shape == FieldShape::vector ? 3 : 1, {}};
    for (std::size_t i = 0; i < fluid.owned(); ++i)
        for (int axis = 0; axis < out.components; ++axis) {
            const double value = axis == 0 || axis < fluid.dimension() ? fluid.data(field, axis)[i] : 0.0;
            const bool turned =
                about.shape == FieldShape::vector && is_shown_mirrored(fluid, particles_.space(), axis, i);
            out.values.push_back(turned ? -value : value);
        }
    return out;
}

std::vector<FluidValues> FluidFields::residence_times() const {
    const ParticleGroup& fluid = particles_.fluid();
    std::vector<FluidValues> times;
    for (std::size_t r = 0; r < scene_.regions.size(); ++r) {
        const double* values = fluid.data(Field::residence_time, static_cast<int>(r));
        const std::string which = scene_.regions.size() > 1 ? "_" + scene_.regions[r].name.value : "";
        times.push_back({"residence_time" + which, "s", 1, {values, values + fluid.owned()}});
    }
    return times;
}

std::vector<FluidValues> FluidFields::concentrations() const {
    const ParticleGroup& fluid = particles_.fluid();
    std::vector<FluidValues> all;
    for (std::size_t s = 0; s < scene_.species.size(); ++s) {
        const std::string which = scene_.species.size() > 1 ? "_" + *scene_.species[s].name : "";
        all.push_back({"concentration" + which, scene_.species[s].concentration_unit(), 1, {}});
        for (std::size_t i = 0; i < fluid.owned(); ++i)
            all.back().values.push_back(step_.species()->concentration(fluid, i, s));
    }
    return all;
}

const std::vector<Eigen::Matrix3d>& FluidFields::gradient() {
    if (gradient_) return *gradient_;
    gradient_ = velocity_gradient(particles_, step_);
    for (int axis = 0; axis < particles_.dimension(); ++axis)
        for (std::size_t i = 0; i < gradient_->size(); ++i)
            if (is_shown_mirrored(particles_.fluid(), particles_.space(), axis, i)) {
                (*gradient_)[i].row(axis) *= -1;
                (*gradient_)[i].col(axis) *= -1;
            }
    return *gradient_;
}

std::array<double, 6> FluidFields::stress(std::size_t i) {
    const Eigen::Matrix3d rate = rate_of_strain(gradient()[i]);
    const double pressure = particles_.fluid().data(Field::pressure)[i];
    const double twice_viscosity = 2 * particles_.fluid().data(Field::viscosity)[i];
    return {twice_viscosity * rate(0, 0) - pressure,
            twice_viscosity * rate(1, 1) - pressure,
            twice_viscosity * rate(2, 2) - pressure,
            twice_viscosity * rate(0, 1),
            twice_viscosity * rate(1, 2),
            twice_viscosity * rate(0, 2)};
}

bool FluidFields::need_neighbours(FluidField field) {
    return field == FluidField::shear_stress || field == FluidField::stress || field == FluidField::von_mises ||
           field == FluidField::vorticity;
}

std::vector<FluidValues> FluidFields::of(FluidField field) {
    if (need_neighbours(field)) (void)gradient();  // by all ranks, also those without fluid
    switch (field) {
        case FluidField::velocity:
            return {stored(Field::velocity)};
        case FluidField::pressure:
            return {stored(Field::pressure)};
        case FluidField::density:
            return {stored(Field::density)};
        case FluidField::shear_stress:
            return {each("shear_stress", "Pa", 1, [&](std::size_t i) {
                const double viscosity = particles_.fluid().data(Field::viscosity)[i];
                return std::array{viscosity * std::sqrt(2 * rate_of_strain(gradient()[i]).squaredNorm())};
            })};
        case FluidField::stress:
            return {each("stress", "Pa", 6, [&](std::size_t i) { return stress(i); })};
        case FluidField::von_mises:
            return {
                each("von_mises", "Pa", 1, [&](std::size_t i) { return std::array{solver::von_mises(stress(i))}; })};
        case FluidField::vorticity: {
            const auto curl = [&](std::size_t i) {
                const Eigen::Matrix3d& g = gradient()[i];
                return std::array{g(2, 1) - g(1, 2), g(0, 2) - g(2, 0), g(1, 0) - g(0, 1)};
            };
            if (particles_.dimension() == 3) return {each("vorticity", "1/s", 3, curl)};
            return {each("vorticity", "1/s", 1, [&](std::size_t i) { return std::array{curl(i)[2]}; })};
        }
        case FluidField::concentration:
            return concentrations();
        case FluidField::residence_time:
            break;
    }
    return residence_times();
}

}  // namespace dmp::solver
