// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
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

/// Number of bonds made and broken so far, of one elastic solid, [[solidify]] or [[join]].
struct BondTally {
    std::int64_t made = 0, broken = 0;
};

/// All elastic bodies of a scene. They may be cut, joined and created during the run (change).
class SpringBodies {
  public:
    /// Every rank stores and advances all bodies identically: they are few, and no rank has to wait for another.
    SpringBodies(const ParticleSet& set, const Scene& scene, const Ranks& ranks, const SpringContact& contact = {},
                 double liquid_density = 0);

    /// Largest stable explicit step by part name [s].
    struct PartLimit {
        std::string part;
        double dt;
    };
    [[nodiscard]] const std::vector<PartLimit>& step_limits() const { return limits_; }
    /// Number of spring steps in dt: 1 if implicit, 0 without bodies.
    [[nodiscard]] int substeps(double dt) const;
    [[nodiscard]] bool implicit() const { return implicit_; }

    /// Finds the node of each particle in the store. Must be called after the store was sorted.
    void find_nodes(const ParticleStore& particles);
    /// Sets the body numbers of the store's particles.
    void number_particles(ParticleStore& particles) const;
    /// Writes the bodies' present velocities to the store, as they start.
    void show_velocities(ParticleStore& particles) const;
    /// Writes the surfaces in front of the bodies' particles to the store, with the gradient of their mean velocity
    /// over the last advance, of dt; 0: of their present velocity.
    void show_surfaces(ParticleStore& particles, double dt) const;
    /// Applies the forces in the store to all bodies, then advances them by dt; writes their mean velocities to the
    /// store. In `parts` equal parts, before each of which `contact` kicks the bodies, if there is one.
    SpringImpulses advance(ParticleStore& particles, double dt, int threads, int parts = 1,
                           const std::function<void(double)>& contact = {});
    /// Upper bound of the square of the highest contact frequency of nodes, for current positions and the current
    /// list [1/s^2] (contact_stiffness.hpp). All ranks must call it.
    [[nodiscard]] double largest_contact_rate(const ParticleStore& particles, const ClusterList& list,
                                              int threads) const;
    /// Mass of the node that is this particle of the store's group [kg]: its inertia and its weight, while Field::mass
    /// is that of the liquid it displaces.
    [[nodiscard]] double node_mass(std::size_t particle) const {
        const Node& node = nodes_[particle];
        return bodies_[node.body]->mass(static_cast<std::size_t>(node.index));
    }
    /// Where this particle of the store's group was drawn, or turned solid: the place that its displacement counts
    /// from, which may be any number of periods away [m].
    [[nodiscard]] Vec rest_position(std::size_t particle) const {
        const Node& node = nodes_[particle];
        return bodies_[node.body]->rest_position(static_cast<std::size_t>(node.index));
    }
    /// Moves the nodes in the store from one part of the way that the last advance made to another, each a share of it
    /// [-]. Returns the largest displacement of a node [m].
    double show_positions(ParticleStore& particles, double from = 0, double to = 1) const;

    /// Creates, joins and cuts bodies. Bodies and node numbers change: call find_nodes() and number_particles()
    /// again. Bodies that the change does not affect keep all their state. `space` must have the periods used for
    /// positions.
    void change(const BodyChange& change, const ParticleSpace& space);
    /// By number in body_names().
    [[nodiscard]] const std::vector<BondTally>& tally() const { return tally_; }
    /// Possible origins of nodes and bonds: elastic solids, [[solidify]], [[join]].
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    /// True if a particle is a node of a body, or a wall particle to which one is bonded.
    [[nodiscard]] bool holds(std::int64_t id) const { return by_id_.contains(id); }
    /// The body of a particle, and its node there.
    [[nodiscard]] std::pair<const SpringBody*, std::size_t> node_of(std::int64_t id) const {
        const Node& node = by_id_.at(id);
        return {bodies_[node.body].get(), static_cast<std::size_t>(node.index)};
    }

    void archive(Archive& file);

    [[nodiscard]] bool empty() const { return bodies_.empty(); }
    /// Of all nodes, held ones too, but not of wall particles to which bodies are bonded [kg].
    [[nodiscard]] double mass() const;
    [[nodiscard]] const std::vector<std::unique_ptr<SpringBody>>& bodies() const { return bodies_; }

    /// A vector field of all nodes of all bodies, one body after another, collected from the ranks that own the
    /// particles.
    [[nodiscard]] std::vector<Vec> collected(const ParticleStore& particles, Field field) const;
    /// Writes such values to the store, including ghosts.
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
    std::vector<std::size_t> first_node_;  ///< of each body in the numbering of all nodes; then the number of nodes
    std::unordered_map<std::int64_t, Node> by_id_;
    std::vector<Node> nodes_;  ///< by index in the store's group, including ghosts
    std::vector<PartLimit> limits_;
    ParticleSpace space_;
    SpringContact contact_;
    std::vector<std::string> names_;
    std::vector<BondTally> tally_;
    bool changes_;  ///< true if bodies may change in this scene
    bool implicit_;
    double step_factor_;       ///< explicit: fraction of the largest stable step [-]
    double largest_step_ = 0;  ///< explicit: the shortest limit times the scene's spring_step_factor [s]
};

}  // namespace dmp::solver
