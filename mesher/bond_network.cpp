// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/bond_network.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace dmp::mesher {

namespace {

/// No bond is made weaker than this by its direction, over what it would be without.
constexpr double least_factor = 0.1;

/// The fourth powers n_a n_b n_c n_d of a direction, those that are unlike, each times the root of how often it is
/// among the 81: products of such vectors are those of the whole tensors.
using FourthPowers = Eigen::Matrix<double, 15, 1>;

/// Calls visit(k, i, j, l, root of how often) for x^i y^j z^l, k its number.
template <class Visit>
void for_each_power(const Visit& visit) {
    constexpr std::array<double, 5> factorial{1, 1, 2, 6, 24};
    int k = 0;
    for (int i = 4; i >= 0; --i)
        for (int j = 4 - i; j >= 0; --j) {
            const int l = 4 - i - j;
            visit(k++, i, j, l, std::sqrt(24 / (factorial.at(i) * factorial.at(j) * factorial.at(l))));
        }
}

FourthPowers fourth_powers(const Vec& n) {
    FourthPowers powers;
    for_each_power([&](int k, int i, int j, int l, double root) {
        powers[k] = root * std::pow(n.x(), i) * std::pow(n.y(), j) * std::pow(n.z(), l);
    });
    return powers;
}

/// The mean of a direction's fourth powers over all directions.
FourthPowers even_directions(int dimension) {
    FourthPowers powers = FourthPowers::Zero();
    for_each_power([&](int k, int i, int j, int l, double root) {
        const bool in_plane = dimension == 3 || l == 0;
        const bool vanishes = !in_plane || i % 2 + j % 2 + l % 2 > 0;
        const double of_one = std::max({i, j, l}) == 4 ? 3 : 1;  // <x^4> is three times <x^2 y^2>
        powers[k] = vanishes ? 0 : root * of_one / (dimension * (dimension + 2));
    });
    return powers;
}

}  // namespace

NetworkConstants set_stiffness(std::vector<Bond>& bonds, const std::vector<Vec>& position, double youngs_modulus,
                               double volume, int dimension) {
    NetworkConstants constants;
    if (bonds.empty()) return constants;
    constants.youngs_modulus = youngs_modulus;
    const auto powers_of = [&](const Bond& bond) {
        return fourth_powers(
            (position[static_cast<std::size_t>(bond.a)] - position[static_cast<std::size_t>(bond.b)]).normalized());
    };
    Eigen::Matrix<double, 15, 15> products = Eigen::Matrix<double, 15, 15>::Zero();
    FourthPowers moment = FourthPowers::Zero();
    double squares = 0;
    for (const Bond& bond : bonds) {
        const double square = bond.rest_length * bond.rest_length;
        const FourthPowers powers = powers_of(bond);
        products += square * powers * powers.transpose();
        moment += square * powers;
        squares += square;
    }
    const FourthPowers even = even_directions(dimension);
    Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, 15, 15>> solver;
    solver.setThreshold(1e-9);  // directions that no bond has
    const FourthPowers weight = solver.compute(products).solve(squares * even - moment);
    double least = 1;
    for (Bond& bond : bonds) {
        bond.stiffness = 1 + weight.dot(powers_of(bond));
        least = std::min(least, bond.stiffness);
    }
    const double kept = least < least_factor ? (1 - least_factor) / (1 - least) : 1;
    moment.setZero();
    squares = 0;
    for (Bond& bond : bonds) {
        bond.stiffness = 1 + kept * (bond.stiffness - 1);
        const double term = bond.stiffness * bond.rest_length * bond.rest_length;
        moment += term * powers_of(bond);
        squares += term;
    }
    constants.anisotropy = (moment - squares * even).norm() / moment.norm();
    const double unit = 0.2 * dimension * (dimension + 2) * youngs_modulus * volume / squares;
    constants.softest = std::numeric_limits<double>::infinity();
    for (Bond& bond : bonds) {
        bond.stiffness *= unit;
        constants.softest = std::min(constants.softest, bond.stiffness);
        constants.stiffest = std::max(constants.stiffest, bond.stiffness);
    }
    return constants;
}

}  // namespace dmp::mesher
