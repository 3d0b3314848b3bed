// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/half_list.hpp"

#include <cmath>
#include <vector>

#include "bench/start.hpp"
#include "bench/uses.hpp"
#include "models/sph/kernels.hpp"
#include "particles/cell_grid.hpp"
#include "particles/periodic_images.hpp"

namespace dmp::bench {

namespace {

constexpr double skin_of_support = 0.1;

template <int D, class Kernel>
class HalfListLoop final : public HalfList {
  public:
    HalfListLoop(const ParticleSet& set, double support)
        : kernel_(support), support_square_(square(support)), sorted_position_(set.size()) {
        const double reach = (1 + skin_of_support) * support;
        sort_particles(set, reach);
        add_ghosts(set, reach);
        build_list(set, reach);
    }

    void sweep() override {
        update_particles();
        for (std::size_t i = 0; i < density_.size(); ++i) {
            const Point& a = points_[i];
            Sum sum = sums_[i];
            for (int k = first_[i]; k < first_[i + 1]; ++k) {
                const int j = neighbours_[k];
                add_pair(a, points_[j], [&](double volume_rate, const std::array<double, D>& force) {
                    Sum& other = sums_[j];
                    for (int axis = 0; axis < D; ++axis) {
                        sum.force[axis] += force[axis];
                        other.force[axis] -= force[axis];
                    }
                    sum.rate += points_[j].mass * volume_rate;
                    other.rate += a.mass * volume_rate;
                });
            }
            for (int k = first_ghost_[i]; k < first_ghost_[i + 1]; ++k) {
                const Point& b = points_[near_ghosts_[k]];
                add_pair(a, b, [&](double volume_rate, const std::array<double, D>& force) {
                    for (int axis = 0; axis < D; ++axis) sum.force[axis] += force[axis];
                    sum.rate += b.mass * volume_rate;
                });
            }
            sums_[i] = sum;
        }
    }

    [[nodiscard]] std::size_t particles() const override { return density_.size(); }
    [[nodiscard]] std::size_t pairs_listed() const override { return neighbours_.size() + near_ghosts_.size() / 2; }
    [[nodiscard]] std::size_t pairs_within_support() const override {
        // Lattice neighbours exactly at the support are out, whichever way their distance is rounded.
        const double inside = support_square_ * (1 - 1e-9);
        std::size_t pairs = 0, to_ghosts = 0;
        for (std::size_t i = 0; i < density_.size(); ++i) {
            for (int k = first_[i]; k < first_[i + 1]; ++k)
                pairs += distance_square(points_[i], points_[neighbours_[k]]) < inside ? 1 : 0;
            for (int k = first_ghost_[i]; k < first_ghost_[i + 1]; ++k)
                to_ghosts += distance_square(points_[i], points_[near_ghosts_[k]]) < inside ? 1 : 0;
        }
        return pairs + to_ghosts / 2;
    }

    [[nodiscard]] std::array<double, 3> force(std::size_t i) const override {
        std::array<double, 3> force{};
        for (int axis = 0; axis < D; ++axis) force[axis] = sums_[sorted_position_[i]].force[axis];
        return force;
    }
    [[nodiscard]] double density_rate(std::size_t i) const override { return sums_[sorted_position_[i]].rate; }

  private:
    /// What a pair needs of a particle; in 2-D one line of the cache.
    struct Point {
        double position[D], velocity[D];
        double mass, viscosity;
        double inverse_density;  ///< 1 / rho
        double pressure_term;    ///< p / rho^2
    };
    struct Sum {
        double force[D];
        double rate;
    };

    static double distance_square(const Point& a, const Point& b) {
        double sum = 0;
        for (int axis = 0; axis < D; ++axis) sum += square(a.position[axis] - b.position[axis]);
        return sum;
    }

    /// Calls add(v_ij . grad W, force on a) when the two are near enough.
    template <class Add>
    void add_pair(const Point& a, const Point& b, const Add& add) const {
        double apart[D], distance = 0;
        for (int axis = 0; axis < D; ++axis) {
            apart[axis] = a.position[axis] - b.position[axis];
            distance += square(apart[axis]);
        }
        if (distance >= support_square_) return;
        const double slope = kernel_.slope(std::sqrt(distance));
        const double masses = a.mass * b.mass * slope;
        const double pressure = masses * (a.pressure_term + b.pressure_term);
        const double viscous = masses * (a.viscosity + b.viscosity) * (a.inverse_density * b.inverse_density);
        std::array<double, D> force;
        double approach = 0;
        for (int axis = 0; axis < D; ++axis) {
            const double velocity = a.velocity[axis] - b.velocity[axis];
            approach += velocity * apart[axis];
            force[axis] = viscous * velocity - pressure * apart[axis];
        }
        add(slope * approach, force);
    }

