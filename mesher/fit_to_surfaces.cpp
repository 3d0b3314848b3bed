// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/fit_to_surfaces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesher/close_pairs.hpp"
#include "mesher/uses.hpp"
#include "models/sph/kernels.hpp"

namespace dmp::mesher {

namespace {

/// Displacement per unit of R^2 SUM V grad W; half of what makes the descent oscillate on a lattice.
constexpr double descent = 0.1;
/// No particle goes further in the first iteration [spacings]; by how much less in each that follows, so that what
/// would hop between two places comes to rest.
constexpr double longest_move = 0.1, slowing = 0.985;
/// At first, and later, particles nearer than this to a surface belong to the layer at it [spacings].
constexpr double first_layer = 1.0, later_layer = 0.75;
/// Moves go on while the fluid's kernel sums are spread by more than this, as a share of their mean.
constexpr double even_enough = 0.01;
/// Particles that would be nearer than this in the layer do not both belong to it [spacings].
constexpr double on_top = 0.55;
/// A surface is asked for anew after a move of so much; where there was none within two spacings [spacings].
constexpr double stale = 0.1, stale_far_away = 0.5;
/// The pairs are listed this much further than the support [spacings].
constexpr double skin = 0.4;

/// Where particles may stand at the surfaces, by the planes that touch these.
class Holds {
  public:
    Holds(const ParticleSet& set, const std::vector<std::uint8_t>& held, const HoldOf& hold_of)
        : spacing_(set.spacing),
          held_(held),
          hold_of_(hold_of),
          holds_(set.size()),
          asked_at_(set.size(), Vec::Constant(HUGE_VAL)),
          in_layer_(set.size(), 0) {}

    /// Asks for the surfaces anew where particles moved.
    template <int D>
    void renew(const ParticleSet& set, const ClosePairs& pairs, int threads) {
        const bool is_first = renewals_++ == 0;
        const double layer = (is_first ? first_layer : later_layer) * spacing_;
        const auto count = static_cast<std::ptrdiff_t>(set.size());
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1024)
        for (std::ptrdiff_t k = 0; k < count; ++k) {
            const auto i = static_cast<std::size_t>(k);
            const double fresh = (holds_[i] ? stale : stale_far_away) * spacing_;
            if (held_[i] != 0 || (set.position[i] - asked_at_[i]).squaredNorm() < fresh * fresh) continue;
            holds_[i] = hold_of_(i, set.position[i]);
            asked_at_[i] = set.position[i];
            if (holds_[i] && distance(i, set.position[i]) < layer) in_layer_[i] = 1;
        }
        if (is_first && D == 2) thin_out<D>(set, pairs, threads);
    }

    /// Where particle i may go from a place when it is to move: in the layer at a surface along that, and towards half
    /// a spacing from it, no further than `longest` [m]. What pushes it across the surface never holds that up.
    [[nodiscard]] Vec allowed(std::size_t i, const Vec& position, const Vec& move, double longest) const {
        if (!holds_[i]) return position + move;
        const Vec& normal = holds_[i]->to_particle;
        const double short_of = spacing_ / 2 - distance(i, position), along_normal = move.dot(normal);
        if (in_layer_[i] == 0 && along_normal > short_of) return position + move;
        return position + move + (std::clamp(short_of, -longest, longest) - along_normal) * normal;
    }

    /// Of the surface as it is asked for now.
    void measure(const ParticleSet& set, Fit& fit) const {
        double squares = 0;
        for (std::size_t i = 0; i < set.size(); ++i) {
            if (in_layer_[i] == 0) continue;
            const auto hold = hold_of_(i, set.position[i]);
            if (!hold) continue;
            const double error = std::abs((set.position[i] - hold->point).norm() / spacing_ - 0.5);
            squares += error * error;
            fit.largest_surface_error = std::max(fit.largest_surface_error, error);
            ++fit.at_surface;
        }
        fit.surface_error = fit.at_surface == 0 ? 0 : std::sqrt(squares / static_cast<double>(fit.at_surface));
    }

  private:
    [[nodiscard]] double distance(std::size_t i, const Vec& position) const {
        return (position - holds_[i]->point).dot(holds_[i]->to_particle);
    }

    /// From where particle i is to where it would be in the layer.
    [[nodiscard]] Vec to_layer(std::size_t i, const Vec& position) const {
        return (spacing_ / 2 - distance(i, position)) * holds_[i]->to_particle;
    }

    /// Lets go of what would stand on top of another in the layer: of two rows of a lattice that are both within a
    /// spacing of a curve, the one behind. In 3-D a layer has room to spread, and to let go would leave holes.
    template <int D>
    void thin_out(const ParticleSet& set, const ClosePairs& pairs, int threads) {
        std::vector<std::uint8_t> stays = in_layer_;
        const auto count = static_cast<std::ptrdiff_t>(set.size());
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1024)
        for (std::ptrdiff_t k = 0; k < count; ++k) {
            const auto i = static_cast<std::size_t>(k);
            if (in_layer_[i] == 0) continue;
            const double own = distance(i, set.position[i]);
            const Vec move = to_layer(i, set.position[i]);
            pairs.for_each_near<D>(i, [&](std::size_t j, const std::array<double, D>& separation, double) {
                if (in_layer_[j] == 0 || holds_[i]->to_particle.dot(holds_[j]->to_particle) < 0) return;
                const double other = distance(j, set.position[j]);
                if (other > own || (other == own && j >= i)) return;
                Vec apart = move - to_layer(j, set.position[j]);
                for (std::size_t axis = 0; axis < D; ++axis) apart[static_cast<Eigen::Index>(axis)] += separation[axis];
                if (apart.norm() < on_top * spacing_) stays[i] = 0;
            });
        }
        in_layer_.swap(stays);
    }

