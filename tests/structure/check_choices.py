#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that a choice forgotten somewhere does not compile: adds a value to an enumeration or a law to a registry, in
a copy of the header that has them, compiles a file that must know of it, and reads what the compiler says.

Usage: check_choices.py COMPILER FOLDER:FOLDER...   (where others' headers are)
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMPILER, SYSTEM = None, []
CHOICES = "scene/choices.hpp"
NOT_HANDLED = "enumeration value 'forgotten' not handled in switch"

ADHESION_WITHOUT_PULL_OFF = """struct Forgotten : NoAdhesion {
    static constexpr LawFacts facts{"forgotten", "", "adhesive, and it says not how much"};
    static constexpr bool adhesive = true;
};
"""


NO_INVERSE = """struct Forgotten {
    static constexpr LawFacts facts{"forgotten", "", "a pressure without its density"};
    double sound_speed, rest_density;
    double pressure(double) const { return 0; }
    double lowest_pressure() const { return 0; }
};
"""


NO_TANGENT = """struct Forgotten {
    static constexpr LawFacts facts{"forgotten", "", "a stress without its derivative"};
    LameConstants constants;
    template <int D> double energy(const Matrix<D>&) const { return 0; }
    template <int D> Matrix<D> stress(const Matrix<D>& c) const { return c; }
};
"""


def replaced(header, *changes):
    """The header with each (old, new) replaced, each of which it must have once."""
    text = (ROOT / header).read_text()
    for old, new in changes:
        if text.count(old) != 1:
            raise ValueError(f"{header} has {text.count(old)} times: {old}")
        text = text.replace(old, new)
    return {header: text}


def with_value(last, name):
    """choices.hpp with the value and name `forgotten` after the last ones of an enumeration."""
    return replaced(CHOICES, (last, last.replace("}", ", forgotten }")), (name, name + ', "forgotten"'))


def with_law(names, first, bodies, before, law):
    """The law `Forgotten`, defined in `bodies`, as the first of a registry in the list `names`."""
    return replaced(names, (first, first.replace("<", "<struct Forgotten, "))) | replaced(bodies, (before, law + before))


def compiled(file, headers):
    """What the compiler says of a source file where these headers (name -> text) replace the tree's."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in headers.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        command = [COMPILER, "-std=c++20", "-fsyntax-only", "-fopenmp", "-Wall", "-Werror", "-Wno-psabi"]
        command += ["-I", folder, "-I", ROOT]
        for other in SYSTEM:
            command += ["-idirafter", other]  # some are the compiler's own, whose order counts
        result = subprocess.run([*command, ROOT / file], capture_output=True, text=True,
                                env={**os.environ, "LC_ALL": "C"})
        return result.returncode, result.stderr


class Forgotten(unittest.TestCase):
    def refused(self, file, headers, message):
        code, said = compiled(file, headers)
        self.assertNotEqual(code, 0, f"{file} compiles")
        self.assertIn(message, said)

    def test_a_file_compiles_as_it_is(self):
        self.assertEqual(compiled("solver/forcing/driving.cpp", {}), (0, ""))

    def test_side_of_a_shape(self):
        self.refused("solver/forcing/driving.cpp",
                     with_value("PushedSide { both, inside, outside }", '"both", "inside", "outside"'), NOT_HANDLED)

    def test_kind_of_a_shape(self):
        self.refused("solver/forcing/driving.cpp",
                     with_value("ShapeKind { parabola, circle }", '"parabola", "circle"'), NOT_HANDLED)

    def test_kernel(self):
        headers = with_value("wendland_c4, lucy, cubic_spline, quintic_spline }", '"cubic_spline", "quintic_spline"')
        for file in ("mesher/quality.cpp", "solver/sweeps/pair_sweeps.cpp"):
            self.refused(file, headers, NOT_HANDLED)

    def test_wall_model(self):
        headers = with_value("WallModel { extrapolated, plain }", '"extrapolated", "plain"')
        for file in ("solver/sweeps/pair_sweeps.cpp", "solver/run/models_in_use.cpp"):
            self.refused(file, headers, NOT_HANDLED)

    def test_arrangement_of_particles(self):
        headers = with_value("Arrangement { square, hexagonal, fcc }", '"square", "hexagonal", "fcc"')
        for file in ("mesher/lattice.cpp", "mesher/space_lattice.cpp"):
            self.refused(file, headers, NOT_HANDLED)

    def test_fill(self):
        self.refused("mesher/fit_particles.cpp",
                     with_value("FillKind { lattice, relaxed, sampled }", '"lattice", "relaxed", "sampled"'), NOT_HANDLED)

    def test_density_and_stepping_of_viscosity(self):
        for last, name in (("DensityModel { continuity, summation }", '"continuity", "summation"'),
                           ("ViscosityStepping { explicitly, implicitly }",
                            'ViscosityStepping> = std::to_array<std::string_view>({"explicit", "implicit"')):
            self.refused("solver/run/setup.cpp", with_value(last, name), NOT_HANDLED)

    def test_stepping_of_springs(self):
        self.refused("solver/elastic/spring_bodies.cpp",
                     with_value("SpringStepping { implicit, subcycled }", '"implicit", "subcycled"'), NOT_HANDLED)

    def test_stepping_of_species(self):
        self.refused("solver/species/species_transport.cpp",
                     with_value("SpeciesStepping { explicitly, implicitly }",
                                'SpeciesStepping> = std::to_array<std::string_view>({"explicit", "implicit"'), NOT_HANDLED)

    def test_what_is_bonded_to(self):
        self.refused("solver/solidify/solidification.cpp",
                     with_value("BondTo { seed, neighbours }", '"seed", "neighbours"'), NOT_HANDLED)

    def test_list_of_springs_of_a_body(self):
        headers = replaced("solver/elastic/body_parts.hpp",
                           ("    std::vector<Spring<4>> dihedrals;",
                            "    std::vector<Spring<4>> dihedrals;\n    std::vector<Spring<3>> forgotten;"))
        for file in ("body_parts", "body_change", "spring_bodies", "spring_network"):
            self.refused(f"solver/elastic/{file}.cpp", headers, "only 7 names provided")

    def test_model_of_elastic_solids(self):
        self.refused("scene/scene.cpp", with_value("ElasticModel { cells, springs }", '"cells", "springs"'), NOT_HANDLED)

    def test_elastic_law_without_a_tangent(self):
        headers = with_law("models/elastic/elastic_law_list.hpp", "Registry<SaintVenantKirchhoff, ",
                           "models/elastic/elastic_laws.hpp", "/// Returns use(law)", NO_TANGENT)
        self.refused("solver/elastic/implicit_system.cpp", headers, "tangent")

    def test_list_of_springs_of_a_lattice(self):
        headers = replaced("mesher/cell_lattice.hpp", ("    std::vector<Dihedral> dihedrals;",
                                                       "    std::vector<Dihedral> dihedrals, forgotten;"))
        self.refused("mesher/spring_bodies.cpp", headers, "only 5 names provided")

    def test_equation_of_state_without_an_inverse(self):
        headers = with_law("models/sph/fluid_law_list.hpp", "Registry<TaitEquation, ", "models/sph/liquid_state.hpp",
                           "/// Equation of state of a fluid part", NO_INVERSE)
        self.refused("solver/run/setup.cpp", headers, "has no member named 'density'")

    def test_side_of_a_repelling_shape(self):
        self.refused("solver/forcing/driving.cpp",
                     replaced("models/forcing/soft_shape.hpp",
                              ("ShapeSide { both, inside, outside }", "ShapeSide { both, inside, outside, forgotten }")),
                     NOT_HANDLED)

    def measure(self, subject=None):
        headers = replaced(CHOICES, ("    contact\n}", "    contact, forgotten\n}"),
                           ('"contact"}', '"contact", "forgotten"}'))
        if subject:
            case = f"case MeasureKind::forgotten: return MeasureSubject::{subject};"
            headers |= replaced("scene/measure_subject.hpp", ("    switch (kind) {", "    switch (kind) {" + case))
        return headers

    def test_subject_of_a_measure(self):
        self.refused("scene/measure_keys.cpp", self.measure(), NOT_HANDLED)

    def test_columns_of_a_measure(self):
        self.refused("study/measure_columns.cpp", self.measure("flow"), NOT_HANDLED)

    def test_measure_without_a_row(self):
        for subject, file in (("flow", "solver/output/measures.cpp"), ("solids", "solver/output/measures.cpp"),
                              ("species", "solver/output/species_measures.cpp"),
                              ("spheres", "solver/spheres/sphere_measures.cpp")):
            self.refused(file, self.measure(subject), "static assertion failed")

    def test_pull_off_force_of_an_adhesion(self):
        headers = with_law("models/dem/contact_law_list.hpp", "Registry<NoAdhesion, ", "models/dem/contact_laws.hpp",
                           "struct ContactModel {", ADHESION_WITHOUT_PULL_OFF)
        self.refused("solver/spheres/sphere_step.cpp", headers, "'pull_off' is not a member of 'dmp::models::Forgotten'")


if __name__ == "__main__":
    COMPILER = sys.argv[1]
    SYSTEM = [folder for folder in sys.argv[2].split(":") if folder and pathlib.Path(folder) != ROOT]
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