    void update_particles() {
        constexpr double stiffness = Liquid::sound_speed * Liquid::sound_speed * Liquid::density / 7;
        for (std::size_t i = 0; i < density_.size(); ++i) {
            const double ratio = density_[i] / Liquid::density;
            const double cube = ratio * ratio * ratio;
            points_[i].inverse_density = 1 / density_[i];
            points_[i].pressure_term = stiffness * (cube * cube * ratio - 1) * square(points_[i].inverse_density);
            sums_[i] = {};
        }
        for (std::size_t k = 0; k < ghosts_.size(); ++k) {
            Point& copy = points_[density_.size() + k];
            copy = points_[ghosts_[k].source];
            for (int axis = 0; axis < D; ++axis) copy.position[axis] += ghosts_[k].shift[axis];
        }
    }

    [[nodiscard]] Coordinates coordinates() const {
        Coordinates all;
        for (int axis = 0; axis < D; ++axis)
            for (const Point& point : points_) all[axis].push_back(point.position[axis]);
        return all;
    }

    void sort_particles(const ParticleSet& set, double cell) {
        Coordinates positions;
        for (int axis = 0; axis < D; ++axis)
            for (std::size_t i = 0; i < set.size(); ++i) {
                const double x = set.position[i][axis];
                positions[axis].push_back(set.periodic[axis] ? wrapped(x, set.box.low[axis], set.box.high[axis]) : x);
            }
        const CellGrid grid(positions, set.size(), D, cell);
        for (const int i : grid.order()) {
            const SweepState state = sweep_state(set, i);
            Point point{};
            for (int axis = 0; axis < D; ++axis) {
                point.position[axis] = positions[axis][i];
                point.velocity[axis] = state.velocity[axis];
            }
            point.mass = set.mass[i];
            point.viscosity = Liquid::viscosity;
            sorted_position_[i] = points_.size();
            points_.push_back(point);
            density_.push_back(state.density);
            fixed_.push_back(set.fixed[i]);
        }
        sums_.resize(set.size());
    }

    void add_ghosts(const ParticleSet& set, double reach) {
        ghosts_ = periodic_images(coordinates(), points_.size(), set.box, set.periodic, reach);
        for (const PeriodicImage& copy : ghosts_) fixed_.push_back(fixed_[copy.source]);
        points_.resize(points_.size() + ghosts_.size());
        update_particles();
    }

    void build_list(const ParticleSet& set, double reach) {
        const auto own = static_cast<int>(set.size());
        const CellGrid grid(coordinates(), points_.size(), D, reach);
        for (int i = 0; i < own; ++i) {
            first_.push_back(static_cast<int>(neighbours_.size()));
            first_ghost_.push_back(static_cast<int>(near_ghosts_.size()));
            std::array<double, 3> position{};
            for (int axis = 0; axis < D; ++axis) position[axis] = points_[i].position[axis];
            grid.for_each_near(position, reach, [&](int j) {
                if (j <= i || (fixed_[i] && fixed_[j])) return;
                if (distance_square(points_[i], points_[j]) < square(reach))
                    (j < own ? neighbours_ : near_ghosts_).push_back(j);
            });
        }
        first_.push_back(static_cast<int>(neighbours_.size()));
        first_ghost_.push_back(static_cast<int>(near_ghosts_.size()));
    }

    Kernel kernel_;
    double support_square_;
    std::vector<Point> points_;  ///< in the order of cells, copies behind them
    std::vector<Sum> sums_;
    std::vector<double> density_;
    std::vector<std::uint8_t> fixed_;
    std::vector<PeriodicImage> ghosts_;
    std::vector<int> first_, neighbours_;         ///< of particle i those behind it: [first_[i], first_[i + 1])
    std::vector<int> first_ghost_, near_ghosts_;  ///< copies near it
    std::vector<std::size_t> sorted_position_;    ///< by index in the set
};

}  // namespace

SweepState sweep_state(const ParticleSet& set, std::size_t i) {
    constexpr std::uint64_t velocity_seed = 2, density_seed = 3;
    constexpr double velocity_noise = 0.1, density_noise = 1e-3;
    SweepState state;
    state.density = Liquid::density * (1 + density_noise * noise(density_seed, i, 0));
    if (set.fixed[i] != 0) return state;
    for (int axis = 0; axis < set.dimension; ++axis)
        state.velocity[axis] = Liquid::speed * ((axis == 0 ? 1 : 0) + velocity_noise * noise(velocity_seed, i, axis));
    return state;
}

std::unique_ptr<HalfList> make_half_list(const ParticleSet& set, KernelKind kernel, double support) {
    if (set.dimension == 2) {
        if (kernel == KernelKind::lucy) return std::make_unique<HalfListLoop<2, Lucy<2>>>(set, support);
        return std::make_unique<HalfListLoop<2, WendlandC2<2>>>(set, support);
    }
    if (kernel == KernelKind::lucy) return std::make_unique<HalfListLoop<3, Lucy<3>>>(set, support);
    return std::make_unique<HalfListLoop<3, WendlandC2<3>>>(set, support);
}

}  // namespace dmp::bench
