// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/bond_network.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dmp {

namespace {

/// Lengths are told apart to a part in so many of their range: shells of a lattice all are.
constexpr int bins = 256;
constexpr double even_enough = 0.02;
constexpr double largest_exponent = 8;

/// SUM r^2 n n n n of some bonds: all 81 components, of which a few are unlike.
class FourthMoment {
  public:
    void add(const Vec& apart) {
        const Vec n = apart.normalized();
        const double square = apart.squaredNorm();
        std::size_t at = 0;
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
                for (int c = 0; c < 3; ++c)
                    for (int d = 0; d < 3; ++d) component_[at++] += square * n[a] * n[b] * n[c] * n[d];
        trace_ += square;
    }
    void add(const FourthMoment& other, double times) {
        for (std::size_t at = 0; at < component_.size(); ++at) component_[at] += times * other.component_[at];
        trace_ += times * other.trace_;
    }
    /// The square of what is left of it without its isotropic part, a multiple of dd + dd + dd, over its own.
    [[nodiscard]] double anisotropy(int dimension) const {
        double square = 0;
        for (const double each : component_) square += each * each;
        const double isotropic = 3 * trace_ * trace_ / (dimension * (dimension + 2.0));
        return square > 0 ? std::sqrt(std::max(0.0, 1 - isotropic / square)) : 0;
    }
    /// SUM r^2.
    [[nodiscard]] double trace() const { return trace_; }

  private:
    std::array<double, 81> component_{};
    double trace_ = 0;
};

/// The moments of bonds of about one length, by length over the shortest.
class MomentsByLength {
  public:
    MomentsByLength(const std::vector<Bond>& bonds, const std::vector<Vec>& place) {
        const auto [shortest, longest] = std::ranges::minmax(bonds, {}, &Bond::rest_length);
        shortest_ = shortest.rest_length;
        const double width = std::max(longest.rest_length - shortest_, 1e-9 * shortest_) / bins;
        for (const Bond& bond : bonds) {
            const auto bin =
                std::min<std::size_t>(bins - 1, static_cast<std::size_t>((bond.rest_length - shortest_) / width));
            moment_[bin].add(place[static_cast<std::size_t>(bond.a)] - place[static_cast<std::size_t>(bond.b)]);
            length_[bin] += bond.rest_length / shortest_;
            ++count_[bin];
        }
    }
    [[nodiscard]] double shortest() const { return shortest_; }

    /// Of all bonds, with stiffness that falls with this power of their length.
    [[nodiscard]] double anisotropy(double exponent, int dimension) const {
        FourthMoment all;
        for (std::size_t bin = 0; bin < bins; ++bin)
            if (count_[bin] > 0)
                all.add(moment_[bin], std::pow(length_[bin] / static_cast<double>(count_[bin]), -exponent));
        return all.anisotropy(dimension);
    }

  private:
    double shortest_ = 0;
    std::array<FourthMoment, bins> moment_;
    std::array<double, bins> length_{};
    std::array<std::size_t, bins> count_{};
};

/// The exponent that leaves the least anisotropy: the best of some, then by halving around it.
double best_exponent(const MomentsByLength& moments, int dimension) {
    const auto at = [&](double exponent) { return moments.anisotropy(exponent, dimension); };
    if (at(0) <= even_enough) return 0;
    double step = 0.5, best = 0, least = at(0);
    const auto look = [&](double exponent) {
        if (std::abs(exponent) > largest_exponent) return;
        if (const double here = at(exponent); here < least) {
            least = here;
            best = exponent;
        }
    };
    for (double exponent = -largest_exponent; exponent <= largest_exponent; exponent += step) look(exponent);
    for (int halving = 0; halving < 40; ++halving) {
        step /= 2;
        const double middle = best;
        look(middle - step);
        look(middle + step);
    }
    return best;
}

}  // namespace

NetworkConstants set_stiffness(std::vector<Bond>& bonds, const std::vector<Vec>& place, double youngs_modulus,
                               double volume, int dimension) {
    NetworkConstants constants;
    if (bonds.empty()) return constants;
    const MomentsByLength moments(bonds, place);
    constants.youngs_modulus = youngs_modulus;
    constants.exponent = best_exponent(moments, dimension);
    constants.anisotropy = moments.anisotropy(constants.exponent, dimension);
    double sum = 0;
    for (Bond& bond : bonds) {
        bond.stiffness = std::pow(bond.rest_length / moments.shortest(), -constants.exponent);
        sum += bond.stiffness * bond.rest_length * bond.rest_length;
    }
    const double unit = 0.2 * dimension * (dimension + 2) * youngs_modulus * volume / sum;
    constants.softest = std::numeric_limits<double>::infinity();
    for (Bond& bond : bonds) {
        bond.stiffness *= unit;
        constants.softest = std::min(constants.softest, bond.stiffness);
        constants.stiffest = std::max(constants.stiffest, bond.stiffness);
    }
    return constants;
}

}  // namespace dmp
