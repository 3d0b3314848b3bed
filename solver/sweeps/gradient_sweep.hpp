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
    ReproducibleSum moment, velocity, density, diffusion, shift;
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
          velocity_gradient_(axes_of<D * D>(particles.fluid(), Field::velocity_gradient)),
          fluid_number_(Several ? particles.fluid().data(Field::fluid_number) : nullptr) {}

    void run(ClusterChoice choice) {
        for_each_cluster<L::width>(list_, PartKind::fluid, choice, threads_,
                                   [&](const Neighbourhood& near) { finish(sums_around(near), near.cluster); });
    }

  private:
    using Vec = Vector<L, D>;
    using Rows = Vector<Vec, D>;
    using Matrix = Symmetric<L, D>;

    // A factor that may be a number of few digits, such as a separation on a lattice, is multiplied by `full` (see
    // ReproducibleSum::add).
    static constexpr double full = ReproducibleSum::full_mantissa, per_square = 1 / (full * full);

    struct Moments {
        Matrix moment;  ///< M
        Rows velocity;  ///< A
    };
    /// While they run, sums are of V_j (1/r dW/dr), and those that are defined with a minus have the other sign.
    struct Sum {
        Moments all, of_one_fluid;  ///< the second only of `Several`
        Rows excess;                ///< A of the density rate, less that of the velocity gradient
        Vec density;                ///< - SUM_j V_j (1/r dW/dr) (rho_i - rho_j) x_ij, that is M g
        L diffusion;                ///< of the density
        Vec shift;                  ///< the shifting vector
        Vec off_walls;              ///< - SUM_j V_j (1/r dW/dr) x_ij over the walls
    };
    void start(Moments& sum) const {
        rounding_.moment.start(sum.moment.diagonal);
        rounding_.moment.start(sum.moment.off);
        rounding_.velocity.start(sum.velocity);
    }
    [[nodiscard]] Sum start() const {
        Sum sum;
        start(sum.all);
        start(sum.of_one_fluid);
        rounding_.velocity.start(sum.excess);
        rounding_.density.start(sum.density);
        rounding_.diffusion.start(sum.diffusion);
        rounding_.shift.start(sum.shift);
        rounding_.shift.start(sum.off_walls);
        return sum;
    }
    [[nodiscard]] Moments total(const Moments& sum) const {
        return {{-per_square * rounding_.moment.total(sum.moment.diagonal),
                 -per_square * rounding_.moment.total(sum.moment.off)},
                rows(rounding_.velocity.total(sum.velocity))};
    }
    [[nodiscard]] Sum total(const Sum& sum) const {
        return {total(sum.all),
                total(sum.of_one_fluid),
                rows(rounding_.velocity.total(sum.excess)),
                (-1 / full) * rounding_.density.total(sum.density),
                rounding_.diffusion.total(sum.diffusion),
                per_square * rounding_.shift.total(sum.shift),
                -per_square * rounding_.shift.total(sum.off_walls)};
    }
    static Rows rows(Rows sum) {
        for (int row = 0; row < D; ++row) sum[row] = -per_square * sum[row];
        return sum;
    }

    // Flattened: inlines every law into the loop, regardless of size.
    [[nodiscard, gnu::flatten]] Sum sums_around(const Neighbourhood& near) const {
        auto i = fluid_(near.cluster);
        for (int k = 0; k < D * D; ++k) i.gradient[k / D][k % D] = load<L>(velocity_gradient_[k], near.cluster);
        // With a free surface the density rate is that of the pressure force alone.
        const Rows turning = options_.free_surface ? Rows::zero() : i.gradient;
        const Vec own_gradient = load_vector<L, D>(density_gradient_, near.cluster);
        const L own_number = Several ? load<L>(fluid_number_, near.cluster) : L(0.0);
        Sum sum = start();
        for (const std::int32_t index : near.of(PartKind::fluid)) {
            const auto j = fluid_(index);
            const Vec separation = i.position - j.position, past = i.velocity - j.velocity;
            const L distance = sqrt(dot(separation, separation));
            L weight = j.volume * kernel_.slope(distance);
            Vec weighted = weight * (full * separation);
            add_moments(weighted, separation, past, sum.all);
            add_shift(distance, weighted, sum.shift);
            if constexpr (Several) {
                const L same = equal(own_number, fluid_number_[index]);
                weight = same * weight;
                weighted = same * weighted;
                add_moments(weighted, separation, past, sum.of_one_fluid);
            }
            const L difference = i.density - j.density;
            ReproducibleSum::add(sum.density, difference, weighted);
            const Vec gradients = own_gradient + load_vector<L, D>(density_gradient_, index);
            ReproducibleSum::add(sum.diffusion, weight, SmoothDensityDiffusion::law(difference, gradients, separation));
        }
        for (const std::int32_t index : near.of(PartKind::rigid)) {
            const auto wall = rigid_(index);
            const Vec separation = i.position - wall.position;
            add_solid<true>(i, solid_.rigid(i, wall, separation), past_wall(i, wall, separation), sum);
        }
        for (const std::int32_t index : near.of(PartKind::elastic)) {
            const auto body = elastic_(index);
            const Vec separation = i.position - body.position, past = i.velocity - body.velocity;
            add_solid<false>(i, elastic_image(i, body, separation),
                             VelocityGradient::past_solid(past, turning, separation), sum);
        }
        return total(sum);
    }

    /// `weighted`: `full` times the separation times V_j (1/r) dW/dr.
    static void add_moments(const Vec& weighted, const Vec& separation, const Vec& past, Moments& sum) {
        const Vec x = full * separation;
        for (int a = 0; a < D; ++a) ReproducibleSum::add(sum.moment.diagonal[a], weighted[a], x[a]);
        for (int k = 0; k < Matrix::off_diagonals; ++k)
            ReproducibleSum::add(sum.moment.off[k], weighted[k], x[(k + 1) % D]);
        for (int row = 0; row < D; ++row) ReproducibleSum::add(sum.velocity[row], full * past[row], weighted);
    }

    /// `past_in_rate`: v_ij of the density rate.
    template <bool IsWall, class I, class Image>
    void add_solid(const I& i, const Image& image, const Vec& past_in_rate, Sum& sum) const {
        const Vec separation = i.position - image.position;
        const Vec past = i.velocity - (image.velocity + image.velocity_by_gradient);
        const L distance = sqrt(dot(separation, separation));
        const Vec weighted = (image.volume * kernel_.slope(distance)) * (full * separation);
        add_moments(weighted, separation, past, sum.all);
        if constexpr (Several) add_moments(weighted, separation, past, sum.of_one_fluid);
        const Vec beyond = past_in_rate - past;
        for (int row = 0; row < D; ++row) ReproducibleSum::add(sum.excess[row], full * beyond[row], weighted);
        const L difference = (i.pressure - image.pressure) * (1 / (options_.sound_speed * options_.sound_speed));
        ReproducibleSum::add(sum.density, L(difference), weighted);
        add_shift(distance, weighted, sum.shift);
        if constexpr (IsWall) ReproducibleSum::add(sum.off_walls, L(full), weighted);
    }

    /// v_ij of the density rate for a wall.
    template <class I, class Wall>
    [[nodiscard]] Vec past_wall(const I& i, const Wall& wall, const Vec& separation) const {
        if (options_.free_surface) return 2.0 * (i.velocity - Solid::approached(i, wall).velocity);
        const Vec past = i.velocity - wall.motion;
        const Vec at_rest = VelocityGradient::past_solid(past, i.gradient, separation);
        if constexpr (!Solid::needs_motion) return at_rest;
        const Vec slides =
            VelocityGradient::past_sliding_wall(past, i.gradient, separation, wall.normal, wall.slip) - at_rest;
        return at_rest + wall.sliding * slides;
    }

    /// The pressure continues to an elastic particle as to a wall, whether its body is held or not.
    template <class I, class Body>
    [[nodiscard]] auto elastic_image(const I& i, const Body& body, const Vec& separation) const {
        auto image = solid_.springs(i, body, separation);
        image.pressure = i.pressure - i.density * dot(solid_.acceleration, separation);
        return image;
    }

    void add_shift(const L& distance, const Vec& weighted, Vec& sum) const {
        if (options_.shifts) ReproducibleSum::add(sum, shifting_.factor(distance, kernel_, full), weighted);
    }

    static L equal(const L& a, double b) {
        const L difference = a - b;
        return where_less(difference * difference, L(0.25), L(1.0), L(0.0));
    }

    void finish(const Sum& sum, const Cluster& cluster) const {
        ParticleGroup& group = particles_.fluid();
        const Matrix inverse = GradientCorrection::inverse(sum.all.moment, VelocityGradient::smallest_determinant);
        // At a free surface only the force's exact partner, B = 1, is stable.
        const L divergence =
            options_.free_surface
                ? VelocityGradient::divergence(sum.all.velocity) + VelocityGradient::divergence(sum.excess)
                : VelocityGradient::divergence(VelocityGradient::corrected(sum.all.velocity, inverse)) +
                      VelocityGradient::divergence(VelocityGradient::corrected(sum.excess, inverse));
        // Fused by name, see gradient_correction.hpp.
        const L rate = multiply_add(L(options_.diffusion), sum.diffusion,
                                    -1.0 * (load<L>(group.data(Field::density), cluster) * divergence));
        store_scalar(rate, Field::density_rate, cluster);
        store_scalar(VelocityGradient::mean(inverse), Field::mean_correction, cluster);
        const Moments& kept = Several ? sum.of_one_fluid : sum.all;
        const Matrix of_kept = GradientCorrection::inverse(kept.moment, VelocityGradient::smallest_determinant_of_kept);
        store_gradients(VelocityGradient::corrected(kept.velocity, of_kept), of_kept * sum.density, cluster);
        if (!options_.shifts) return;
        L trace = sum.all.moment.diagonal[0];
        for (int axis = 1; axis < D; ++axis) trace = trace + sum.all.moment.diagonal[axis];
        const L share = options_.free_surface ? Shifting<Kernel>::template kept<D>(trace) : L(1.0);
        solver::store<L, D>(share * sum.shift, group, Field::shift, cluster);
        solver::store<L, D>(shifting_.normal_of_walls(sum.off_walls), group, Field::off_walls, cluster);
    }

    void store_gradients(const Rows& of_velocity, const Vec& of_density, const Cluster& cluster) const {
        ParticleGroup& group = particles_.fluid();
        for (int k = 0; k < D * D; ++k)
            of_velocity[k / D][k % D].store(group.data(Field::velocity_gradient, k) + cluster.first,
                                            static_cast<std::size_t>(cluster.count));
        solver::store<L, D>(of_density, group, Field::next_density_gradient, cluster);
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
    BodyReader<L, D, Solid::needs_state, Solid::needs_surface> elastic_;
    std::array<const double*, D> density_gradient_;
    std::array<const double*, D * D> velocity_gradient_;
    const double* fluid_number_;
};

}  // namespace dmp::solver