    double spacing_;
    const std::vector<std::uint8_t>& held_;
    const HoldOf& hold_of_;
    std::vector<std::optional<SurfaceHold>> holds_;
    std::vector<Vec> asked_at_;
    std::vector<std::uint8_t> in_layer_;  ///< held at half a spacing
    int renewals_ = 0;
};

struct Evening {
    Vec move;           ///< - descent R^2 SUM V grad W, the largest parts of it for what stands too near
    double kernel_sum;  ///< SUM V W, itself too
};

template <int D>
Evening evening_of(const ParticleSet& set, const ClosePairs& pairs, const WendlandC2<D>& kernel, double support,
                   std::size_t i) {
    const double inverse_at_spacing = 1 / kernel.value(set.spacing);
    std::array<double, 3> sum{};
    double kernel_sum = set.volume[i] * kernel.value(0.0);
    pairs.for_each_near<D>(i, [&](std::size_t j, const std::array<double, D>& separation, double square_of_distance) {
        const double r = std::sqrt(square_of_distance);
        const double value = kernel.value(r);
        const double crowding = 1 + 0.2 * square(square(value * inverse_at_spacing));
        kernel_sum += set.volume[j] * value;
        const double weight = crowding * set.volume[j] * kernel.slope(r);
        for (std::size_t axis = 0; axis < D; ++axis) sum[axis] += weight * separation[axis];
    });
    return {-descent * support * support * Vec(sum[0], sum[1], sum[2]), kernel_sum};
}

/// Standard deviation of the fluid's kernel sums over their mean.
double fluid_spread(const ParticleSet& set, const std::vector<double>& kernel_sum) {
    double count = 0, sum = 0, squares = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::fluid) continue;
        ++count;
        sum += kernel_sum[i];
        squares += square(kernel_sum[i]);
    }
    return count == 0 ? 0 : std::sqrt(std::max(0.0, squares * count / square(sum) - 1));
}

/// Into the period, and back over planes of symmetry.
void wrap(ParticleSet& set) {
    for (Vec& position : set.position)
        for (int axis = 0; axis < set.dimension; ++axis) {
            double& x = position[axis];
            x = set.periodic[axis] ? wrapped(x, set.box.low[axis], set.box.high[axis]) : set.mirrored_back(x, axis);
        }
}

template <int D>
Fit fit(ParticleSet& set, double support, const std::vector<std::uint8_t>& held, const HoldOf& hold_of, int threads,
        double settled, int most_iterations) {
    const WendlandC2<D> kernel(support);
    Holds holds(set, held, hold_of);
    Fit fit;
    std::size_t free = 0;
    for (const std::uint8_t flag : held) free += flag == 0 ? 1 : 0;
    if (free == 0) return fit;
    ClosePairs pairs;
    double gone = HUGE_VAL;  // by the fastest since the pairs were listed
    std::vector<Vec> moved(set.size());
    std::vector<double> kernel_sum(set.size(), 1);
    const auto count = static_cast<std::ptrdiff_t>(set.size());
    double longest = longest_move * set.spacing;
    for (; fit.iterations < most_iterations; ++fit.iterations, longest *= slowing) {
        if (2 * gone > skin * set.spacing) {
            wrap(set);
            pairs.find(set, held, support + skin * set.spacing, threads);
            holds.renew<D>(set, pairs, threads);
            gone = 0;
        }
        double farthest = 0, squares = 0;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1024) reduction(max : farthest)
        for (std::ptrdiff_t k = 0; k < count; ++k) {
            const auto i = static_cast<std::size_t>(k);
            moved[i] = set.position[i];
            if (held[i] != 0) continue;
            auto [move, sum] = evening_of<D>(set, pairs, kernel, support, i);
            kernel_sum[i] = sum;
            const double length = move.norm();
            if (length > longest) move *= longest / length;
            moved[i] = holds.allowed(i, set.position[i], move, longest_move * set.spacing);
            farthest = std::max(farthest, (moved[i] - set.position[i]).norm());
        }
        for (std::size_t i = 0; i < set.size(); ++i) squares += (moved[i] - set.position[i]).squaredNorm();
        set.position.swap(moved);
        pairs.follow(set);
        gone += farthest;
        fit.last_move = std::sqrt(squares / static_cast<double>(free)) / set.spacing;
        fit.spread = fluid_spread(set, kernel_sum);
        if (fit.last_move < settled && fit.spread < even_enough) break;
    }
    wrap(set);
    holds.measure(set, fit);
    return fit;
}

}  // namespace

Fit fit_to_surfaces(ParticleSet& set, double support, const std::vector<std::uint8_t>& held, const HoldOf& hold_of,
                    int threads, double settled, int most_iterations) {
    return set.dimension == 3 ? fit<3>(set, support, held, hold_of, threads, settled, most_iterations)
                              : fit<2>(set, support, held, hold_of, threads, settled, most_iterations);
}

}  // namespace dmp::mesher
