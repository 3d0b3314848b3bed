// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Solids of bonds between all that is near, pulled and bent: E comes out.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <gmock/gmock.h>

#include "tests/modules.hpp"
#include "tests/unit/mesher/meshed_text.hpp"
#include "tests/unit/solver/statics.hpp"

namespace dmp::tests::solver_bonded_solids_tests {
namespace {

constexpr double modulus = 1e6, width = 0.5, spacing = 0.03125;

/// A bar of 0.5 m x 2 m across the channel, of sixteen particles in its width.
Texts bar(const std::string& arrangement, const std::string& fill, double within) {
    Texts texts{channel.scene +
                    "[[part]]\nname = \"bar\"\nkind = \"elastic\"\ndensity = \"1200 kg/m^3\"\n"
                    "youngs_modulus = \"1 MPa\"\nanchor = \"wall\"\nbonds_within = \"" +
                    std::to_string(within * spacing) + " m\"\n",
                channel.cad_geometry + R"(Point(10) = {1.75, 0, 0};
Point(11) = {2.25, 0, 0};
Point(12) = {2.25, 2, 0};
Point(13) = {1.75, 2, 0};
Line(10) = {10, 11};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 10};
Curve Loop(2) = {10, 11, 12, 13};
Plane Surface(2) = {2};
Physical Surface("bar") = {2};
)"};
    return texts.with("spacing = \"0.125 m\"",
                      "spacing = \"0.03125 m\"\narrangement = \"" + arrangement + "\"\nfill = \"" + fill + "\"");
}

/// The bar with one end clamped.
class HangingBar {
  public:
    explicit HangingBar(const Texts& texts) {
        const auto meshed = mesh_texts(texts);
        BodyParts parts = initial_body(meshed.particles, InitialSprings(meshed.particles, meshed.scene), 0, 0);
        std::vector<double> mass;
        for (auto& node : parts.nodes) {
            node.fixed = node.fixed && node.position.y() < 1;  // the channel has a wall at the other end too
            position_.push_back(node.position);
            mass.push_back(node.mass);
        }
        // Statics wants a set of the body's nodes alone.
        nodes_ = set_of_nodes(2, position_, mass);
        for (std::size_t n = 0; n < position_.size(); ++n) nodes_.fixed[n] = parts.nodes[n].fixed ? 1 : 0;
        for (const auto& bond : parts.bonds)
            nodes_.bonds.push_back({bond.node[0], bond.node[1], bond.rest, bond.stiffness});
        body_.emplace(parts, "bar", spacing, SpringContact{});
    }

    /// What its middle half shows of E when it is pulled, over the one asked for.
    [[nodiscard]] double stretched() const {
        const double load = 1e-6 * modulus * width;
        const auto moved = under([&](const Vec&, double count) { return load / count; }, 1);
        return load / (width * in_plane * polynomial(moved, 1)[1]);
    }
    /// The same when a couple bends it.
    [[nodiscard]] double bent() const {
        constexpr double middle = 2;
        double squares = 0;
        for (const Vec& at : position_)
            if (at.y() > free_end) squares += std::pow(at.x() - middle, 2);
        const double couple = 1e-7 * modulus * std::pow(width, 3);
        const auto moved = under([&](const Vec& at, double) { return couple * (at.x() - middle) / squares; }, 0);
        return couple / (std::pow(width, 3) / 12 * in_plane * 2 * std::abs(polynomial(moved, 2)[2]));
    }

  private:
    static constexpr double free_end = 2 - 1.05 * spacing, in_plane = modulus / (1 - 0.25 * 0.25);

    /// Displacements along an axis under loads along y on the free end, load(place, how many nodes there are).
    template <class Load>
    [[nodiscard]] std::vector<double> under(const Load& load, int axis) const {
        const auto count =
            static_cast<double>(std::ranges::count_if(position_, [](const Vec& at) { return at.y() > free_end; }));
        SpringNetwork<2>::Vectors force(position_.size(), Vector<double, 2>{});
        for (std::size_t n = 0; n < position_.size(); ++n)
            if (position_[n].y() > free_end) force[n][1] = load(position_[n], count);
        const auto at = statics(*body_, nodes_, force);
        std::vector<double> moved;
        for (std::size_t n = 0; n < position_.size(); ++n) moved.push_back(at[n][axis] - position_[n][axis]);
        return moved;
    }
    /// Least squares over y in the middle half.
    [[nodiscard]] Eigen::VectorXd polynomial(const std::vector<double>& moved, int degree) const {
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(degree + 1, degree + 1);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(degree + 1);
        for (std::size_t n = 0; n < position_.size(); ++n) {
            if (std::abs(position_[n].y() - 1) > 0.5) continue;
            Eigen::VectorXd powers(degree + 1);
            for (int k = 0; k <= degree; ++k) powers[k] = std::pow(position_[n].y(), k);
            normal += powers * powers.transpose();
            right += moved[n] * powers;
        }
        return normal.ldlt().solve(right);
    }

    std::vector<Vec> position_;
    ParticleSet nodes_;
    std::optional<SpringNetwork<2>> body_;
};

void expect_as_its_material(const std::string& arrangement, const std::string& fill, double within, double stretched,
                            double bent) {
    const HangingBar hung(bar(arrangement, fill, within));
    const double as_stretched = hung.stretched(), as_bent = hung.bent();
    std::printf("%s, %s, within %g: E is %.4f of the one asked for when pulled, %.4f when bent\n", arrangement.c_str(),
                fill.c_str(), within, as_stretched, as_bent);
    EXPECT_NEAR(as_stretched, 1, stretched) << arrangement << ", " << fill << ", within " << within;
    EXPECT_NEAR(as_bent, 1, bent) << arrangement << ", " << fill << ", within " << within;
}

TEST(BondedSolid, on_a_lattice_is_as_stiff_as_its_material) {
    expect_as_its_material("hexagonal", "lattice", 1.2, 0.02, 0.1);
    expect_as_its_material("hexagonal", "lattice", 2.2, 0.05, 0.1);
    expect_as_its_material("square", "lattice", 1.5, 0.02, 0.1);
}

TEST(BondedSolid, that_follows_what_is_drawn_is_nearly_as_stiff) {
    for (const char* fill : {"relaxed", "sampled"})
        for (const double within : {1.6, 2.2, 3.0}) expect_as_its_material("square", fill, within, 0.05, 0.1);
}

}  // namespace
}  // namespace dmp::tests::solver_bonded_solids_tests
