// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/elastic/spring_network.hpp"

namespace dmp::solver {

/// An elastic body of cells (ElasticCell). Its particles are the centroids of the cells, what moves are the nodes on
/// their corners, with the shape functions N_k of the centroid between them:
///   x_p = SUM N_k x_k + SUM d_k (x_k - X_k),   v_p = SUM N_k v_k + SUM d_k v_k,   f_k = SUM N_k f_p + d_k SUM f_p
/// so that force, moment, momentum and power are the same on both sides. d_k M is what a node has more of the body's
/// mass M than SUM N_k m_p, so that its moment of inertia is right (corner_masses). SUM d_k = 0 and SUM d_k X_k = 0: a
/// body that moves as a whole has no offset, and a force that is as the mass does not strain it. d_k = 0 where nodes
/// are clamped, and of what has torn off.
template <int D>
class CellBody final : public SpringBody {
  public:
    using Network = SpringNetwork<D>;
    using Point = typename Network::Point;
    using Vectors = typename Network::Vectors;

    CellBody(const BodyParts& parts, const std::string& name, double spacing, const SpringContact& contact);

    [[nodiscard]] bool consists_of_cells() const override { return true; }
    [[nodiscard]] BodyParts parts() const override;
    SpringImpulses advance(std::span<const Vec> force, double dt, int substeps) override;

    void start_parts() override { network_.start_parts(); }
    void end_parts() override {
        network_.end_parts();
        find_offsets();
    }

    [[nodiscard]] std::size_t unknowns() const override { return network_.nodes(); }
    [[nodiscard]] double unknown_mass(std::size_t unknown) const override { return network_.mass(unknown); }
    [[nodiscard]] std::vector<Vec> of_particles(std::span<const Vec> of_unknowns) const override;
    [[nodiscard]] std::vector<Vec> on_unknowns(std::span<const Vec> on_particles) const override;
    [[nodiscard]] std::vector<Vec> unknown_velocities(std::span<const Vec> of_particles) const override;
    [[nodiscard]] Vec unknown_position(std::size_t unknown) const override { return network_.position(unknown); }
    [[nodiscard]] Vec unknown_velocity(std::size_t unknown) const override { return network_.velocity(unknown); }
    [[nodiscard]] bool unknown_fixed(std::size_t unknown) const override { return network_.fixed(unknown); }
    [[nodiscard]] CarriedPoint carry(const Vec& at_rest, std::span<const int> near,
                                     const ParticleSpace& space) const override;
    Vec kick(std::span<const Vec> on_unknowns, double dt) override {
        const Vec impulse = network_.kick(on_unknowns, dt);
        find_offsets();
        return impulse;
    }
    void press(std::span<const Vec> on_unknowns) override { network_.press(on_unknowns); }
    [[nodiscard]] std::vector<Vec> balance(std::span<const Vec> w, double dt) const override {
        return network_.balance(w, dt);
    }
    void prepare_in_fluid(std::span<const Vec> w, std::span<const Vec> drag, double dt) override {
        network_.prepare_in_fluid(w, drag, dt);
    }
    void prepare_alone(std::span<const Vec> w, double dt, bool anew) override { network_.prepare_alone(w, dt, anew); }
    void multiply_in_fluid(std::span<Vec> values) const override { network_.multiply_in_fluid(values); }
    void solve_in_fluid(std::span<Vec> values) const override { network_.solve_in_fluid(values); }
    void add_prepared(int first, std::vector<Eigen::Triplet<double>>& entries) const override {
        network_.add_prepared(first, entries);
    }
    void expect(std::span<const Vec> w) override { network_.expect(w); }

    [[nodiscard]] Vec position(std::size_t node) const override;
    [[nodiscard]] Vec position_before(std::size_t node) const override;
    [[nodiscard]] Vec rest_position(std::size_t node) const override;

    [[nodiscard]] Vec velocity(std::size_t node) const override;
    [[nodiscard]] std::vector<PresentSurface> surfaces(double dt, double reach) const override;
    [[nodiscard]] bool is_clamped() const override { return network_.is_clamped(); }
    [[nodiscard]] double free_mass() const override { return network_.free_mass(); }
    [[nodiscard]] Vec total_momentum() const override { return network_.total_momentum(); }
    [[nodiscard]] double energy() const override { return network_.energy(); }
    /// Shorter than that of the network where cells are damped: 2/omega (sqrt(1 + zeta^2) - zeta).
    [[nodiscard]] double step_limit() const override;
    [[nodiscard]] double self_contact_rate() const override;
    /// -V F S F^T of each cell: minus Kirchhoff's stress times its volume at rest.
    [[nodiscard]] std::vector<std::array<double, 6>> virial() const override;
    [[nodiscard]] std::vector<std::array<double, 6>> surface_stresses(std::size_t node) const override;
    [[nodiscard]] double volume_ratio(std::size_t node) const override;
    [[nodiscard]] std::optional<std::array<double, 2>> strains(std::size_t node) const override;
    [[nodiscard]] std::optional<std::array<int, 2>> overloaded_face(const SolidBreak& law, int origin) const override;
    void archive(Archive& file, const std::string& name) override;

    [[nodiscard]] const Network& network() const { return network_; }
    Network& network() { return network_; }  ///< for tests and static solutions

  private:
    /// Shares of the particles' values, added up at the nodes.
    [[nodiscard]] std::vector<Vec> at_nodes(std::span<const Vec> of_particles) const;
    [[nodiscard]] const LocalCell<D>& cell(std::size_t particle) const { return network_.cells()[particle]; }
    [[nodiscard]] Vectors at_centroids(const Vectors& of_nodes) const;
    void find_heavier_nodes();
    /// SUM d_k times the values of the nodes, along axes in which none is held.
    [[nodiscard]] Vec of_heavier_nodes(const Vectors& values) const;
    void find_offsets();

    Network network_;
    std::vector<BodyParts::Cell> cells_;  ///< as they were made
    std::vector<BodyParts::Face> faces_;
    std::unique_ptr<SelfContact<D>> self_contact_;
    std::vector<double> heavier_;                             ///< d_k by node [-]; empty: 0
    std::array<bool, 3> is_open_{true, true, true};           ///< by axis: no node is held along it
    Vec offset_ = Vec::Zero(), offset_before_ = Vec::Zero();  ///< of the particles, SUM d_k (x_k - X_k) [m]
    Vec offset_velocity_ = Vec::Zero();                       ///< SUM d_k v_k [m/s]
};

extern template class CellBody<2>;
extern template class CellBody<3>;

}  // namespace dmp::solver
