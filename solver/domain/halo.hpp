// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "particles/particle_set.hpp"
#include "solver/domain/domain.hpp"
#include "solver/domain/halo_targets.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_group.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Data that a rank has sent to other ranks.
struct HaloTraffic {
    std::int64_t messages = 0, bytes = 0;
};

/// The ghost particles of one group: particles of other ranks, periodic images, and mirror images at planes of
/// symmetry that lie near the rank's own part of space. Each group has its own Halo.
/// build(), exchange(), start(), finish() and ghosts_per_owned() must be called by all ranks together, for several
/// groups in the same order. On one rank no MPI is called.
class Halo {
  public:
    Halo(Ranks ranks, ParticleSpace space, int threads = 1);
    ~Halo();
    Halo(const Halo&) = delete;
    Halo& operator=(const Halo&) = delete;
    Halo(Halo&& other) noexcept;
    Halo& operator=(Halo&& other) noexcept;

    /// Replaces the group's ghost particles by new ones, with their tags and all declared fields: every owned
    /// particle of any rank, moved by any whole periods and mirrored at planes of symmetry, that lies within `reach`
    /// of this rank's box, once. The rank's own particles at their actual positions are not among them. Vectors of
    /// mirrored ghosts are mirrored too. Particles must be where Domain::migrate left them. The order of the ghosts
    /// is unspecified.
    void build(ParticleGroup& group, const Domain& domain, double reach);

    /// Copies the current values of the particles to their ghosts; the images stay the same. Particles and ghosts
    /// must be those of the last build().
    void exchange(ParticleGroup& group, const FieldList& fields) {
        start(group, fields);
        finish(group);
    }
    /// The same in two steps: between them the fields of ghosts must not be accessed, and the group's size must not
    /// change. The values are those at the start. Several Halos may be exchanging at the same time.
    void start(ParticleGroup& group, const FieldList& fields);
    void finish(ParticleGroup& group);

    /// The same in one step for values stored in rows, `width` doubles per particle in the order of the group: a
    /// position, then values that are the same in all images. Not for mirror images.
    void exchange_rows(double* rows, std::size_t width);

    /// Data sent for values since construction; the ghost tags sent by build() are not counted.
    [[nodiscard]] const HaloTraffic& traffic() const { return traffic_; }
    /// Number of this rank's ghosts at the last build().
    [[nodiscard]] std::size_t ghosts() const { return total_ - owned_; }
    /// Ghosts of all ranks divided by the particles of all ranks; 0 without particles.
    [[nodiscard]] double ghosts_per_owned() const;

  private:
    /// Consecutive sources of an Outgoing, up to `end`, with the same image.
    struct Run {
        HaloImage image;
        std::size_t end = 0;
    };
    /// The owned particles that are sent to a rank.
    struct Outgoing {
        int rank = 0;
        std::vector<std::int32_t> sources;
        std::vector<Run> runs;
        std::vector<double> buffer;
    };
    struct Incoming {
        int rank = 0;
        std::size_t first = 0, count = 0;  ///< its ghosts
        std::vector<double> buffer;
    };
    struct Requests;

    [[nodiscard]] std::vector<Outgoing> wanted_ghosts(const ParticleGroup& group, const Domain& domain,
                                                      double reach) const;
    void make_room(ParticleGroup& group);
    void post_receives(std::size_t arrays);
    static void copy_rows(const Outgoing& outgoing, const double* rows, std::size_t width, double* to);
    void copy_values(const Outgoing& outgoing, const ParticleGroup& group, Field field, int axis, double* to) const;

    Ranks ranks_;
    ParticleSpace space_;
    int threads_;
    Outgoing own_;                    ///< this rank's own images; their ghosts come first
    std::vector<Outgoing> outgoing_;  ///< to other ranks
    std::vector<Incoming> incoming_;
    std::size_t owned_ = 0, total_ = 0;
    FieldList fields_;  ///< fields being exchanged
    HaloTraffic traffic_;
    std::unique_ptr<Requests> requests_;
};

}  // namespace dmp::solver
