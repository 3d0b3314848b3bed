// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "geometry/geometry.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"

namespace dmp {

/// What the mesher made, in numbers.
struct MeshReport {
    struct PartLine {
        std::string name;
        std::string kind;
        std::size_t particles = 0;
        double target = 0;   ///< what the drawing asks for: area [m^2] of a fluid, length [m] of walls and springs
        double reached = 0;  ///< what the particles stand for, same unit
        std::string unit;    ///< "m^2" or "m"
        double nearest = 0;  ///< smallest distance to any other particle [spacings]
        double kernel_sum_mean = 0;    ///< SUM V W over the part's particles (fluid only, else 0) [-]
        double kernel_sum_spread = 0;  ///< standard deviation of it [-]
    };
    struct SpringLine {
        std::string part;
        int bodies = 0;
        std::size_t bonds = 0, hinges = 0, anchored = 0;
        double bond_stiffness = 0;         ///< k_b [N/m]
        double hinge_stiffness = 0;        ///< k_a [J]
        double cross_stiffness = 0;        ///< k_c of diagonals and rungs [N/m]; 0: hinges in their place
        double bending_stiffness = 0;      ///< EI the lattice gives [N m^2]
        double axial_stiffness = 0;        ///< EA the lattice gives [N]
        double axial_stiffness_asked = 0;  ///< EA the scene asks for [N]
        double shear_stiffness = 0;        ///< GA_s the lattice gives [N]
        double particle_mass = 0;          ///< [kg]
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
    std::vector<PartLine> parts;
    std::vector<SpringLine> springs;
    std::vector<SpheresLine> spheres;
    std::vector<WallLine> walls;  ///< for spheres
    std::size_t touching = 0;     ///< pairs of spheres that touch
    double deepest_overlap = 0;   ///< of those [m]
    std::vector<std::string>
        notes;  ///< what was adapted: lattice snapped to the period, fluid left out near solids, ...

    /// The table a person reads.
    [[nodiscard]] std::string text() const;
};

struct MeshResult {
    ParticleSet particles;
    MeshReport report;
};

/// Fills the drawing's regions, grows walls and builds spring bodies, as the scene's parts ask for.
/// Throws InputError: a part the drawing lacks or a name no part uses, an open fluid boundary, a period that is too
/// short, walls thinner than the kernel's support, a springs curve shorter than its layers allow, spring constants
/// that come out negative, a fluid with no particles, ...
MeshResult mesh(const Geometry& geometry, const Scene& scene);

}  // namespace dmp
