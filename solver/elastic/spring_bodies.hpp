// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/elastic/body_change.hpp"
#include "solver/elastic/spring_body.hpp"
#include "solver/neighbours/cluster_list.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/state/archive.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// What has happened to the bonds of one elastic solid, [[solidify]] or [[join]] so far.
struct BondTally {
    std::int64_t made = 0, broken = 0;
};

/// All spring bodies of a scene. They may be cut, joined and made while it runs (change).
class SpringBodies {
  public:
    /// Every rank holds all bodies and moves them alike: they are few, and no rank then waits for another.
    SpringBodies(const ParticleSet& set, const Scene& scene, const Ranks& ranks, const SpringContact& contact = {});

    /// Largest stable explicit step by part name [s].
    struct PartLimit {
        std::string part;
        double dt;
    };
    [[nodiscard]] const std::vector<PartLimit>& step_limits() const { return limits_; }
    /// Spring steps that cover dt: one when implicit, 0 without bodies.
    [[nodiscard]] int substeps(double dt) const;
    [[nodiscard]] bool implicit() const { return implicit_; }

    /// Finds which particles of the store are which nodes. Needed when the store was sorted.
    void find_nodes(const ParticleStore& particles);
    /// Tells the store's particles the numbers of their bodies.
    void number_particles(ParticleStore& particles) const;
    /// Kicks all bodies by the forces in the store, then moves them over dt; the store sees their mean velocities.
    SpringImpulses advance(ParticleStore& particles, double dt, int threads);
    /// Bound of the square of the highest frequency of contacts, of nodes with anything, as positions and the list are
    /// now [1/s^2] (contact_stiffness.hpp). All ranks take part.
    [[nodiscard]] double largest_contact_rate(const ParticleStore& particles, const ClusterList& list,
                                              int threads) const;
    /// Hands the positions after the last advance to the store. Returns the longest way a node went [m].
    double show_positions(ParticleStore& particles) const;

    /// Makes, joins and cuts bodies. Bodies, and the numbers of nodes, are then others: nodes have to be found anew,
    /// and particles are told of their body by that. Bodies that the change does not touch stay as they are, with all
    /// they remember of their past. `space` with the periods that positions have.
    void change(const BodyChange& change, const ParticleSpace& space);
    /// By number of body_names().
    [[nodiscard]] const std::vector<BondTally>& tally() const { return tally_; }
    /// What nodes and bonds may come from: elastic solids, [[solidify]], [[join]].
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    /// Whether a particle is a node of a body, or a wall's that one is bonded to.
    [[nodiscard]] bool holds(std::int64_t id) const { return by_id_.contains(id); }
    /// The body, and the node of it, that a particle is.
    [[nodiscard]] std::pair<const SpringBody*, std::size_t> node_of(std::int64_t id) const {
        const Node& node = by_id_.at(id);
        return {bodies_[node.body].get(), static_cast<std::size_t>(node.index)};
    }

    void archive(Archive& file);

    [[nodiscard]] bool empty() const { return bodies_.empty(); }
    [[nodiscard]] const std::vector<std::unique_ptr<SpringBody>>& bodies() const { return bodies_; }

    /// A vector field of all nodes of all bodies, one body after another, as the ranks that own them have it.
    [[nodiscard]] std::vector<Vec> collected(const ParticleStore& particles, Field field) const;
    /// Hands such values to the store, to copies too.
    void show_in(ParticleStore& particles, Field field, const std::vector<Vec>& values) const;

  private:
    [[nodiscard]] std::unique_ptr<SpringBody> made_of(const BodyParts& parts) const;
    void number_nodes();
    void note_step_limits();
    void archive_parts(Archive& file);
    template <class ValueOf>
    void show(ParticleStore& particles, Field field, const ValueOf& value_of) const;

    struct Node {
        int body, index;  ///< index in its body
    };
    [[nodiscard]] double inverse_mass(const Node& node) const;  ///< [1/kg]; 0: fixed

    const Ranks& ranks_;
    int dimension_;
    std::vector<std::unique_ptr<SpringBody>> bodies_;
    std::vector<std::size_t> first_node_;  ///< of each body in the numbering of all nodes; and how many
    std::unordered_map<std::int64_t, Node> by_id_;
    std::vector<Node> nodes_;  ///< by index in the store's group, copies too
    std::vector<PartLimit> limits_;
    ParticleSpace space_;
    SpringContact contact_;
    std::vector<std::string> names_;
    std::vector<BondTally> tally_;
    bool changes_;  ///< bodies may, in this scene
    bool implicit_;
    double step_factor_;       ///< explicit: of the largest stable step [-]
    double largest_step_ = 0;  ///< explicit: the shortest limit times the scene's spring_step_factor [s]
};

}  // namespace dmp::solver
