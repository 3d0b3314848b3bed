// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/sph/density_diffusion.hpp"
#include "models/sph/shifting.hpp"
#include "models/sph/velocity_gradient.hpp"
#include "models/sph/walls.hpp"
#include "solver/sweeps/cluster_loop.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

/// Rounding of the sums of a gradient sweep.
struct GradientRounding {
    ReproducibleSum moment, velocity, density, shift;
};

/// The density sweep of the corrected scheme, L of a cluster's particles at a time: from one visit of each neighbour
/// the moments M, the velocity gradient G and with it the density rate (VelocityGradient), the density gradient and
/// the density's diffusion (SmoothDensityDiffusion), and the shifting vector. `Solid` is the wall model: walls take
/// part with the velocity and the pressure that it extrapolates. `Several`: fluids that differ; densities then diffuse
/// within one fluid only, and the gradients that are kept are those among one fluid and the solids.
template <class L, int D, class Kernel, class Solid, bool Several>
class GradientSweep {
  public:
    struct Options {
        double diffusion;    ///< 2 delta h c0 [m^2/s]
        double sound_speed;  ///< [m/s]
        bool shifts;         ///< the shifting vector is wanted
        bool free_surface;   ///< density rates are uncorrected; shifting vanishes where neighbours are missing
    };

    GradientSweep(ParticleStore& particles, const ClusterList& list, const Kernel& kernel, const Solid& solid,
                  const Shifting<Kernel>& shifting, const GradientRounding& rounding, const Options& options,
                  int threads)
        : particles_(particles),
          list_(list),
          kernel_(kernel),
          solid_(solid),
          shifting_(shifting),
          rounding_(rounding),
          options_(options),
          threads_(threads),
          fluid_(particles.fluid()),
          rigid_(particles.of(PartKind::rigid)),
          elastic_(particles.of(PartKind::elastic)),
          density_gradient_(axes_of<D>(particles.fluid(), Field::density_gradient)),
          fluid_number_(Several ? particles.fluid().data(Field::fluid_number) : nullptr) {}

    void run(ClusterChoice choice) {
        for_each_cluster<L::width>(list_, PartKind::fluid, choice, threads_,
                                   [&](const Neighbourhood& near) { finish(sums_around(near), near.cluster); });
    }

  private:
    using Vec = Vector<L, D>;
    using Rows = Vector<Vec, D>;
    using Matrix = Symmetric<L, D>;

    struct Moments {
        Matrix moment{Vec::zero(), Vector<L, Matrix::off_diagonals>::zero()};  ///< M
        Rows velocity = Rows::zero();                                          ///< - A
    };
    struct Sum {
        Moments all, of_one_fluid;   ///< the second only of `Several`
        Rows excess = Rows::zero();  ///< - A of the density rate, less that of the velocity gradient
        Vec density = Vec::zero();   ///< SUM_j V_j (1/r dW/dr) (rho_i - rho_j) x_ij, that is - M g
        L diffusion = 0.0;
        Vec shift = Vec::zero();
    };

    // Flattened: inlines every law into the loop, regardless of size.
    [[nodiscard, gnu::flatten]] Sum sums_around(const Neighbourhood& near) const {
        const auto i = fluid_(near.cluster);
        const Vec own_gradient = load_vector<L, D>(density_gradient_, near.cluster);
        const L own_number = Several ? load<L>(fluid_number_, near.cluster) : L(0.0);
        Sum sum;
        for (const std::int32_t index : near.of(PartKind::fluid)) {
            const auto j = fluid_(index);
            const Vec separation = i.position - j.position, past = i.velocity - j.velocity;
            const L distance = sqrt(dot(separation, separation));
            L weight = j.volume * kernel_.slope(distance);
            add_moments(weight, separation, past, sum.all);
            add_shift(weight, distance, separation, sum.shift);
            if constexpr (Several) {
                weight = equal(own_number, fluid_number_[index]) * weight;
                add_moments(weight, separation, past, sum.of_one_fluid);
            }
            const L difference = i.density - j.density;
            sum.density += rounding_.density((weight * difference) * separation);
            sum.diffusion += rounding_.density(SmoothDensityDiffusion::law(
                weight, difference, own_gradient + load_vector<L, D>(density_gradient_, index), separation));
        }
        for (const std::int32_t index : near.of(PartKind::rigid)) {
            const auto wall = rigid_(index);
            add_solid(i, solid_.rigid(i, wall, i.position - wall.position), Solid::approached(i, wall).velocity, sum);
        }
        for (const std::int32_t index : near.of(PartKind::elastic)) {
            const auto body = elastic_(index);
            add_solid(i, elastic_image(i, body), body.velocity, sum);
        }
        return sum;
    }

    // The weight of a neighbour is V_j (1/r) dW/dr. Passed one by one: a struct of lanes goes through memory.
    void add_moments(const L& weight, const Vec& separation, const Vec& past, Moments& sum) const {
        const Matrix term = GradientCorrection::term(weight, separation);
        sum.moment.diagonal += rounding_.moment(term.diagonal);
        sum.moment.off += rounding_.moment(term.off);
        for (int row = 0; row < D; ++row) sum.velocity[row] += rounding_.velocity((weight * past[row]) * separation);
    }

