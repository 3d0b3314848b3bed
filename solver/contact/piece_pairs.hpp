// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "solver/contact/contact_surfaces.hpp"

namespace dmp::solver {

/// Which pieces of the surfaces may touch before they have moved by half the skin: those that are near and face each
/// other, one of them free to move; but not neighbours on one surface, which are nearer than three spacings in the
/// undeformed part, nor a wall and what is held so near to it.
class PiecePairs {
  public:
    struct Other {
        int piece = 0;
        Vec shift = Vec::Zero();  ///< to its image [m]
    };

    /// @param deepest how far behind a surface contact looks [m]
    PiecePairs(const ParticleSpace& space, double deepest) : space_(space), deepest_(deepest) {}

    /// What pieces may move by, relative to each other, until it looks anew [spacings].
    static constexpr double skin = 0.4;

    /// Looks anew where pieces have moved too far since it last did; true: it did.
    bool update(const ContactSurfaces& surfaces);
    /// Looks anew the next time.
    void forget() { placed_.clear(); }
    /// At least how far pieces that may touch are from each other; infinite where none may [m].
    [[nodiscard]] double nearest(const ContactSurfaces& surfaces) const;
    /// Pieces that may touch any, by number.
    [[nodiscard]] const std::vector<int>& active() const { return active_; }
    /// Those that a piece may touch, by number.
    [[nodiscard]] std::span<const Other> others(int piece) const {
        const auto k = static_cast<std::size_t>(piece);
        return std::span(others_).subspan(first_[k], first_[k + 1] - first_[k]);
    }

  private:
    [[nodiscard]] bool moved_far(const ContactSurfaces& surfaces) const;

    const ParticleSpace& space_;
    double deepest_;
    std::vector<SurfacePiece> placed_;  ///< the pieces when it last looked
    std::vector<std::size_t> first_;
    std::vector<Other> others_;
    std::vector<int> active_;
};

}  // namespace dmp::solver
