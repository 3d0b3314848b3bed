// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/geometry.hpp"
#include "mesher/bond_network.hpp"
#include "mesher/cell_lattice.hpp"
#include "mesher/shell_lattice.hpp"
#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// What the mesher made, in numbers.
struct MeshReport {
    /// SUM V W over some particles: 1 where they fill the kernel's support evenly.
    struct KernelSums {
        std::size_t particles = 0;
        double mean = 0, spread = 0;  ///< spread: standard deviation [-]
    };
    static constexpr double nearest_bar = 0.02;  ///< width of a bar of the histogram [spacings]
    struct PartLine {
        std::string name;
        std::string kind;
        std::size_t particles = 0;
        double target = 0;   ///< what the geometry asks for: area [m^2] of a fluid, length [m] of walls and springs
        double reached = 0;  ///< what the particles stand for, same unit
        std::string unit;    ///< "m^2" or "m"
        double nearest = 0;  ///< smallest distance to any other particle [spacings]
        double kernel_sum_mean = 0;    ///< SUM V W over the part's particles (fluid only, else 0) [-]
        double kernel_sum_spread = 0;  ///< standard deviation of it [-]
        /// The same apart (fluid only): particles with one of a wall or a body within the kernel's support, and others.
        KernelSums near_walls, inside;
        /// Particles whose nearest neighbour is (k +- 1/2) nearest_bar spacings away, by k.
        std::vector<std::size_t> nearest_counts;
        /// Particles' volume less the drawn one, over the drawn one [-].
        [[nodiscard]] double volume_error() const { return target > 0 ? reached / target - 1 : 0; }
    };
    struct SpringLine {
        std::string part;
        int bodies = 0;
        std::size_t bonds = 0, hinges = 0, dihedrals = 0, anchored = 0;
        /// Of a solid of springs on cells, in 3-D or in 2-D.
        struct Cells {
            CellConstants constants;
            double stiffened = 1;  ///< see SolidBody
        };
        /// Of a shell in 3-D.
        struct Shell {
            ShellConstants constants;
            double membrane_stiffness_asked = 0;  ///< E h [N/m]
        };
        /// Of a solid of cells (elements), with a modulus and a Poisson's ratio.
        struct Elements {
            std::size_t count = 0, nodes = 0, cut = 0;  ///< cut: by the surface
            double volume = 0, drawn = 0;               ///< of the cells, and of the part [m^3], in 2-D [m^2]
            double youngs_modulus = 0;                  ///< [Pa]
            double poisson_ratio = 0;
            std::string law;
        };
        /// Of a solid of cells that was drawn as a straight bar (mesher/straight_bar.hpp).
        struct Bar {
            /// A stiffness of its cells, E A [N] or E I [N m^2], and its ratio to that of what was drawn.
            struct Stiffness {
                double value = 0, over_drawn = 1;
            };
            double length = 0;               ///< [m]
            Stiffness axial;                 ///< in 2-D for a depth of 1 m
            std::vector<Stiffness> bending;  ///< in 2-D one, in 3-D the lower one and the higher one
        };
        std::optional<Elements> elements;
        std::optional<Bar> bar;
        std::optional<Cells> cells;
        std::optional<Shell> shell;
        std::optional<NetworkConstants> network;  ///< of a solid with bonds_within
        // of a strip in 2-D
        double bond_stiffness = 0;         ///< k_b [N/m]
        double hinge_stiffness = 0;        ///< k_a [J]
        double cross_stiffness = 0;        ///< k_c of diagonals [N/m]; 0: there are none
        double bending_stiffness = 0;      ///< EI the lattice gives [N m^2]
        double axial_stiffness = 0;        ///< EA the lattice gives [N]
        double axial_stiffness_asked = 0;  ///< EA the scene asks for [N]
        double shear_stiffness = 0;        ///< GA_s the lattice gives [N]

