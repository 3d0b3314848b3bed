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

/// What a rank has sent to others.
struct HaloTraffic {
    std::int64_t messages = 0, bytes = 0;
};

/// The copies of one group of particles: those of other ranks' particles, of periodic images and of mirror images at
/// planes of symmetry, that lie near the rank's own part of space. A group has a Halo of its own.
/// build(), exchange(), start(), finish() and ghosts_per_owned() must be called by all ranks together, for several
/// groups in the same order. One rank alone calls no MPI.
class Halo {
  public:
    Halo(Ranks ranks, ParticleSpace space, int threads = 1);
    ~Halo();
    Halo(const Halo&) = delete;
    Halo& operator=(const Halo&) = delete;
    Halo(Halo&& other) noexcept;
    Halo& operator=(Halo&& other) noexcept;

    /// Drops the group's copies and makes new ones, with their tags and all declared fields: every owned particle of
    /// any rank, moved by any whole periods and mirrored at planes of symmetry, that lies within `reach` of this rank's
    /// box and is not its own unmoved one, once. Vectors of mirrored copies are mirrored too. Particles must be where
    /// Domain::migrate left them. No order of the copies is promised.
    void build(ParticleGroup& group, const Domain& domain, double reach);

    /// Gives the copies the values that their particles have now; in the same images. Particles
    /// and copies must be those of the last build().
    void exchange(ParticleGroup& group, const FieldList& fields) {
        start(group, fields);
        finish(group);
    }
    /// The same in two steps: between them the fields of copies are not to be touched, and the group's size must stay.
    /// Values are those at the start. Several Halos may be under way at once.
    void start(ParticleGroup& group, const FieldList& fields);
    void finish(ParticleGroup& group);

    /// The same at once for values that lie side by side, `width` doubles a particle in the order of the group: a place
    /// and then whatever does not change from image to image. Not for images in a mirror.
    void exchange_rows(double* rows, std::size_t width);

    /// Of values, since it was made; making copies known is not counted.
    [[nodiscard]] const HaloTraffic& traffic() const { return traffic_; }
    /// This rank's copies at the last build().
    [[nodiscard]] std::size_t ghosts() const { return total_ - owned_; }
    /// The same over all ranks, for each of all their particles; 0 without particles.
    [[nodiscard]] double ghosts_per_owned() const;

  private:
    /// Consecutive sources of an Outgoing, up to `end`, that appear in the same image.
    struct Run {
        HaloImage image;
        std::size_t end = 0;
    };
    /// Which owned particles go to a rank.
    struct Outgoing {
        int rank = 0;
        std::vector<std::int32_t> sources;
        std::vector<Run> runs;
        std::vector<double> buffer;
    };
    struct Incoming {
        int rank = 0;
        std::size_t first = 0, count = 0;  ///< its copies
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
    Outgoing own_;                    ///< this rank's own images; their copies come first
    std::vector<Outgoing> outgoing_;  ///< to other ranks
    std::vector<Incoming> incoming_;
    std::size_t owned_ = 0, total_ = 0;
    FieldList fields_;  ///< under way
    HaloTraffic traffic_;
    std::unique_ptr<Requests> requests_;
};

}  // namespace dmp::solver
