// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "models/springs/bond_force.hpp"
#include "models/springs/dihedral_force.hpp"
#include "models/springs/hinge_force.hpp"
#include "solver/elastic/local_cell.hpp"
#include "solver/elastic/spring_body.hpp"

namespace dmp::solver {

/// A spring of this law between nodes of one body.
template <int D, class Law>
struct LocalSpring {
    std::array<int, Law::nodes> node;
    Law law;
    Arms<D, Law::arms.size()> shift{};  ///< BodyParts::Spring::shift

    /// The arms between nodes at these positions.
    template <class Vectors>
    [[nodiscard]] auto arms_at(const Vectors& position) const {
        auto arms = this->arms(position);
        for (std::size_t k = 0; k < arms.size(); ++k) arms[k] += shift[k];
        return arms;
    }
    /// Differences of a value of the nodes, such as velocities, along the spring's arms.
    template <class Vectors>
    [[nodiscard]] auto arms(const Vectors& of) const {
        std::array<typename Vectors::value_type, Law::arms.size()> arms;
        for (std::size_t k = 0; k < arms.size(); ++k)
            arms[k] = of[node[Law::arms[k].end]] - of[node[Law::arms[k].start]];
        return arms;
    }
    /// Distributes slopes along the arms to the nodes.
    template <class Arms, class Visit>
    void for_each_node(const Arms& along, const Visit& visit) const {
        for (std::size_t k = 0; k < along.size(); ++k) {
            visit(node[Law::arms[k].end], 1.0, along[k]);
            visit(node[Law::arms[k].start], -1.0, along[k]);
        }
    }
};

/// Nodes, their bonds, hinges and, in 3-D, dihedrals, and cells between them: an elastic body in D dimensions. As a
/// SpringBody its particles are its nodes; where there are cells, CellBody is the body.
template <int D>
class SpringNetwork final : public SpringBody {
  public:
    using Point = Vector<double, D>;
    using Vectors = std::vector<Point>;

    SpringNetwork(const ParticleSet& set, const Part& part, int body, const SpringContact& contact = {});
    SpringNetwork(const BodyParts& parts, const std::string& name, double spacing, const SpringContact& contact);
    ~SpringNetwork() override;
    SpringNetwork(SpringNetwork&& other) noexcept;
    SpringNetwork& operator=(SpringNetwork&& other) noexcept;
    SpringNetwork(const SpringNetwork&) = delete;
    SpringNetwork& operator=(const SpringNetwork&) = delete;

    struct Impulses {
        Point of_anchors{};  ///< on the free nodes by the anchored ones [N s]
        Point of_drag{};     ///< by lab-frame drag [N s]
    };

    [[nodiscard]] BodyParts parts() const override;
    SpringImpulses advance(std::span<const Vec> force, double dt, int substeps) override;

    void start_parts() override { start_of_step_ = position_; }
    void end_parts() override { position_before_ = std::move(start_of_step_); }
    [[nodiscard]] CarriedPoint carry(const Vec& at_rest, std::span<const int> near,
                                     const ParticleSpace& space) const override;
    Vec kick(std::span<const Vec> on_unknowns, double dt) override;
    void press(std::span<const Vec> on_unknowns) override;
    [[nodiscard]] std::vector<Vec> balance(std::span<const Vec> w, double dt) const override;
    void prepare_in_fluid(std::span<const Vec> w, std::span<const Vec> drag, double dt) override;
    void prepare_alone(std::span<const Vec> w, double dt, bool anew) override;
    void multiply_in_fluid(std::span<Vec> values) const override;
    void solve_in_fluid(std::span<Vec> values) const override;
    void add_prepared(int first, std::vector<Eigen::Triplet<double>>& entries) const override;
    void expect(std::span<const Vec> w) override;

    /// Changes velocities by dt F / m, where F are the forces of the fluid and of contact on the nodes. Returns the
    /// impulse of the fixed nodes' supports [N s].
    Point kick_from_outside(std::span<const Point> force, double dt);

    /// Advances the nodes by dt under the body's own forces, in `substeps` equal drift-kick-drift steps.
    Impulses advance_subcycled(double dt, int substeps);

    /// Advances the nodes by dt in one implicit midpoint step: stable for any dt, and without the resonance between
    /// kicks by the fluid and spring modes that occurs with sub-cycling (Stern & Grinspun 2009: "IMEX").
    /// A step whose equations cannot be solved is halved repeatedly; throws DivergenceError if that fails.
    Impulses advance_implicit(double dt);

    /// Mean velocity of a node over the last advance: its displacement over dt, used in the fluid (fast vibration of
    /// the springs must not affect the fluid).
    [[nodiscard]] Point mean_velocity(std::size_t node, double dt) const {
        return (1 / dt) * (position_[node] - position_before_[node]);
    }
    /// Positions before the last advance.
    [[nodiscard]] const Vectors& positions_before() const { return position_before_; }

    [[nodiscard]] Vec position(std::size_t node) const override { return in_space(position_[node]); }
    [[nodiscard]] Vec position_before(std::size_t node) const override { return in_space(position_before_[node]); }
    [[nodiscard]] Vec rest_position(std::size_t node) const override { return in_space(position_at_rest_[node]); }

