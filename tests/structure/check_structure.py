#!/usr/bin/env python3
# Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Checks what docs/architecture.md says of the source tree.

Includes: a module includes only the modules that it may, the folders of solver/, models/ and cli/ and the files beside
them include each other in one direction, and gmsh, CGAL, VTK, MPI, Zoltan and HDF5 are included in the one place that may.
Choices: a switch over an enumeration lists its values, and each choice of a scene has such a switch. Keys: each key of a
scene is read by the program. Particles: all that a set has is hashed, stored and handed to other ranks. Words: names, keys,
texts and docs do without the words that CONTRIBUTING.md has replaced. Files: none is longer than 450 lines, and nothing binary lies at the root.
"""
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODULES = {  # module: what it may include besides base and itself
    "base": [],
    "models": [],
    "scene": ["models"],
    "study": ["models", "scene"],
    "geometry": [],
    "particles": [],
    "mesher": ["geometry", "models", "particles", "scene"],
    "solver": ["models", "particles", "scene"],
    "postproc": ["models", "particles", "scene", "solver"],
    "report": ["postproc", "solver"],
    "cli": ["geometry", "mesher", "models", "particles", "postproc", "report", "scene", "solver", "study"],
}
LIBRARIES = {  # header pattern: the only folders that may include it
    r"<gmsh": ["geometry"],
    r"<CGAL/": ["geometry"],
    r"<vtk": ["postproc"],
    r"<mpi\.h": ["solver/parallel", "solver/domain"],
    r"<zoltan": ["solver/domain"],
    r"<hdf5": ["base"],
}
DEFAULT_ALLOWED_IN = {  # switches with a `default:`, which a new value of an enumeration would fall into in silence
    "geometry/surface_intersections.cpp",  # over a number
}
WITHOUT_SWITCH = {"BoxSide", "Axis", "Form"}  # numbers with names; a paper's equations as printed and corrected
PARTICLES_NOT_IN = {  # file: members of a particle set that it need not name
    "particles/fingerprint.cpp": {"mass", "velocity", "angular_velocity"},  # they follow from the scene (its header)
    "particles/particle_file.cpp, particles/cells_in_file.cpp": set(),
    "solver/store/share_particles.cpp": set(),
}
SPRINGS_IN = ["solver/elastic/body_parts.cpp", "cli/particle_input.cpp"]  # files that need only its springs
KEYS_ONLY_CHECKED = {"schema"}  # its value is a version, and nothing depends on it once it is known to be 1
# Word boundaries are those of identifiers and of English.
OLD_WORDS = [
    r"\bWandering\b", r"\bPlacesThen\b", r"\bNearSweep\b", r"\blook_through\b", r"\bkeep_near\b", r"\bOrderFree\b",
    r"\border_free\b", r"\btake_note\b", r"\blooks_at\b", r"\bMisdeeds?\b", r"\bmisdeeds?\b", r"\bStillness\b",
    r"\buntil_still\b", r"\bparting\b", r"\bgripping\b", r"\bgrip\b", r"\bSpeciesAlong\b", r"\bspecies_along\b",
    r"\bstratified\b", r"thesis_eq", r"\bEncounter\b", r"\bencounters?\b", r"\bDice\b", r"\bdice\b",
    r"\bin the plane\b(?! (of|x|y|z)\b)", r"\bin space\b", r"\bParticleKind\b", r"\bsprings parts?\b",
    r"\bkind = .?[\"']springs", r"\baccuracy\.[a-z_]+\b(?<!accuracy\.md)",
]
# Words that have another, ordinary meaning elsewhere: checked where only the old one can be meant.
OLD_WORDS_IN = {
    r"\b[Dd]rawings?\b": lambda name: "postproc" not in name,
    r"\brooms?\b": lambda name: name.endswith((".md", "CMakeLists.txt", ".cmake")),
}
WORDS_ALLOWED_IN = {  # files that must name old words: what is refused with its new name, and this list
    "scene/renamed.cpp", "scene/renamed.hpp", "CHANGELOG.md", "tests/structure/check_structure.py",
    "tests/unit/scene/scene_renamed.cpp", "LICENSE", "CONTRIBUTING.md",
}


def sources(*suffixes):
    for folder in [*MODULES, "bench", "tests", "docs", "cases", "cmake", "."]:
        paths = (ROOT / folder).glob("*") if folder == "." else (ROOT / folder).rglob("*")
        for path in paths:
            if path.is_file() and path.suffix in suffixes:
                yield path, path.relative_to(ROOT).as_posix()


def includes(path):
    return re.findall(r'^\s*#\s*include\s+(["<][^">]+)', path.read_text(), flags=re.M)


def cycle_in(graph):
    """A list of nodes that form a cycle, or []."""
    done, on_path = set(), []

    def visit(node):
        if node in on_path:
            return on_path[on_path.index(node):] + [node]
        if node in done:
            return []
        on_path.append(node)
        for other in sorted(graph.get(node, ())):
            found = visit(other)
            if found:
                return found
        on_path.pop()
        done.add(node)
        return []

    for node in sorted(graph):
        found = visit(node)
        if found:
            return found
    return []


def folder_graph(module, files):
    """Which folder of a module includes which. A file at its root counts as a folder of its own, header and source
    together. `files`: name -> what it includes."""

    def folder_of(name):
        parts = name.split("/")
        if parts[0] != module or len(parts) < 2:
            return None
        return parts[1] if len(parts) > 2 else pathlib.PurePath(parts[1]).stem

    graph = {}
    for name, included in files.items():
        folder = folder_of(name)
        others = {folder_of(file[1:]) for file in included if file[0] == '"'} - {None, folder}
        if folder is not None and others:
            graph.setdefault(folder, set()).update(others)
    return graph


class Includes(unittest.TestCase):
    def test_modules_include_only_those_before_them(self):
        wrong = []
        for path, name in sources(".hpp", ".cpp"):
            module = name.split("/")[0]
            if module not in MODULES:
                continue
            for included in includes(path):
                other = included[1:].split("/")[0]
                if included[0] == '"' and other in MODULES and other not in ["base", module, *MODULES[module]]:
                    wrong.append(f"{name} includes {included[1:]}")
        self.assertEqual(wrong, [])

    def test_folders_of_a_module_have_no_cycle(self):
        files = {name: includes(path) for path, name in sources(".hpp", ".cpp")}
        for module in ("solver", "models", "cli"):
            self.assertEqual(cycle_in(folder_graph(module, files)), [], module)

    def test_a_cycle_through_a_file_at_the_root_is_found(self):
        files = {
            "solver/simulation.hpp": ['"solver/time/run.hpp'],
            "solver/simulation.cpp": ['"solver/simulation.hpp', '"solver/run/fluid_run.hpp'],
            "solver/run/model_costs.cpp": ['"solver/simulation.hpp', "<cmath"],
        }
        self.assertEqual(folder_graph("solver", files), {"simulation": {"time", "run"}, "run": {"simulation"}})
        self.assertEqual(cycle_in(folder_graph("solver", files)), ["run", "simulation", "run"])

    def test_a_cycle_is_found(self):
        self.assertEqual(cycle_in({"a": {"b"}, "b": {"c"}, "c": {"b"}}), ["b", "c", "b"])
        self.assertEqual(cycle_in({"a": {"b", "c"}, "b": {"c"}}), [])

    def test_foreign_libraries_stay_where_they_belong(self):
        wrong = []
        for path, name in sources(".hpp", ".cpp"):
            if name.split("/")[0] not in MODULES:
                continue
            for included in includes(path):
                for pattern, folders in LIBRARIES.items():
                    if re.match(pattern, included) and not any(name.startswith(folder + "/") for folder in folders):
                        wrong.append(f"{name} includes {included[1:]}")
        self.assertEqual(wrong, [])


class Choices(unittest.TestCase):
    def test_switches_name_every_value(self):
        found = [
            name
            for path, name in sources(".hpp", ".cpp")
            if name.split("/")[0] in MODULES and re.search(r"^\s*default:", path.read_text(), flags=re.M)
        ]
        self.assertEqual(sorted(set(found) - DEFAULT_ALLOWED_IN), [], "list the values instead (-Wswitch)")
        self.assertEqual(sorted(DEFAULT_ALLOWED_IN - set(found)), [], "no longer has one")

    def test_each_choice_has_a_switch(self):
        choices, cases = set(), set()
        for path, name in sources(".hpp", ".cpp"):
            if name.split("/")[0] not in MODULES:
                continue
            if name == "scene/choices.hpp" or name.startswith("models/"):
                choices |= set(re.findall(r"enum class (\w+)", path.read_text()))
            cases |= switched(path.read_text())
        self.assertGreater(len(choices), 20)
        self.assertEqual(sorted(choices - cases - WITHOUT_SWITCH), [], "a new value would be taken for one of the old")

    def test_a_choice_without_a_switch_is_found(self):
        self.assertEqual(switched("  case scene::Side::low:\n  case Kind::a: if (x == Fill::b)"), {"Side", "Kind"})


def switched(text):
    """The enumerations whose values are cases of a switch."""
    return set(re.findall(r"\bcase (?:\w+::)*(\w+)::\w+:", text))


def members_of(struct, text):
    """(type, name) of the data members of a struct without nested braces in their initial values."""
    body = re.search(rf"^struct {struct}\b.*?^}};", text, flags=re.M | re.S)[0]
    body = re.sub(r"^    struct .*?^    };", "", body, flags=re.M | re.S)
    return re.findall(r"^    (\w[\w:<>, ]*?) (\w+)(?:\{\}| = [^;(]+)?;", body, flags=re.M)


def not_named(members, text):
    return sorted(set(members) - set(re.findall(r"(?:\.|->)(\w+)", text)))


class Particles(unittest.TestCase):
    def members(self):
        text = (ROOT / "particles/particle_set.hpp").read_text()
        return members_of("ParticleSpace", text) + members_of("ParticleSet", text)

    def test_all_of_a_set_is_hashed_stored_and_shared(self):
        members = [name for _, name in self.members()]
        self.assertGreater(len(members), 20)
        for file, not_there in PARTICLES_NOT_IN.items():
            text = "".join((ROOT / each).read_text() for each in file.split(", "))
            missing = not_named(set(members) - not_there, text)
            self.assertEqual(missing, [], f"{file} does not name these members of a particle set")

    def test_all_springs_are_taken(self):
        text = (ROOT / "particles/particle_set.hpp").read_text()
        kinds = [kind for kind in re.findall(r"^struct (\w+)", text, flags=re.M)
                 if ("double", "stiffness") in members_of(kind, text)]
        springs = [name for of, name in self.members() if of in [f"std::vector<{kind}>" for kind in kinds]]
        self.assertGreaterEqual(len(springs), 3)
        for file in SPRINGS_IN:
            self.assertEqual(not_named(springs, (ROOT / file).read_text()), [], file)

    def test_a_forgotten_member_is_found(self):
        text = "struct Set : Space {\n    int size = 0;  ///< [m]\n    std::vector<Bond> bonds;\n    bool none() const;\n};\n"
        self.assertEqual(members_of("Set", text), [("int", "size"), ("std::vector<Bond>", "bonds")])
        self.assertEqual(not_named(["size", "bonds"], "hash.add(set.size)"), ["bonds"])


def rows_of_keys(text):
    """(key, member) of each row of a table of keys: {"viscosity", liquids, &Part::viscosity, ...}"""
    return re.findall(r'\{"(\w+)",[^&\n]*&\w+::(\w+),', text)


def unread(rows, text):
    """The keys whose members the text does not read."""
    read = set(re.findall(r"(?:\.|->)(\w+)", text))
    return [key for key, member in rows if member not in read]


class Keys(unittest.TestCase):
    def test_every_key_of_a_scene_is_read(self):
        tables, others = [], []
        for path, name in sources(".cpp", ".hpp"):
            module, file = name.split("/")[0], name.rsplit("/")[-1]
            if module not in MODULES or (module == "scene" and file.endswith("checks.cpp")):
                continue  # a value that is only checked has no effect
            is_table = module == "scene" and (file == "schema.cpp" or file.endswith("keys.cpp"))
            (tables if is_table else others).append(path.read_text())
        rows = [row for table in tables for row in rows_of_keys(table)]
        self.assertGreater(len(rows), 200)
        found = [key for key in unread(rows, "\n".join(others)) if key not in KEYS_ONLY_CHECKED]
        self.assertEqual(found, [], "keys of a scene that nothing reads")

    def test_a_forgotten_key_is_found(self):
        rows = rows_of_keys('{"depth", all, &Part::depth, length(), required, "..."},\n{"mass", &Part::mass, x, "y"},')
        self.assertEqual(rows, [("depth", "depth"), ("mass", "mass")])
        self.assertEqual(unread(rows, "double m = part.mass * part->mass; depth"), ["depth"])


class Texts(unittest.TestCase):
    def test_replaced_words_are_gone(self):
        wrong = []
        for path, name in sources(".hpp", ".cpp", ".md", ".toml", ".geo", ".txt", ".cmake", ".py"):
            if name in WORDS_ALLOWED_IN:
                continue
            for number, line in enumerate(path.read_text().split("\n"), 1):
                for word in [*OLD_WORDS, *(w for w, applies in OLD_WORDS_IN.items() if applies(name))]:
                    found = re.search(word, line)
                    if found:
                        wrong.append(f"{name}:{number}: '{found[0]}'")
        self.assertEqual(wrong, [], f"{len(wrong)} places")

    def test_files_are_read_in_one_sitting(self):
        long = [
            f"{name}: {lines} lines"
            for path, name in sources(".hpp", ".cpp")
            if (lines := path.read_text().count("\n")) > 450
        ]
        self.assertEqual(long, [])

    def test_headers_are_more_than_a_line(self):
        pass_through = [
            name
            for path, name in sources(".hpp")
            if re.sub(r'//[^\n]*|#pragma once|#include[^\n]*|\s', "", path.read_text()) == ""
        ]
        self.assertEqual(pass_through, [])

    def test_nothing_binary_lies_at_the_root(self):
        binary = [path.name for path in ROOT.iterdir() if path.is_file() and b"\0" in path.read_bytes()[:8192]]
        self.assertEqual(binary, [])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[1:]])