        double particle_mass = 0;          ///< [kg]
        double counted = 0;                ///< of a solid of springs: what its nodes stand for over what is drawn [-]
        std::vector<std::size_t> valence;  ///< nodes by their number of bonds
        int pieces = 0;                    ///< of nodes that bonds join
    };
    /// Bonds between parts (mesher/join_parts.hpp).
    struct JoinLine {
        std::string name;
        std::array<std::string, 2> parts;
        std::size_t bonds = 0, across_gaps = 0;  ///< made; left out, as something is between
        double stiffness = 0;                    ///< k_b [N/m]
        double shortest = 0, longest = 0;        ///< [m]
    };
    struct SpheresLine {
        std::string part;
        std::size_t spheres = 0;
        double smallest = 0, largest = 0;  ///< radius [m]
        double mass = 0;                   ///< of all [kg]
        std::string around;                ///< the part they sit on; empty: none
        double coverage = 0;               ///< part of its surface that they hide [-]
        double volume_fraction = 0;        ///< of the box they fill; 0: they fill none [-]
    };
    struct WallLine {
        std::string part;
        std::size_t triangles = 0;  ///< 0: a plane
        double area = 0;            ///< of the triangles [m^2]
    };
    /// How far one surface is from another, over many places of it [spacings].
    struct Deviation {
        std::size_t positions = 0;
        double mean = 0, rms = 0, largest = 0;  ///< the last: of magnitudes
        Vec where = Vec::Zero();                ///< of the largest [m]
    };
    /// How well a fluid's particles follow its drawn surface (mesher/surface_error.hpp).
    struct SurfaceLine {
        std::string part;
        Deviation from_geometry, from_particles;
        double farthest = 0;  ///< any place of the drawn surface from its nearest fluid particle [spacings]
    };
    /// How many layers of particles stand one behind the other (mesher/layers.hpp).
    struct LayerLine {
        std::string part;
        double asked = 0;             ///< walls: the scene's layers; fluids: how far was looked
        double fewest = 0, mean = 0;  ///< over the drawn surface
        Vec where = Vec::Zero();      ///< of the fewest [m]
    };
    /// What a flood from outside found (mesher/leak_test.hpp).
    struct LeakLine {
        std::size_t cells = 0;      ///< flooded
        std::size_t particles = 0;  ///< of fluid that it reached: 0 is tight
        Vec where = Vec::Zero();    ///< of the first of them [m]
    };
    /// How the particles behaved when nothing drove them.
    struct RestLine {
        long steps = 0;
        std::size_t lost = 0;     ///< particles that left
        double largest_move = 0;  ///< of a fluid particle [spacings]
        std::string fault;        ///< what the run stopped for; empty: it went to its end
        [[nodiscard]] bool holds() const { return lost == 0 && fault.empty(); }
    };
    /// What the mesh took.
    struct Stage {
        std::string name;
        double seconds = 0;
        double processor_seconds = 0;  ///< of all threads together
    };
    struct Cost {
        std::size_t candidates = 0;  ///< lattice points that were looked at
        std::vector<Stage> stages;
        std::size_t peak_bytes = 0;                              ///< most memory the program has had; 0: unknown
        [[nodiscard]] Stage of(const std::string& stage) const;  ///< zeros where there was none
    };
    int dimension = 2;
    std::vector<PartLine> parts;
    std::vector<SurfaceLine> surfaces;  ///< of inspected meshes, as the next two
    std::vector<LayerLine> layers;
    std::optional<LeakLine> leaks;
    std::optional<RestLine> at_rest;  ///< where it was tried
    Cost cost;
    std::vector<SpringLine> springs;
    std::vector<JoinLine> joins;
    std::vector<SpheresLine> spheres;
    std::vector<WallLine> walls;  ///< for spheres
    std::size_t touching = 0;     ///< pairs of spheres that touch
    double deepest_overlap = 0;   ///< of those [m]
    std::vector<std::string>
        notes;  ///< what was adapted: lattice snapped to the period, fluid left out near solids, ...
    std::vector<std::string>
        warnings;  ///< what makes results wrong: gaps of few particles, stiffness not as asked, ...

    /// The table a person reads.
    [[nodiscard]] std::string text() const;
    /// The same figures for programs.
    [[nodiscard]] std::string json() const;
};

struct MeshResult {
    ParticleSet particles;
    MeshReport report;
    std::vector<float> kernel_sum;  ///< of each particle, SUM V W over all about it and itself; empty: spheres
};

/// Fills the geometry's regions, grows walls and builds spring bodies, as the scene's parts ask for.
/// Throws InputError: a part the geometry lacks or a name no part uses, an open fluid boundary, a period that is too
/// short, walls thinner than the kernel's support, a springs curve shorter than its layers allow, spring constants
/// that come out negative, a fluid with no particles, ...
MeshResult mesh(const Geometry& geometry, const Scene& scene);

}  // namespace dmp::mesher