    [[nodiscard]] Vec velocity(std::size_t node) const override { return in_space(velocity_[node]); }
    [[nodiscard]] std::vector<PresentSurface> surfaces(double dt, double reach) const override;

    [[nodiscard]] Point momentum() const;  ///< of the free nodes [kg m/s]
    [[nodiscard]] Vec total_momentum() const override { return in_space(momentum()); }
    [[nodiscard]] double free_mass() const override;

    /// 2 / omega_max of the initial lattice [s], omega_max by power iteration on its stiffness.
    [[nodiscard]] double step_limit() const override;

    void archive(Archive& file, const std::string& name) override;

    [[nodiscard]] double energy() const override;
    [[nodiscard]] double self_contact_rate() const override;
    [[nodiscard]] std::vector<std::array<double, 6>> virial() const override;

    /// Whether the node does not move along this axis: it is fixed, or on a plane of symmetry.
    [[nodiscard]] bool is_held(std::size_t node, int axis) const { return fixed_[node] != 0 || on_plane_[node][axis]; }
    [[nodiscard]] const std::vector<LocalCell<D>>& cells() const { return cells_; }
    [[nodiscard]] const Vectors& positions() const { return position_; }
    [[nodiscard]] const Vectors& positions_at_rest() const { return position_at_rest_; }
    /// For tests and static solutions: nodes may be moved anywhere.
    Vectors& positions() { return position_; }
    [[nodiscard]] const Vectors& velocities() const { return velocity_; }
    /// Spring forces (including dashpots) on nodes with these positions and velocities [N].
    [[nodiscard]] Vectors forces(const Vectors& position, const Vectors& velocity) const;

  private:
    struct NoSprings {};
    using Dihedrals = std::conditional_t<D == 3, std::vector<LocalSpring<D, DihedralForce>>, NoSprings>;
    class ImplicitSystem;

    static Vec in_space(const Point& point) {
        Vec in = Vec::Zero();
        for (int axis = 0; axis < D; ++axis) in[axis] = point[axis];
        return in;
    }
    static Point of_space(const Vec& in) {
        Point point;
        for (int axis = 0; axis < D; ++axis) point[axis] = in[axis];
        return point;
    }
    /// Calls visit(spring) for each bond, hinge and dihedral.
    template <class Visit>
    void for_each_spring(const Visit& visit) const {
        for (const auto& bond : bonds_) visit(bond);
        for (const auto& hinge : hinges_) visit(hinge);
        if constexpr (D == 3)
            for (const auto& dihedral : dihedrals_) visit(dihedral);
    }
    void add_forces(const Vectors& position, const Vectors& velocity, Vectors& force) const;
    /// Its own and those that press it.
    [[nodiscard]] Vectors all_forces(const Vectors& position, const Vectors& velocity) const;
    /// v += h F / m along axes on which the node is free; the supports take it along the others [N s].
    void push(std::size_t node, double h, const Point& force, Point& of_holders);
    /// Those of the cells. Not a number where a cell is crushed or turned inside out, which no step may leave.
    void add_cell_forces(const Vectors& position, const Vectors& velocity, Vectors& force) const;
    /// Throws CrushedCell for a cell that is crushed or turned inside out, with its place.
    void refuse_crushed_cells() const;
    void drift(double h);
    void advance_in_parts(double dt, int halvings_left, Impulses& impulses);
    /// One implicit midpoint step; returns false and changes nothing if Newton's method finds no solution.
    bool solve_step(double dt, Impulses& impulses);
    Impulses advance_as_expected(double dt);
    /// v += h F / m on free nodes; adds up the impulses of anchors and drag.
    void kick(double h, const Vectors& force, const Vectors& drag_velocity, Impulses& impulses);

    std::vector<LocalSpring<D, BondForce<D>>> bonds_;
    std::vector<LocalSpring<D, HingeForce<D>>> hinges_;
    [[no_unique_address]] Dihedrals dihedrals_;
    std::vector<LocalCell<D>> cells_;
    std::vector<std::array<bool, D>> on_plane_;  ///< by node and axis: on a plane of symmetry across it
    double spacing_;                             ///< length scale of the distances between nodes [m]
    Vectors position_, velocity_, force_;        ///< positions are never wrapped: bodies may cross periodic boundaries
    Vectors position_before_;                    ///< before the last advance
    Vectors start_of_step_;                      ///< that is advanced in parts
    Vectors position_at_rest_;                   ///< initial
    std::vector<SolidSurface> surface_;          ///< at rest
    /// The first cell that was crushed in a trial of a step, since the last step.
    mutable std::optional<Point> crushed_at_;
    Vectors expected_;  ///< mean velocities of the next step, if known
    Vectors pressing_;  ///< forces from outside all through the next step, if there are any
    std::unique_ptr<ImplicitSystem> system_, in_fluid_;
    const ImplicitSystem* prepared_ = nullptr;      ///< one of the two
    double prepared_step_ = 0;                      ///< for which it was factorised [s]
    std::unique_ptr<SelfContact<D>> self_contact_;  ///< null if contact is off
};

extern template class SpringNetwork<2>;
extern template class SpringNetwork<3>;

}  // namespace dmp::solver
