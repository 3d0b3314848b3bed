// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of bad input: the exact place, what was found and what to do.
#include "tests/modules.hpp"
#include "tests/unit/scene/fault.hpp"

namespace dmp::tests::scene_errors_tests {
namespace {

class BadScene : public testing::TestWithParam<Fault> {};

TEST_P(BadScene, says_where_what_and_what_to_do) {
    EXPECT_EQ(fault_of(scene_with(GetParam().found, GetParam().replacement)), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Scene, BadScene,
    testing::ValuesIn(std::vector<Fault>{
        Fault{"misspelt_key", "spacing = \"0.1 mm\"", "spcing = \"0.1 mm\"",
              "scene.toml:8:1: unknown key 'spcing' in [particles]\n"
              "  did you mean 'spacing' in [particles]?"},
        Fault{"number_without_unit", "spacing = \"0.1 mm\"", "spacing = 0.1",
              "scene.toml:8:11: missing unit: spacing = 0.1, expected a length such as \"0.1 mm\"\n"
              "  write spacing = \"0.1 mm\" or \"0.1 m\", with the unit you mean"},
        Fault{"unquoted_quantity", "spacing = \"0.1 mm\"", "spacing = 0.1 mm",
              "scene.toml:8:15: this is not valid TOML: Error while parsing key-value pair: expected a comment or "
              "whitespace, saw 'm'\n"
              "  correct the line; quantities and names must be in quotes, such as spacing = \"0.1 mm\""},
        Fault{"wrong_dimension", "spacing = \"0.1 mm\"", "spacing = \"3 s\"",
              "scene.toml:8:11: particles.spacing: found \"3 s\" (time), expected a length such as \"0.1 mm\"\n"
              "  give a length for spacing"},
        Fault{"unknown_unit", "spacing = \"0.1 mm\"", "spacing = \"0.1  mn\"",
              "scene.toml:8:17: unknown unit 'mn' in \"0.1  mn\"\n"
              "  did you mean 'mm'?"},
        Fault{"zero_spacing", "spacing = \"0.1 mm\"", "spacing = \"0 mm\"",
              "scene.toml:8:11: particles.spacing: found \"0 mm\", expected more than 0\n"
              "  give a value that is more than 0"},
        Fault{"negative_spacing", "spacing = \"0.1 mm\"", "spacing = \"-1 mm\"",
              "scene.toml:8:11: particles.spacing: found \"-1 mm\", expected more than 0\n"
              "  give a value that is more than 0"},
        Fault{"boolean_for_quantity", "spacing = \"0.1 mm\"", "spacing = true",
              "scene.toml:8:11: particles.spacing: found true (true or false), expected a length such as \"0.1 mm\"\n"
              "  give spacing a length such as \"0.1 mm\""},
        Fault{"list_for_quantity", "spacing = \"0.1 mm\"", "spacing = [1]",
              "scene.toml:8:11: particles.spacing: found a list, expected a length such as \"0.1 mm\"\n"
              "  give spacing a length such as \"0.1 mm\""},
        Fault{"missing_key", "spacing = \"0.1 mm\"", "",
              "scene.toml:7:1: missing key: particles.spacing\n"
              "  add 'spacing' in [particles]: a length such as \"0.1 mm\", more than 0"},
        Fault{"missing_table", "[particles]\nspacing = \"0.1 mm\"", "",
              "scene.toml: missing key: particles.spacing\n"
              "  add 'spacing' in [particles]: a length such as \"0.1 mm\", more than 0"},
        Fault{"misspelt_table", "[particles]", "[partcles]",
              "scene.toml:7:2: unknown key 'partcles'\n"
              "  did you mean [particles]?"},
        Fault{"list_of_tables_for_table", "[particles]", "[[particles]]",
              "scene.toml:7:1: 'particles' is a list, expected a table\n"
              "  write [particles] and its keys below"},
        Fault{"table_for_list_of_tables", "[[part]]", "[part]",
              "scene.toml:16:1: this is not valid TOML: Error while parsing table header: cannot redefine existing "
              "table 'part' as array-of-tables\n"
              "  write each key and table once; only [[part]] and [[measure]], in double brackets, may occur several "
              "times"},
        Fault{"misspelt_list_of_tables", "[[part]]", "[[parts]]",
              "scene.toml:10:3: unknown key 'parts'\n"
              "  did you mean [[part]]?"},
        Fault{"missing_schema", "schema = 1\n", "",
              "scene.toml: missing key: schema\n"
              "  add 'schema' at the top of the file: a whole number, only 1"},
        Fault{"other_schema", "schema = 1", "schema = 2",
              "scene.toml:1:10: schema: found 2, expected 1\n"
              "  this dmp reads schema = 1"},
        Fault{"fourth_dimension", "schema = 1", "schema = 1\ndimension = 4",
              "scene.toml:2:13: dimension: found 4, expected between 2 and 3\n"
              "  give a value that is between 2 and 3"},
        Fault{"text_for_whole_number", "schema = 1", "schema = \"1\"",
              "scene.toml:1:10: schema: found \"1\" (text), expected a whole number, only 1\n"
              "  give schema a whole number, only 1"},
        Fault{"number_for_text", "title = \"Test\"", "title = 7",
              "scene.toml:2:9: title: found 7 (a whole number), expected text\n"
              "  write it in quotes: title = \"7\""},
        Fault{"unlike_key", "title = \"Test\"", "titel = \"T\"",
              "scene.toml:2:1: unknown key 'titel'\n"
              "  did you mean 'title' at the top of the file?"},
        Fault{"key_of_another_table", "title = \"Test\"", "spacing = \"1 mm\"",
              "scene.toml:2:1: unknown key 'spacing'\n"
              "  did you mean 'spacing' in [particles]?"},
        Fault{"misspelt_word", "kind = \"fluid\"", "kind = \"fluids\"",
              "scene.toml:12:8: part.blood.kind: found \"fluids\", expected one of 'fluid', 'rigid', 'elastic', "
              "'spheres', 'plane' and 'surface'\n"
              "  did you mean \"fluid\"?"},
        Fault{"unknown_word", "kind = \"fluid\"", "kind = \"gas\"",
              "scene.toml:12:8: part.blood.kind: found \"gas\", expected one of 'fluid', 'rigid', 'elastic', "
              "'spheres', 'plane' and 'surface'\n"
              "  write one of these names"},
        Fault{"key_of_another_kind", "kind = \"rigid\"", "kind = \"rigid\"\nviscosity = \"1 Pa*s\"",
              "scene.toml:19:1: 'viscosity' does not apply to the part 'wall' of kind 'rigid', only to kind 'fluid'\n"
              "  remove it, or correct the part's kind"},
        Fault{"too_few_layers", "kind = \"rigid\"", "kind = \"rigid\"\nlayers = 0",
              "scene.toml:19:10: part.wall.layers: found 0, expected at least 1\n"
              "  give a value that is at least 1"},
        Fault{"broken_number_of_layers", "kind = \"rigid\"", "kind = \"rigid\"\nlayers = 2.5",
              "scene.toml:19:10: part.wall.layers: found 2.5 (a number), expected a whole number, at least 1\n"
              "  give layers a whole number, at least 1"},
        Fault{"wall_thinner_than_kernel", "kind = \"rigid\"", "kind = \"rigid\"\nlayers = 2",
              "scene.toml:19:10: the wall 'wall' is thinner than the kernel: layers = 2, numerics.support = 3\n"
              "  give the part at least as many layers as the support has spacings"},
        Fault{"sliding_without_unit", "kind = \"rigid\"", "kind = \"rigid\"\nsurface_velocity = [1]",
              "scene.toml:19:21: missing unit: surface_velocity = 1, expected a speed such as \"1 m/s\"\n"
              "  write surface_velocity = \"1 m/s\", with the unit you mean"},
        Fault{"sliding_out_of_the_plane", "kind = \"rigid\"", "kind = \"rigid\"\nsurface_velocity = [0, 0, \"1 m/s\"]",
              "scene.toml:19:20: surface_velocity of 'wall' has a third component in a 2-D scene\n"
              "  leave it out, or write 0"},
        Fault{"wall_that_bends", "kind = \"rigid\"", "kind = \"rigid\"\nvelocity = [\"x / 1 s\", 0]",
              "scene.toml:19:12: velocity of the rigid part 'wall' depends on x, y or z: it would not stay "
              "rigid\n"
              "  give formulas of t; for a surface that slides along itself use surface_velocity"},
        Fault{"spin_by_place", "kind = \"rigid\"", "kind = \"rigid\"\nspin = \"y * 1 rad/m/s\"",
              "scene.toml:19:8: spin of the rigid part 'wall' depends on x, y or z: it would not stay rigid\n"
              "  give formulas of t; for a surface that slides along itself use surface_velocity"},
        Fault{"spin_of_a_length", "kind = \"rigid\"", "kind = \"rigid\"\nspin = \"2 m\"",
              "scene.toml:19:9: part.wall.spin: found \"2 m\" (length), expected a frequency such as \"2 rad/s\"\n"
              "  check the units of its factors: the whole formula must be a frequency"},
        Fault{"slip_that_slides", "kind = \"rigid\"",
              "kind = \"rigid\"\nslip = true\nsurface_velocity = [\"1 m/s\", 0]",
              "scene.toml:20:20: the surface of 'wall' slides, but the fluid slips on it: the motion would have "
              "no effect\n"
              "  leave out surface_velocity, or slip"},
        Fault{"slip_at_plain_walls", "kind = \"rigid\"",
              "kind = \"rigid\"\nslip = true\n[numerics]\nscheme = \"plain\"\nwalls = \"plain\"",
              "scene.toml:19:8: the wall 'wall' has slip = true, and plain walls cannot let a fluid slip\n"
              "  write numerics.walls = \"extrapolated\", or leave out slip"},
        Fault{"plane_across_a_period", "largest_speed = \"0.2 m/s\"",
              "largest_speed = \"0.2 m/s\"\nperiodic = [\"x\"]\nsymmetry = [\"y_low\", \"x_high\"]",
              "scene.toml:30:12: flow.symmetry: 'x_high' is perpendicular to a periodic axis\n"
              "  remove the axis from flow.periodic, or the side from flow.symmetry"},
        Fault{"drive_across_a_plane", "largest_speed = \"0.2 m/s\"",
              "largest_speed = \"0.2 m/s\"\nacceleration = [0, \"1 m/s^2\"]\nsymmetry = [\"y_low\"]",
              "scene.toml:30:12: flow.acceleration pushes across the plane of symmetry 'y_low': the two sides would "
              "not be "
              "alike\n  leave out that component, or the side"},
        Fault{"unknown_side", "largest_speed = \"0.2 m/s\"", "largest_speed = \"0.2 m/s\"\nsymmetry = [\"bottom\"]",
              "scene.toml:29:13: flow.symmetry: found \"bottom\", expected one of 'x_low', 'x_high', 'y_low', "
              "'y_high', 'z_low' and 'z_high'\n  write one of these names"},
        Fault{"springs_of_three_layers", "kind = \"elastic\"", "kind = \"elastic\"\nlayers = 3",
              "scene.toml:23:10: part.leaflets.layers: found 3, expected 2\n"
              "  the rows of an elastic solid follow from its thickness: leave layers out, or write 2"},
        Fault{"springs_as_stiff_as_a_strip_and_as_a_material", "axial_stiffness = \"100 N\"",
              "axial_stiffness = \"100 N\"\nyoungs_modulus = \"2 MPa\"",
              "scene.toml:25:18: part 'leaflets' has its stiffness twice: as a strip, at scene.toml:23:21, and as a "
              "material\n"
              "  give bending_stiffness and axial_stiffness, or youngs_modulus, thickness and poisson_ratio"},
        Fault{"springs_without_axial_stiffness", "axial_stiffness = \"100 N\"\n", "",
              "scene.toml:21:8: part 'leaflets': axial_stiffness is missing\n"
              "  add axial_stiffness, or give youngs_modulus and thickness instead"},
        Fault{"springs_without_thickness", "bending_stiffness = \"3e-6 N*m^2\"\naxial_stiffness = \"100 N\"",
              "youngs_modulus = \"2 MPa\"",
              "scene.toml:21:8: part 'leaflets': thickness is missing\n"
              "  add thickness, or give bending_stiffness and axial_stiffness"},
        Fault{"springs_without_stiffness", "bending_stiffness = \"3e-6 N*m^2\"\naxial_stiffness = \"100 N\"\n", "",
              "scene.toml:21:8: part 'leaflets' does not say how stiff it is\n"
              "  give bending_stiffness and axial_stiffness, or youngs_modulus and thickness"},
        Fault{"missing_key_of_kind", "viscosity = \"3.5 mPa*s\"", "",
              "scene.toml:10:1: missing key: part.blood.viscosity\n"
              "  add 'viscosity' in [[part]]: a dynamic viscosity such as \"1 mPa*s\", at least 0"},
        Fault{"repeated_part_name", "name = \"wall\"", "name = \"blood\"",
              "scene.toml:17:8: there is already a part called 'blood', at scene.toml:11:8\n"
              "  give each part its own name"},
        Fault{"name_with_a_space", "name = \"wall\"", "name = \"the wall\"",
              "scene.toml:17:8: part.name: found \"the wall\", expected a name of letters, digits and '_' that starts "
              "with a letter\n"
              "  write a name such as \"inner_wall\""},
        Fault{"missing_name", "name = \"wall\"\n", "",
              "scene.toml:16:1: missing key: part.name\n"
              "  add 'name' in [[part]]: a name of letters, digits and '_'"},
        Fault{"misspelt_reference", "part = \"leaflets\"", "part = \"leaflet\"",
              "scene.toml:45:8: the scene has no part 'leaflet'\n"
              "  did you mean 'leaflets'?"},
        Fault{"reference_to_another_kind", "part = \"leaflets\"", "part = \"wall\"",
              "scene.toml:45:8: part 'wall' is of kind 'rigid', expected 'elastic'\n"
              "  gap is measured of elastic solids; the scene has 'leaflets'"},
        Fault{"missing_reference", "part = \"leaflets\"", "",
              "scene.toml:42:1: missing key: measure.tip_gap.part\n"
              "  add 'part' in [[measure]]: a name of letters, digits and '_'"},
        Fault{"repeated_measure_name", "name = \"tip_gap\"", "name = \"flux_in\"",
              "scene.toml:43:8: there is already a measure called 'flux_in', at scene.toml:37:8\n"
              "  give each measure its own name"},
        Fault{"missing_largest_speed", "largest_speed = \"0.2 m/s\"", "",
              "scene.toml:27:1: flow.largest_speed is missing: numerics.sound_speed = \"auto\" depends on it\n"
              "  add largest_speed = \"0.2 m/s\" (the largest speed you expect) to [flow], or give a sound_speed"},
        Fault{"formula_without_brackets", "largest_speed = \"0.2 m/s\"",
              "largest_speed = \"0.2 m/s\"\nacceleration = \"1 m/s^2\"",
              "scene.toml:29:16: flow.acceleration: found \"1 m/s^2\" (text), expected a list of one to three "
              "formulas, each an acceleration such as \"0.1 m/s^2\" or 0\n"
              "  put it in brackets: acceleration = [ ... ]"},
        Fault{"formula_without_unit", "largest_speed = \"0.2 m/s\"",
              "largest_speed = \"0.2 m/s\"\nacceleration = [0.5]",
              "scene.toml:29:17: missing unit: acceleration = 0.5, expected an acceleration such as \"0.1 m/s^2\"\n"
              "  write acceleration = \"0.5 m/s^2\", with the unit you mean"},
        Fault{"fault_inside_a_formula", "largest_speed = \"0.2 m/s\"",
              "largest_speed = \"0.2 m/s\"\nacceleration = [0, \"1 m/s^2 * sin(t)\"]",
              "scene.toml:29:35: sin is given a time, expected a plain number in \"1 m/s^2 * sin(t)\"\n"
              "  divide it by a quantity of the same dimension, such as 1 s"},
        Fault{"third_component", "largest_speed = \"0.2 m/s\"",
              "largest_speed = \"0.2 m/s\"\nacceleration = [0, 0, \"1 m/s^2\"]",
              "scene.toml:29:23: flow.acceleration has a third component in a 2-D scene\n"
              "  leave it out, or write 0"},
        Fault{
            "gradient_of_another_dimension", "largest_speed = \"0.2 m/s\"",
            "largest_speed = \"0.2 m/s\"\nperiodic = [\"x\"]\npressure_gradient = [\"-100 Pa\", 0]",
            "scene.toml:30:23: flow.pressure_gradient: found \"-100 Pa\" (pressure), expected a pressure gradient such "
            "as \"-100 Pa/m\"\n  check the units of its factors: the whole formula must be a pressure gradient"},
        Fault{"gradient_without_unit", "largest_speed = \"0.2 m/s\"",
              "largest_speed = \"0.2 m/s\"\nperiodic = [\"x\"]\npressure_gradient = [-100, 0]",
              "scene.toml:30:22: missing unit: pressure_gradient = -100, expected a pressure gradient such as \"-100 "
              "Pa/m\"\n  write pressure_gradient = \"-100 Pa/m\", with the unit you mean"},
        Fault{
            "gradient_along_no_period", "largest_speed = \"0.2 m/s\"",
            "largest_speed = \"0.2 m/s\"\nperiodic = [\"x\"]\npressure_gradient = [0, \"-100 Pa/m\"]",
            "scene.toml:30:25: flow.pressure_gradient acts along y, which is not periodic: walls there balance it, and "
            "nothing flows\n"
            "  add \"y\" to flow.periodic, or leave the component out; gravity is flow.acceleration"},
        Fault{"gradient_by_place", "largest_speed = \"0.2 m/s\"",
              "largest_speed = \"0.2 m/s\"\nperiodic = [\"x\"]\npressure_gradient = [\"-1 Pa/m * y / 1 mm\", 0]",
              "scene.toml:30:22: flow.pressure_gradient depends on x, y or z: \"-1 Pa/m * y / 1 mm\"\n"
              "  write formulas of t: it is the mean over the period; a force that depends on position is "
              "flow.acceleration or a [[force]]"},
        Fault{"gradient_out_of_the_plane", "largest_speed = \"0.2 m/s\"",
              "largest_speed = \"0.2 m/s\"\nperiodic = [\"x\"]\npressure_gradient = [0, 0, \"-1 Pa/m\"]",
              "scene.toml:30:28: flow.pressure_gradient has a third component in a 2-D scene\n"
              "  leave it out, or write 0"},
        Fault{"no_component", "largest_speed = \"0.2 m/s\"", "largest_speed = \"0.2 m/s\"\nacceleration = []",
              "scene.toml:29:16: flow.acceleration: found a list of 0, expected one to three formulas\n"
              "  write acceleration = [x, y], such as [\"0.1 m/s^2\", 0]"},
        Fault{"third_component_of_the_starting_velocity", "largest_speed = \"0.2 m/s\"",
              "largest_speed = \"0.2 m/s\"\ninitial_velocity = [0, 0, \"1 m/s\"]",
              "scene.toml:29:27: flow.initial_velocity has a third component in a 2-D scene\n"
              "  leave it out, or write 0"},
        Fault{"starting_velocity_of_another_dimension", "largest_speed = \"0.2 m/s\"",
              "largest_speed = \"0.2 m/s\"\ninitial_velocity = [\"1 m * x\", 0]",
              "scene.toml:29:22: flow.initial_velocity: found \"1 m * x\" (area), expected a speed such as "
              "\"0.1 m/s\"\n  check the units of its factors: the whole formula must be a speed"},
        Fault{"starting_velocity_in_time", "largest_speed = \"0.2 m/s\"",
              "largest_speed = \"0.2 m/s\"\ninitial_velocity = [0, \"1 m/s * sin(t / 1 s)\"]",
              "scene.toml:29:20: flow.initial_velocity depends on t: \"1 m/s * sin(t / 1 s)\"\n"
              "  write a formula of x, y and z: initial values do not depend on time"},
        Fault{"starting_pressure_in_time", "largest_speed = \"0.2 m/s\"",
              "largest_speed = \"0.2 m/s\"\ninitial_pressure = \"1 Pa/s * t\"",
              "scene.toml:29:20: flow.initial_pressure depends on t: \"1 Pa/s * t\"\n"
              "  write a formula of x, y and z: initial values do not depend on time"},
        Fault{"starting_pressure_without_unit", "largest_speed = \"0.2 m/s\"",
              "largest_speed = \"0.2 m/s\"\ninitial_pressure = 3",
              "scene.toml:29:20: missing unit: initial_pressure = 3, expected a pressure such as \"100 Pa\"\n"
              "  write initial_pressure = \"3 Pa\", with the unit you mean"},
        Fault{"too_much_disorder", "spacing = \"0.1 mm\"", "spacing = \"0.1 mm\"\ndisorder = 0.6",
              "scene.toml:9:12: particles.disorder: found 0.6, expected between 0 and 0.4\n"
              "  give a value that is between 0 and 0.4"},
        Fault{"negative_seed", "spacing = \"0.1 mm\"", "spacing = \"0.1 mm\"\nseed = -1",
              "scene.toml:9:8: particles.seed: found -1, expected at least 0\n"
              "  give a value that is at least 0"},
        Fault{"third_axis", "largest_speed = \"0.2 m/s\"", "largest_speed = \"0.2 m/s\"\nperiodic = [\"z\"]",
              "scene.toml:29:13: flow.periodic: a scene in 2-D has no axis 'z'\n"
              "  give 'x' and 'y' only, or write dimension = 3"},
        Fault{"repeated_axis", "largest_speed = \"0.2 m/s\"", "largest_speed = \"0.2 m/s\"\nperiodic = [\"x\", \"x\"]",
              "scene.toml:29:18: flow.periodic: \"x\" occurs twice\n"
              "  remove one of them"},
        Fault{"misspelt_auto", "[run]", "[numerics]\nsound_speed = \"atuo\"\n[run]",
              "scene.toml:31:15: numerics.sound_speed: found \"atuo\" (text), expected \"auto\" or a speed such as \"2 "
              "m/s\", more than 0\n"
              "  give sound_speed \"auto\" or a speed such as \"2 m/s\", more than 0"},
        Fault{"auto_or_quantity_without_unit", "[run]", "[numerics]\nsound_speed = 20\n[run]",
              "scene.toml:31:15: missing unit: sound_speed = 20, expected a speed such as \"2 m/s\"\n"
              "  write sound_speed = \"20 m/s\", with the unit you mean"},
        Fault{"zero_for_auto", "[run]", "[numerics]\nsound_speed = 0\n[run]",
              "scene.toml:31:15: numerics.sound_speed: found 0, expected more than 0\n"
              "  write \"auto\" or a value that is more than 0"},
        Fault{"support_too_small", "[run]", "[numerics]\nsupport = 1.5\n[run]",
              "scene.toml:31:11: numerics.support: found 1.5, expected between 2 and 6\n"
              "  give a value that is between 2 and 6"},
        Fault{"text_for_number", "[run]", "[numerics]\nsupport = \"3\"\n[run]",
              "scene.toml:31:11: numerics.support: found \"3\" (text), expected a number, between 2 and 6\n"
              "  write the number without quotes and unit"},
        Fault{"not_a_number", "[run]", "[numerics]\nsupport = nan\n[run]",
              "scene.toml:31:11: numerics.support: found nan (a number), expected a finite number\n"
              "  give support a finite number"},
        Fault{"support_beyond_the_default_wall", "[run]", "[numerics]\nsupport = 3.5\n[run]",
              "scene.toml:31:11: the wall 'wall' is thinner than the kernel: layers = 3, numerics.support = 3.5\n"
              "  give the part at least as many layers as the support has spacings"},
        Fault{"loose_viscosity_tolerance", "[run]", "[numerics]\nviscosity_tolerance = 0.1\n[run]",
              "scene.toml:31:23: numerics.viscosity_tolerance: found 0.1, expected between 1e-14 and 0.01\n"
              "  give a value that is between 1e-14 and 0.01"},
        Fault{"unknown_viscosity_stepping", "[run]", "[numerics]\nviscosity_stepping = \"implicitly\"\n[run]",
              "scene.toml:31:22: numerics.viscosity_stepping: found \"implicitly\", expected one of 'explicit' and "
              "'implicit'\n"
              "  did you mean \"implicit\"?"},
        Fault{"background_below_zero", "[run]", "[numerics]\nbackground_pressure = \"-1 Pa\"\n[run]",
              "scene.toml:31:23: numerics.background_pressure: found \"-1 Pa\", expected at least 0\n"
              "  give a value that is at least 0"},
        Fault{"unknown_viscous_law", "[run]", "[numerics]\nviscous_law = \"moris\"\n[run]",
              "scene.toml:31:15: numerics.viscous_law: found \"moris\", expected one of 'morris', 'monaghan', "
              "'monaghan_approaching', 'cleary' and 'newtonian'\n"
              "  did you mean \"morris\"?"},
        Fault{"more_than_a_fraction", "[run]", "[numerics]\nstep_factor = 2\n[run]",
              "scene.toml:31:15: numerics.step_factor: found 2, expected more than 0 and at most 1\n"
              "  give a value that is more than 0 and at most 1"},
        Fault{"negative_threads", "[run]", "[run]\nthreads = -1",
              "scene.toml:31:11: run.threads: found -1, expected at least 0\n"
              "  give a value that is at least 0"},
        Fault{"negative_duration", "duration = \"4 s\"", "duration = \"-4 s\"",
              "scene.toml:31:12: run.duration: found \"-4 s\", expected more than 0\n"
              "  give a value that is more than 0"},
        Fault{"date_for_duration", "duration = \"4 s\"", "duration = 2020-01-01",
              "scene.toml:31:12: run.duration: found 2020-01-01 (a date), expected a time such as \"4 s\"\n"
              "  give duration a time such as \"4 s\""},
        Fault{"no_time_between_frames", "every = \"20 ms\"", "every = 0",
              "scene.toml:34:9: output.every: found 0, expected more than 0\n"
              "  give a value that is more than 0"},
        Fault{"misspelt_item", "every = \"20 ms\"", "every = \"20 ms\"\nfields = [\"presure\"]",
              "scene.toml:35:11: output.fields: found \"presure\", expected one of 'velocity', 'pressure', 'density', "
              "'shear_stress', 'stress', 'von_mises', 'vorticity', 'residence_time' and 'concentration'\n"
              "  did you mean \"pressure\"?"},
        Fault{"item_without_brackets", "every = \"20 ms\"", "every = \"20 ms\"\nfields = \"pressure\"",
              "scene.toml:35:10: output.fields: found \"pressure\" (text), expected a list of any of 'velocity', "
              "'pressure', 'density', 'shear_stress', 'stress', 'von_mises', 'vorticity', 'residence_time' and "
              "'concentration'\n"
              "  put it in brackets: fields = [ ... ]"},
        Fault{"repeated_item", "every = \"20 ms\"", "every = \"20 ms\"\nfields = [\"pressure\", \"pressure\"]",
              "scene.toml:35:23: output.fields: \"pressure\" occurs twice\n"
              "  remove one of them"},
        Fault{"text_for_boolean", "every = \"20 ms\"", "every = \"20 ms\"\npictures = \"yes\"",
              "scene.toml:35:12: output.pictures: found \"yes\" (text), expected true or false\n"
              "  write true or false, without quotes"},
        Fault{"point_of_one_length", "from = [\"0 mm\", \"-4 mm\"]", "from = [\"0 mm\"]",
              "scene.toml:39:8: measure.flux_in.from: found a list of 1, expected two or three lengths\n"
              "  write from = [x, y], such as [\"1 mm\", 0]"},
        Fault{"point_without_unit", "from = [\"0 mm\", \"-4 mm\"]", "from = [\"0 mm\", 4]",
              "scene.toml:39:17: missing unit: from = 4, expected a length such as \"1 mm\"\n"
              "  write from = \"4 mm\" or \"4 m\", with the unit you mean"},
        Fault{"line_without_length", "from = [\"0 mm\", \"-4 mm\"]", "from = [\"0 mm\", \"4 mm\"]",
              "scene.toml:40:6: the line of measure 'flux_in' starts and ends at the same point\n"
              "  give two different points"},
        Fault{"no_wave", "kind = \"flux\"\nfrom = [\"0 mm\", \"-4 mm\"]\nto = [\"0 mm\", \"4 mm\"]",
              "kind = \"mode\"\nwaves = [0, 0]",
              "scene.toml:39:9: measure.flux_in.waves: found no wave along any axis\n"
              "  give a list of two or three whole numbers such as [1, 0]"},
        Fault{"wave_along_a_wall", "kind = \"flux\"\nfrom = [\"0 mm\", \"-4 mm\"]\nto = [\"0 mm\", \"4 mm\"]",
              "kind = \"mode\"\nwaves = [1, 0]",
              "scene.toml:39:9: measure 'flux_in' has waves along x, which is not periodic\n"
              "  write 0 there, or add \"x\" to flow.periodic"},
        Fault{"half_a_wave", "kind = \"flux\"\nfrom = [\"0 mm\", \"-4 mm\"]\nto = [\"0 mm\", \"4 mm\"]",
              "kind = \"mode\"\nwaves = [0.5, 0]",
              "scene.toml:39:10: measure.flux_in.waves: found 0.5 (a number), expected a whole number\n"
              "  give waves a whole number"},
        Fault{"third_coordinate", "from = [\"0 mm\", \"-4 mm\"]", "from = [\"0 mm\", \"4 mm\", \"1 mm\"]",
              "scene.toml:39:8: the third coordinate of a point in a 2-D scene is not 0\n"
              "  leave it out, or write 0"},
        Fault{"empty_file", "file = \"channel.geo\"", "file = \"\"",
              "scene.toml:5:8: geometry.file: found \"\", expected text\n"
              "  write some text, or remove the key"},
        Fault{"parameter_of_another_dimension", "file = \"channel.geo\"",
              "file = \"channel.geo\"\nparameters = { a = \"3 s\" }",
              "scene.toml:6:20: geometry.parameters.a: found \"3 s\" (time), expected a length, an angle or a plain "
              "number\n"
              "  other units are not possible: give a length such as \"2 mm\""},
        Fault{"boolean_parameter", "file = \"channel.geo\"", "file = \"channel.geo\"\nparameters = { a = true }",
              "scene.toml:6:20: geometry.parameters.a: found true (true or false), expected a length, an angle or a "
              "plain number\n"
              "  give a a length, an angle or a plain number"},
        Fault{"number_for_parameters", "file = \"channel.geo\"", "file = \"channel.geo\"\nparameters = 3",
              "scene.toml:6:14: geometry.parameters: found 3 (a whole number), expected a table such as { width = \"2 "
              "mm\", angle = \"30 deg\", count = 3 }\n"
              "  give parameters a table such as { width = \"2 mm\", angle = \"30 deg\", count = 3 }"},
        Fault{"escaped_text", "file = \"channel.geo\"", "file = \"channel.geo\"\nunit = \"\\u0031 s\"",
              "scene.toml:6:8: geometry.unit: found \"1 s\" (time), expected a length such as \"1 mm\"\n"
              "  give a length for unit"},
        Fault{"unknown_table", "[run]", "[foo]\n[run]",
              "scene.toml:30:2: unknown key 'foo'\n"
              "  a scene has 'schema', 'title', 'dimension' and 'quality' and the tables [geometry], [[select]], "
              "[particles], "
              "[[part]], [[join]], [[contact_pair]], [box], "
              "[flow], [contact], [numerics], [run], [output], [[species]], [[force]], [[moving_shape]], [[region]], "
              "[[measure]], [[reference]], [[solidify]], [[break]]"}}),
    name_of);

TEST(PressureGradient, without_a_fluid_is_refused) {
    std::string text = good_scene;
    const auto from = text.find("[[part]]"), to = text.find("[[part]]", from + 1);
    text.erase(from, to - from);
    EXPECT_EQ(
        fault_of(text + "\n[numerics]\nsound_speed = \"1 m/s\"\n",
                 {"flow.periodic=[\"x\"]", "flow.pressure_gradient=[\"-1 Pa/m\", 0]"}),
        "--set flow.pressure_gradient=[\"-1 Pa/m\", 0]: flow.pressure_gradient drives a fluid, and no part is one\n"
        "  leave it out, or push with flow.acceleration or a [[force]]");
}

}  // namespace
}  // namespace dmp::tests::scene_errors_tests
