// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "models/sph/fluid_law_list.hpp"
#include "models/sph/viscous_scales.hpp"
#include "scene/choices.hpp"
#include "solver/neighbours/cluster_list.hpp"
#include "solver/parallel/resources.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/sweeps/reference_pressure.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Settings of the pair terms of a scene by model, in SI units.
struct PairSettings {
    KernelKind kernel = KernelKind::wendland_c2;
    double spacing = 0;              ///< dx [m]
    double support = 0;              ///< support radius R [m]
    std::array<bool, 3> periodic{};  ///< by axis

    double sound_speed = 0;            ///< c0 [m/s]
    double background_pressure = 0;    ///< [Pa]
    bool gradient_correction = false;  ///< for pressure forces and density rates
    bool corrected = false;            ///< the corrected scheme: density rates from the corrected velocity gradient
    bool several_fluids = false;       ///< fluids differ in rest density or viscosity
    bool free_surface = false;         ///< corrected scheme: shifting vanishes where neighbours are missing
    bool subtracts_level = false;      ///< corrected scheme: forces are of pressures less a reference
    /// Where the level is subtracted: some elastic bodies border on nothing at the start and feel the whole pressure.
    bool dry_bodies = false;
    bool keeps_volume = false;  ///< where the level is subtracted: nothing moves that can change the fluid's volume
    bool chambers = false;      ///< of a volume that is kept: of each of several chambers, which there are or may be

    struct {
        double largest = 0;         ///< largest rest density [kg/m^3]
        bool by_summation = false;  ///< otherwise by continuity
        double diffusion = 0;       ///< delta [-]; 0: none
    } density{};

    /// With a free surface, or a body force along an axis that is not periodic: density diffusion acts on the
    /// pressure difference minus the hydrostatic one, and shifting vanishes at the surface.
    bool hydrostatic = false;

    struct {
        ViscousLaw law;
        ViscosityMean mean = ViscosityMean::harmonic;
        bool unlike = false;    ///< fluids differ in viscosity
        double largest = 0;     ///< largest dynamic viscosity [Pa s]
        bool implicit = false;  ///< viscosity is solved for separately and not part of the forces
    } viscosity{};

    double shifting = 0;              ///< s [-]; 0: none
    bool transport_velocity = false;  ///< instead of shifting

    struct {
        WallModel model = WallModel::extrapolated;
        bool slip = false;     ///< some walls have slip
        bool moving = false;   ///< some walls move
        bool sliding = false;  ///< the surface of some walls slides along itself

        [[nodiscard]] bool at_rest() const { return !slip && !moving && !sliding; }
    } walls{};

    double repulsion_strength = 0;  ///< K [J]; 0: none
    bool surface_contact = false;   ///< solids touch as their surfaces: their particles repel the fluid's alone

    int threads = 1;
    VectorUnit vector_unit = VectorUnit::widest;
};

/// What the forces of one step depend on, besides the particles.
struct ForceSums {
    std::array<double, 3> body_acceleration{};  ///< [m/s^2]
    std::array<double, 3> subtracted{};  ///< slope of the reference that the fluid's pressures are less of [Pa/m]
    double dt = 0;                       ///< [s]; ViscosityInTension needs it
};

/// Velocities for which the viscous force is computed.
struct ViscousMotion {
    Field velocity = Field::velocity;  ///< of fluid particles and elastic bodies, including ghosts
    double of_walls = 1;               ///< factor for the walls' velocity; 0: walls at rest
    double largest_term = 0;           ///< of one pair [N]; sums stay exact up to 128 times that
};

/// The pairs between which a species diffuses.
struct SpeciesPairs {
    const ClusterList& meeting;
    const ClusterList* within_solids;  ///< null: no species diffuses within solids
};

/// Settings for summing the diffusion of one species.
struct SpeciesSums {
    enum class Of {
        amounts,      ///< amounts that particles receive from their neighbours
        conductances  ///< sum over all pairs of a particle: coefficient of its own concentration
    };
    Of of = Of::amounts;
    int species = 0;                      ///< number of the species
    Field values = Field::concentration;  ///< used as concentrations, including ghosts
    int array_of_values = 0;
    Field result = Field::species_amount;
    int array_of_result = 0;
    bool adds = false;                              ///< adds to the result field instead of replacing it
    double time = 1;                                ///< duration of the diffusion [s]
    double largest_term = 0;                        ///< of one pair; sums stay exact up to 128 times that
    bool with_rigid = false, with_elastic = false;  ///< some of these particles take part
    double shift_per_sum = 0;                       ///< displacement per unit of Field::shift [m^2]; 0: none
    double longest_shift = 0;                       ///< [m]
    double diffusivity = -1;                        ///< of all fluid particles [m^2/s]; negative: by particle

    /// Displacement of particles by the coming shift, from their sum of the shifting law [m].
    template <class V>
    [[nodiscard]] V displacement(const V& shift_sum) const {
        using std::min;
        using std::sqrt;
        using T = std::decay_t<decltype(shift_sum[0])>;
        constexpr double smallest = 1e-300;
        const V shift = T(shift_per_sum) * shift_sum;
        return min(T(1.0), longest_shift / sqrt(dot(shift, shift) + smallest)) * shift;
    }
};

