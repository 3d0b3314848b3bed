// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/state/archive.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/time/spring_body.hpp"

namespace dmp {

/// All spring bodies of a scene.
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
    /// Kicks all bodies by the forces in the store, then moves them over dt; the store sees their mean velocities.
    SpringImpulses advance(ParticleStore& particles, double dt, int threads);
    /// Hands the positions after the last advance to the store. Returns the longest way a node went [m].
    double show_positions(ParticleStore& particles) const;

    void archive(Archive& file);

    [[nodiscard]] bool empty() const { return bodies_.empty(); }
    [[nodiscard]] const std::vector<std::unique_ptr<SpringBody>>& bodies() const { return bodies_; }

    /// A vector field of all nodes of all bodies, one body after another, as the ranks that own them have it.
    [[nodiscard]] std::vector<Vec> collected(const ParticleStore& particles, Field field) const;
    /// Hands such values to the store, to copies too.
    void show_in(ParticleStore& particles, Field field, const std::vector<Vec>& values) const;

  private:
    template <class ValueOf>
    void show(ParticleStore& particles, Field field, const ValueOf& value_of) const;

    struct Node {
        int body, index;  ///< index in its body
    };
    const Ranks& ranks_;
    int dimension_;
    std::vector<std::unique_ptr<SpringBody>> bodies_;
    std::vector<std::size_t> first_node_;  ///< of each body in the numbering of all nodes; and how many
    std::unordered_map<std::int64_t, Node> by_id_;
    std::vector<Node> nodes_;  ///< by index in the store's group, copies too
    std::vector<PartLimit> limits_;
    bool implicit_;
    double largest_step_ = 0;  ///< explicit: the shortest limit times the scene's spring_step_factor [s]
};

}  // namespace dmp
