// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "models/contact/surface_contact.hpp"
#include "scene/scene.hpp"
#include "solver/contact/contact_surfaces.hpp"
#include "solver/contact/liquid_film.hpp"
#include "solver/contact/piece_pairs.hpp"
#include "solver/state/archive.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// How the forces of contact act in a step.
enum class ContactStepping {
    at_start,  ///< those of the places at its start; the stiffness sets a limit to the step
    in_parts,  ///< likewise, and steps in which something may touch are taken in parts: dry scenes
    at_end,    ///< those of the places at its end, implicitly: any stiffness, also in liquid
};

/// The derivative of contact's forces on unknowns, minus: stiffness + films conductance^-1 films^T. A row is an
/// unknown's number times the dimension plus the axis.
struct ContactMatrix {
    Eigen::SparseMatrix<double> stiffness;    ///< [kg/s]
    Eigen::SparseMatrix<double> films;        ///< by share in the pressure of films [m, m^2]
    Eigen::SparseMatrix<double> conductance;  ///< lower triangle [m^3/(Pa s), m^4/(Pa s)]
};

struct ContactImpulses {
    Vec of_supports, on_walls;  ///< [N s]
};

/// Contact of elastic bodies with each other, with walls and with themselves, as their drawn surfaces. Each surface is
/// sampled at Gauss points q, of weight w; each meets the nearest point y of another surface that faces it, whose
/// normal is n:
///   g = (x_q - y) . n,   U = SUM a w k g^2 / 2   (g < 0),   a = W(y) / (W(q) + W(y))
/// Both surfaces are sampled, hence the share a, a half but near corners that stick out, where the samples of the
/// corner have more (ContactSurfaces::weight): samples that pass a corner are not lost at once. As x_q - y is along n,
/// the forces -+ (a w k g n + grad a w k g^2 / 2), given to what carries x_q and y, are the gradient of U (the
/// second term to lowest order in g), and opposite: energy and momentum are kept. What acts along the surfaces (the
/// second term, friction) acts at x_q and y, which are g apart; its moment is taken by a couple on a piece. (Puso &
/// Laursen 2004; Fischer & Wriggers 2005; docs/elastic.md)
///
/// Every rank holds all bodies and does the same.
class SurfaceContact {
  public:
    /// @param longest_step that the other limits allow [s]: an automatic stiffness does not shorten it
    /// @param viscosity of the liquid that fills what is between surfaces; 0: none does [Pa s]
    SurfaceContact(const Scene& scene, const ParticleSet& set, const SpringBodies& bodies, double longest_step,
                   double viscosity, int threads);

    /// Bodies have been cut or joined.
    void find_bodies(const SpringBodies& bodies);
    [[nodiscard]] ContactStepping stepping() const { return stepping_; }
    [[nodiscard]] int dimension() const { return space_.dimension; }
    /// In how many parts a step has to be taken, each with a kick: one where nothing will touch in it.
    [[nodiscard]] int parts_of_step(const SpringBodies& bodies, const WallMotion& walls, double t, double dt);
    /// Kicks the bodies by the forces of contact at their present places, over dt.
    ContactImpulses kick(SpringBodies& bodies, const WallMotion& walls, double t, double dt);

    /// Implicit contact: whether anything may touch in this step; what follows is of such a step.
    [[nodiscard]] bool may_touch(const SpringBodies& bodies, const WallMotion& walls, double t, double dt);
    /// By body: whether it may.
    [[nodiscard]] const std::vector<bool>& touched_bodies() const { return touched_bodies_; }
    /// Adds the forces at the end of the step on free unknowns, if their mean velocities in it are w, to the balance of
    /// the bodies.
    void add_forces_at_end(std::span<const Vec> w, std::span<Vec> force);
    /// Adds minus the derivative of what this adds with respect to w, near the last w, times values. Friction that
    /// slides is left out.
    void add_stiffness_times(std::span<const Vec> values, std::span<Vec> image);
    /// What add_stiffness_times() does, as matrices.
    [[nodiscard]] ContactMatrix matrix() const;
    /// Has the forces of the last w act on the bodies in their next advance. Returns the impulse on the walls [N s].
    [[nodiscard]] Vec press(SpringBodies& bodies);