/// The sweeps over all pairs in one step: two, and one more for each additional model. Each sweep visits every pair
/// of a cluster and a neighbour once and applies all pair terms of its stage.
class PairSweeps {
  public:
    virtual ~PairSweeps() = default;

    /// Computes force [N] on every particle of the chosen clusters, including fixed ones (their reaction): pressure,
    /// viscosity, repulsion.
    virtual void forces(ParticleStore& particles, const ClusterList& list, const ForceSums& sums,
                        ClusterChoice choice = ClusterChoice::all) const = 0;

    /// Adds to the forces on elastic solids that border on nothing what the reference pressure exerts on them [N], and
    /// stores it in level_force.
    virtual void level_forces(ParticleStore& particles, const ClusterList& list, const ReferencePressure& reference,
                              ClusterChoice choice = ClusterChoice::all) const = 0;

    /// Computes velocity_gradient, mean_correction, density_rate, next_density_gradient and, with shifting, shift of
    /// the fluid (corrected scheme).
    virtual void gradients(ParticleStore& particles, const ClusterList& list,
                           const std::array<double, 3>& body_acceleration,
                           ClusterChoice choice = ClusterChoice::all) const = 0;

    /// Computes density_rate [kg/m^3/s] and, with shifting, the sum over neighbours that becomes `shift` [1/m], for
    /// fluid particles; with plain walls also the density rate of solids. `along`: a species whose diffusion is fused
    /// into the sweep.
    virtual void density_rates(ParticleStore& particles, const ClusterList& list,
                               const std::array<double, 3>& body_acceleration,
                               ClusterChoice choice = ClusterChoice::all, const SpeciesSums* along = nullptr) const = 0;
    /// True if density_rates can fuse the diffusion: no solid takes part, the whole fluid has one diffusivity, and
    /// walls and densities are those of most scenes.
    [[nodiscard]] virtual bool can_fuse(const SpeciesSums& sums) const = 0;

    /// Computes viscous_force [N] alone, for fluid and elastic bodies and, if walls move, for walls.
    virtual void viscous_forces(ParticleStore& particles, const ClusterList& list, const ViscousMotion& motion,
                                ClusterChoice choice = ClusterChoice::all) const = 0;
    /// Computes viscous_diagonal [kg/s] for fluid and elastic bodies: by axis, minus the derivative of a particle's
    /// viscous force with respect to its own velocity.
    virtual void viscous_diagonal(ParticleStore& particles, const ClusterList& list,
                                  ClusterChoice choice = ClusterChoice::all) const = 0;
    /// Computes density [kg/m^3] of the fluid as a sum over neighbours; `rest_density` by part number.
    virtual void densities(ParticleStore& particles, const ClusterList& list, std::span<const double> rest_density,
                           ClusterChoice choice = ClusterChoice::all) const = 0;

    /// Computes the gradient correction of the fluid. Ghosts need it too before forces and density rates are computed
    /// with it.
    virtual void corrections(ParticleStore& particles, const ClusterList& list,
                             ClusterChoice choice = ClusterChoice::all) const = 0;

    /// Sums the diffusion of a species, for the fluid and the solids that take part.
    virtual void species(ParticleStore& particles, const SpeciesPairs& pairs, const SpeciesSums& sums) const = 0;

    /// Prunes the list to the particles within `reach` [m] of a cluster's members.
    virtual void prune(const ParticleStore& particles, ClusterList& list, double reach) const = 0;

    /// Largest stable c dt / support and nu dt / support^2 of the kernel (linear theory).
    [[nodiscard]] virtual double sound_limit() const = 0;
    [[nodiscard]] virtual double viscous_limit() const = 0;
    /// Scale factors of the viscous law on the lattice.
    [[nodiscard]] virtual ViscousScales viscous_scales() const = 0;
    /// The same for the diffusion of species, D dt / support^2.
    [[nodiscard]] virtual double diffusion_limit() const = 0;
    /// W at distance r [1/m^D], for interpolation at points.
    [[nodiscard]] virtual double kernel_value(double r) const = 0;
    /// (1/r) dW/dr at distance r [1/m^(D+2)].
    [[nodiscard]] virtual double kernel_slope(double r) const = 0;
    /// Displacement per unit of the shift sum for one step [m^2], and the longest displacement [m].
    [[nodiscard]] virtual double shift_step(double quartic_mean_speed, double largest_speed, double dt) const = 0;
    [[nodiscard]] virtual double longest_shift() const = 0;
};

/// Returns the sweeps for these settings, in 2-D or in 3-D as the particles. Declares the fields they need. Throws
/// ResourceError if the processor does not have the vector unit.
std::unique_ptr<PairSweeps> make_pair_sweeps(const PairSettings& settings, ParticleStore& particles);

}  // namespace dmp::solver