    /// `approached`: the solid's velocity in the density rate, where it counts twice (VelocityGradient).
    template <class I, class Image, class Velocity>
    void add_solid(const I& i, const Image& image, const Velocity& approached, Sum& sum) const {
        const Vec separation = i.position - image.position, past = i.velocity - image.velocity;
        const L distance = sqrt(dot(separation, separation));
        const L weight = image.volume * kernel_.slope(distance);
        add_moments(weight, separation, past, sum.all);
        if constexpr (Several) add_moments(weight, separation, past, sum.of_one_fluid);
        const Vec beyond = Solid::approach_weight * (i.velocity - approached) - past;
        for (int row = 0; row < D; ++row) sum.excess[row] += rounding_.velocity((weight * beyond[row]) * separation);
        const L difference = (i.pressure - image.pressure) * (1 / (options_.sound_speed * options_.sound_speed));
        sum.density += rounding_.density((weight * difference) * separation);
        add_shift(weight, distance, separation, sum.shift);
    }

    /// An elastic particle moves as itself; the pressure continues to it as to a wall.
    template <class I, class Body>
    [[nodiscard]] auto elastic_image(const I& i, const Body& body) const {
        auto image = solid_.springs(i, body, i.position - body.position);
        image.pressure = image.pressure - i.density * dot(solid_.acceleration, i.position - body.position);
        return image;
    }

    void add_shift(const L& weight, const L& distance, const Vec& separation, Vec& sum) const {
        if (options_.shifts) sum += rounding_.shift((weight * shifting_.factor(distance, kernel_)) * separation);
    }

    static L equal(const L& a, double b) {
        const L difference = a - b;
        return where_less(difference * difference, L(0.25), L(1.0), L(0.0));
    }

    void finish(const Sum& sum, const Cluster& cluster) const {
        ParticleGroup& group = particles_.fluid();
        const Matrix inverse = GradientCorrection::inverse(sum.all.moment, VelocityGradient::smallest_determinant);
        const Rows gradient = gradient_of(sum.all, inverse);
        // At a free surface only the force's exact partner, B = 1, is stable.
        const L divergence =
            options_.free_surface
                ? -1.0 * (VelocityGradient::divergence(sum.all.velocity) + VelocityGradient::divergence(sum.excess))
                : VelocityGradient::divergence(gradient) -
                      VelocityGradient::divergence(VelocityGradient::corrected(sum.excess, inverse));
        const L rate = options_.diffusion * sum.diffusion - load<L>(group.data(Field::density), cluster) * divergence;
        store_scalar(rate, Field::density_rate, cluster);
        store_scalar(VelocityGradient::mean(inverse), Field::mean_correction, cluster);
        if constexpr (Several) {
            const Matrix of_one = GradientCorrection::inverse(sum.of_one_fluid.moment,
                                                              VelocityGradient::smallest_determinant_of_one_fluid);
            store_gradients(gradient_of(sum.of_one_fluid, of_one), of_one * sum.density, cluster);
        } else {
            store_gradients(gradient, inverse * sum.density, cluster);
        }
        if (!options_.shifts) return;
        L trace = sum.all.moment.diagonal[0];
        for (int axis = 1; axis < D; ++axis) trace = trace + sum.all.moment.diagonal[axis];
        const L kept = options_.free_surface ? Shifting<Kernel>::template kept<D>(trace) : L(1.0);
        solver::store<L, D>(kept * sum.shift, group, Field::shift, cluster);
    }

    static Rows gradient_of(const Moments& sum, const Matrix& inverse) {
        Rows a;
        for (int row = 0; row < D; ++row) a[row] = -1.0 * sum.velocity[row];
        return VelocityGradient::corrected(a, inverse);
    }

    void store_gradients(const Rows& of_velocity, const Vec& less_of_density, const Cluster& cluster) const {
        ParticleGroup& group = particles_.fluid();
        for (int k = 0; k < D * D; ++k)
            of_velocity[k / D][k % D].store(group.data(Field::velocity_gradient, k) + cluster.first,
                                            static_cast<std::size_t>(cluster.count));
        solver::store<L, D>(-1.0 * less_of_density, group, Field::next_density_gradient, cluster);
    }
    void store_scalar(const L& value, Field field, const Cluster& cluster) const {
        value.store(particles_.fluid().data(field) + cluster.first, static_cast<std::size_t>(cluster.count));
    }

    ParticleStore& particles_;
    const ClusterList& list_;
    const Kernel& kernel_;
    const Solid& solid_;
    const Shifting<Kernel>& shifting_;
    const GradientRounding& rounding_;
    Options options_;
    int threads_;
    FluidReader<L, D> fluid_;
    SolidReader<L, D, Solid::needs_state, Solid::needs_surface, Solid::needs_motion> rigid_;
    SolidReader<L, D, Solid::needs_state, false> elastic_;
    std::array<const double*, D> density_gradient_;
    const double* fluid_number_;
};

}  // namespace dmp::solver