    /// Adds the mean forces on walls since the last time, over dt, to those of the store.
    void show_on_walls(ParticleStore& particles, double dt);
    /// Largest stable step, or part of one, where all surfaces touch [s].
    [[nodiscard]] double step_limit() const;

    /// Of elastic parts, with their names [Pa/m].
    [[nodiscard]] std::vector<std::pair<std::string, double>> stiffness_of_parts() const {
        std::vector<std::pair<std::string, double>> of_parts;
        for (std::size_t part = 0; part < stiffness_.size(); ++part)
            if (stiffness_[part] < std::numeric_limits<double>::infinity())
                of_parts.emplace_back(space_.parts[part].name, stiffness_[part]);
        return of_parts;
    }

    struct Sums {
        Vec force = Vec::Zero();  ///< on the part [N]
        double area = 0;          ///< in which it touches [m^2]
        double pressure = 0;      ///< the largest mean on a piece of a surface, at most a spacing long [Pa]
    };
    /// Of the last step, or the last part of it: of a part against another, or the same; empty: against all. In 2-D 1 m
    /// deep.
    [[nodiscard]] Sums sums(const std::string& part, const std::string& against) const;

    /// Of touches, over the run so far.
    struct Deepest {
        double depth = 0;         ///< [m]
        double time = 0;          ///< [s]
        Vec place = Vec::Zero();  ///< [m]
        std::array<int, 2> parts{};
    };
    [[nodiscard]] const Deepest& deepest() const { return deepest_of_all_; }

    /// Of points that are behind a surface of another solid now, also where contact does not see them: up to a spacing.
    [[nodiscard]] Deepest passed() const;

    void archive(Archive& file);

  private:
    static constexpr int no_solid = -1;
    /// What is at rest may meet something in a step if it is nearer than this [spacings].
    static constexpr double at_rest = 0.05;
    static std::size_t index_of(int number) { return static_cast<std::size_t>(number); }

    struct Touch {
        bool is_one = false;
        bool is_apart = false;     ///< whether the point is in front of the surface that it is nearest to
        int own = -1, other = -1;  ///< the pieces: the point's, and the one that it meets
        std::size_t number = 0;    ///< of the point on its piece
        PiecePlace place{};        ///< on the other piece
        Vec from = Vec::Zero(), at = Vec::Zero(), normal = Vec::Zero();
        double gap = 0;                 ///< counted from `start` [m]
        double start = 0;               ///< [m]
        double share = 0;               ///< a [-]
        Vec share_slope = Vec::Zero();  ///< its gradient along the other surface [1/m]
        double pressure = 0;            ///< [Pa]
        Vec force = Vec::Zero();        ///< on the piece of the point [N]
        /// By how much the forces at the end of the step fall with the velocity along the normal, the tangent [N s/m].
        double normal_slope = 0, tangent_slope = 0;
    };
    /// What a point of a surface remembers.
    struct Memory {
        int solid = no_solid;    ///< that it touches
        double gap = 0;          ///< [m]
        Vec slip = Vec::Zero();  ///< [m]
    };
    /// Where bodies were drawn into each other, or a point got behind a surface at once: its gap counts from there.
    struct Start {
        int solid = no_solid;  ///< into which
        double gap = 0;        ///< [m]
    };

