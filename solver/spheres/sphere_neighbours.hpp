// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/wall_clock.hpp"
#include "solver/domain/domain.hpp"
#include "solver/domain/halo.hpp"
#include "solver/neighbours/displacement_tracker.hpp"
#include "solver/spheres/contact_list.hpp"
#include "solver/spheres/sphere_setup.hpp"
#include "solver/spheres/sphere_skins.hpp"
#include "solver/store/position_quantum.hpp"

namespace dmp::solver {

/// Keeps at hand which spheres may touch: spheres spatially sorted on the rank that owns their place, copies of those
/// beyond its border, the list of pairs, and the contacts with what they remember. Two skins, as of the fluid's lists:
/// a wide one, with which pairs are listed, and a narrow one, with which contacts are picked out of them; both follow
/// how fast spheres move among each other. A common motion of all wears out neither.
class SphereNeighbours {
  public:
    SphereNeighbours(const Ranks& ranks, const ParticleSpace& space, const SphereSetup& setup, std::size_t ids,
                     int threads);

    /// In whose frame distances moved are measured [m/s]: the spheres' mean velocity when they were listed.
    [[nodiscard]] const std::array<double, 3>& drift() const { return drift_; }
    /// The skins that wear out as spheres move in that frame: of the list, and of the contacts.
    [[nodiscard]] const SphereSkins& wide() const { return since_list_.skins; }
    [[nodiscard]] const SphereSkins& narrow() const { return since_pruning_.skins; }
    /// Spheres have moved for dt [s] more, none faster than this in that frame [its skins/s]; the same on all ranks.
    void moved(double dt, double fastest_of_wide, double fastest_of_narrow) {
        since_list_.displacement.add(dt * fastest_of_wide);
        since_pruning_.displacement.add(dt * fastest_of_narrow);
        since_list_.time += dt;
        since_pruning_.time += dt;
        ++steps_;
    }
    /// Gives copies present values and makes list and contacts fit present places. Returns whether rows have changed.
    bool refresh(ParticleGroup& group, SphereRows& rows, SphereWalls& walls);
    /// Brings rows, list and contacts about at the start or after a checkpoint.
    void start(ParticleGroup& group, SphereRows& rows, SphereWalls& walls);

    [[nodiscard]] ContactList& list() { return list_; }
    [[nodiscard]] const ContactList& list() const { return list_; }
    [[nodiscard]] const Ranks& ranks() const { return *ranks_; }
    [[nodiscard]] const Halo& halo() const { return halo_; }
    [[nodiscard]] double imbalance() const { return imbalance_; }
    [[nodiscard]] long renewals() const { return renewals_; }
    [[nodiscard]] long prunings() const { return searches_; }
    [[nodiscard]] std::size_t bytes() const { return list_.bytes() + bytes(since_list_) + bytes(since_pruning_); }

    /// Contacts of this rank's own spheres with history, each once over all ranks.
    [[nodiscard]] std::vector<RememberedContact> own_contacts(const ParticleGroup& group) const;
    void archive(Archive& file, const ParticleGroup& group);
    /// Of spheres; they are below it.
    [[nodiscard]] std::int64_t ids() const { return memory_.ids(); }

  private:
    void renew(ParticleGroup& group, SphereRows& rows, SphereWalls& walls);
    void balance(ParticleGroup& group);
    void send_contacts(const ParticleGroup& group, SphereWalls& walls);
    void prune(ParticleGroup& group, const SphereRows& rows, const ContactMemory* memory);
    void measure_drift(const SphereRows& rows);
    void measure_step();
    void measure_pairs(const SphereRows& rows);

    /// How far spheres have gone in the frame since a moment.
    struct Since {
        SphereSkins skins;
        ReferencePositions positions;
        DisplacementTracker displacement;  ///< [skins]
        double time = 0;                   ///< since then [s]
    };
    static std::size_t bytes(const Since& since) { return since.skins.bytes() + since.positions.bytes(); }
    void start(Since& since, const SphereRows& rows) const;
    [[nodiscard]] bool beyond(Since& since, double share, SphereRows& rows) const;

    const Ranks* ranks_;
    double reach_, largest_radius_, mean_radius_;
    int threads_;
    Domain domain_;
    Halo halo_;
    ContactMemory memory_;
    ContactList list_;
    std::array<double, 3> drift_{};
    Since since_list_, since_pruning_;
    double near_skin_ = 0;  ///< of a pair on average [mean radii]
    double step_;           ///< of typical spheres [mean radii]
    double pairs_;          ///< listed for each sphere
    long steps_ = 0, renewals_ = 0, searches_ = 0;
    std::vector<bool> fixed_by_id_;

    WallClock::time_point last_renewal_ = WallClock::now();
    double imbalance_ = 1, time_lost_ = 0, time_to_divide_ = 0;

  public:
    /// By id: spheres that never move.
    void set_fixed(std::vector<bool> fixed_by_id) { fixed_by_id_ = std::move(fixed_by_id); }
};

}  // namespace dmp::solver