    void find_stiffness(const Scene& scene, const SpringBodies& bodies, double longest_step);
    [[nodiscard]] double rate_of_full_touch(int part) const;
    void find_start(const Scene& scene, const SpringBodies& bodies);
    void read_bodies(const SpringBodies& bodies);
    void place(const SpringBodies& bodies, const WallMotion& walls, double t, double dt);
    [[nodiscard]] double farthest_way() const;
    [[nodiscard]] bool meets_soon(const Touch& touch) const;
    void archive_deepest(Archive& file);
    /// Those nearer than `margin` [m]. `drawn`: as bodies were drawn.
    void find_touches(double margin, bool drawn = false);
    void find_touched_controls();
    /// The nearest place of other pieces that a point faces, if it is within `deepest_`: other, place, shift.
    struct Nearest {
        int other = -1;
        PiecePlace place{};
        Vec shift = Vec::Zero();  ///< to the image of the other piece [m]
    };
    [[nodiscard]] Nearest nearest_to(int piece, std::size_t number) const;
    [[nodiscard]] Touch touch_of(int piece, std::size_t number, double margin, bool drawn) const;
    [[nodiscard]] double start_of(const Touch& touch, double gap) const;
    [[nodiscard]] double fastest_at(int piece) const;
    /// What is near a point when the pairs are found.
    struct Near {
        double clearance = 0;                   ///< how far it is from the others; 0 where it is behind one [m]
        std::vector<PiecePairs::Other> others;  ///< that may be nearest until they are found anew, nearest first
    };
    void find_pairs();
    [[nodiscard]] Near near_to(int piece, std::size_t number) const;
    [[nodiscard]] double depth_behind(int piece, std::size_t number, int& nearest_piece) const;
    [[nodiscard]] double gap_at(const Vec& from, int piece, const PiecePlace& place, const Vec& shift,
                                Vec& normal) const;
    [[nodiscard]] double stiffness_of(int piece, int other) const;
    /// Forces of the present touches, at gaps of `ahead` from now [s]; `remembers`: they are those that act.
    void find_forces(double ahead, bool remembers);
    void add_force(Touch& touch, double ahead, bool remembers);
    void remember(const Touch& touch, double gap, const Vec& slip);
    void find_films();
    void add_film_forces();
    [[nodiscard]] std::vector<Vec> past_in_films() const;
    void add_couple(int piece, const Vec& arm, const Vec& force);
    void push(int piece, const PiecePlace& place, const Vec& force);
    [[nodiscard]] Vec velocity_at(int piece, const PiecePlace& place) const;
    /// Of the control points' velocities and forces; those of walls count for nothing.
    [[nodiscard]] Vec carried_at(int piece, const PiecePlace& place) const;
    void give(int piece, const PiecePlace& place, const Vec& force);
    [[nodiscard]] const ContactSurfaces::Piece& piece(int number) const { return surfaces_.pieces()[index_of(number)]; }
    [[nodiscard]] const PiecePlace& place_of(const Touch& touch) const {
        return surfaces_.points()[touch.number].place;
    }
    /// Of a point of a piece, among those of all.
    [[nodiscard]] std::size_t index_of(int piece, std::size_t number) const {
        return index_of(piece) * surfaces_.points().size() + number;
    }
    Vec impulse_on_walls();

    const ParticleSpace space_;
    int threads_;
    SurfaceContactLaw law_;
    double given_stiffness_;  ///< 0: none
    double at_walls_;         ///< how much stiffer an automatic contact is at walls, which do not give way
    ContactStepping stepping_;
    double deepest_;  ///< how far behind a surface it looks [m]
    ContactSurfaces surfaces_;
    PiecePairs pairs_;
    std::optional<LiquidFilm> films_;
    std::vector<double> stiffness_;  ///< by part; of walls infinite [Pa/m]
    std::vector<double> rate_;       ///< by part: square of the highest frequency where all of it touches a wall, over
                                     ///< the stiffness [m^2/kg]

    std::vector<Vec> position_, velocity_, force_;       ///< by unknown
    std::vector<Vec> control_velocity_, control_force_;  ///< by control point; of those of touched pieces
    std::vector<int> touched_controls_;                  ///< theirs, in the order of the touches; not those of walls
    std::vector<bool> is_touched_;                       ///< by control point: whether it is one of them
    std::vector<double> inverse_mass_;
    std::vector<bool> touched_bodies_;
    const WallMotion* walls_ = nullptr;  ///< of the present step, with its time and length [s]
    double t_ = 0, dt_ = 0;
    std::vector<Touch> touches_;         ///< by piece and point
    std::vector<Touch> in_films_;        ///< likewise
    std::vector<Near> near_;             ///< by point of all pieces
    std::vector<int> examined_;          ///< pieces whose points may remember something
    std::vector<Memory> memory_;         ///< by point of all pieces
    std::vector<Start> start_;           ///< likewise
    std::vector<bool> is_drawn_inside_;  ///< likewise: whether it was drawn behind a surface
    std::vector<Vec> on_walls_;          ///< by piece [N]
    std::vector<Vec> impulse_on_walls_;  ///< by piece, in this step [N s]
    Deepest deepest_of_all_;
};

}  // namespace dmp::solver
