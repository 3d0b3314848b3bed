// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of spheres: where they are put, what is said of it, and what is refused.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "mesher/mesh_spheres.hpp"
#include "mesher/sphere_packing.hpp"
#include "particles/touching_spheres.hpp"
#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"

namespace dmp::tests::sphere_meshes_tests {
namespace {

using ::testing::HasSubstr;

const std::string head = "schema = 1\ndimension = 3\n[run]\nduration = \"1 s\"\n[output]\nevery = \"1 s\"\n";
const std::string elastic = "[[contact_pair]]\nparts = [\"any\", \"any\"]\nrestitution = 1\nfriction = 0\n";

std::string spheres(const std::string& name, const std::string& keys) {
    return "[[part]]\nname = \"" + name +
           "\"\nkind = \"spheres\"\nyoungs_modulus = \"1 GPa\"\npoisson_ratio = 0.25\ndensity = \"1000 kg/m^3\"\n" +
           keys + "\n";
}

MeshResult meshed(const std::string& text, const std::string& table = "") {
    const Folder folder;
    Folder::write(text);
    Folder::write(table, "table.csv");
    return mesh_spheres(read_scene("scene.toml"));
}

std::string fault(const std::string& text, const std::string& table = "") {
    try {
        meshed(text, table);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Coverage, is_that_of_ariane_2018) {
    // 882 particles of 5 um on a carrier of 100 um hide half of it.
    EXPECT_NEAR(coverage_of(882, 50e-6, 2.5e-6), 0.5, 1e-12);
    EXPECT_EQ(count_for_coverage(0.5, 50e-6, 2.5e-6), 882);
    EXPECT_EQ(count_for_coverage(0.15, 50e-6, 2.5e-6), 265);
}

TEST(Packing, around_a_sphere_touches_it_and_nothing_else) {
    for (const int count : {1, 2, 12, 882, 1300}) {
        const auto points = pack_around(Vec(1, 2, 3), 52.5, 2.5, count, 7);
        ASSERT_TRUE(points) << count;
        ASSERT_EQ(points->size(), static_cast<std::size_t>(count));
        Vec sum = Vec::Zero();
        for (std::size_t i = 0; i < points->size(); ++i) {
            const Vec from = (*points)[i] - Vec(1, 2, 3);
            sum += from;
            EXPECT_NEAR(from.norm(), 52.5, 1e-12);
            for (std::size_t j = 0; j < i; ++j) ASSERT_GE(((*points)[i] - (*points)[j]).norm(), 5) << i << " " << j;
        }
        // Evenly over the sphere: each component of the mean is within a standard error of independent points.
        if (count > 100) {
            EXPECT_LT((sum / count).cwiseAbs().maxCoeff(), 52.5 / std::sqrt(3.0 * count));
        }
    }
}

TEST(Packing, is_the_same_for_a_seed_and_another_for_another) {
    EXPECT_EQ(*pack_around(Vec::Zero(), 10, 1, 50, 1), *pack_around(Vec::Zero(), 10, 1, 50, 1));
    EXPECT_NE(*pack_around(Vec::Zero(), 10, 1, 50, 1), *pack_around(Vec::Zero(), 10, 1, 50, 2));
    const Room room{{Vec::Zero(), Vec::Constant(10)}, {}, {}, {}};
    EXPECT_EQ(*pack_room(room, 1, 50, 1), *pack_room(room, 1, 50, 1));
    EXPECT_NE(*pack_room(room, 1, 50, 1), *pack_room(room, 1, 50, 2));
}

TEST(Packing, a_room_stays_clear_of_what_is_in_it) {
    // Half of the volume beside a large sphere, above a slanting plane.
    const WallPlane plane{0, Vec(0, 0, 2), Vec(0.6, 0, 0.8)};
    const Room room{{Vec::Zero(), Vec::Constant(20)}, {Vec(10, 10, 10)}, {5}, {plane}};
    const int count = 700;
    const auto points = pack_room(room, 1, count, 3);
    ASSERT_TRUE(points);
    for (std::size_t i = 0; i < points->size(); ++i) {
        const Vec& x = (*points)[i];
        EXPECT_GE(x.minCoeff(), 1);
        EXPECT_LE(x.maxCoeff(), 19);
        EXPECT_GE((x - room.centres[0]).norm(), 6);
        EXPECT_GE((x - plane.point).dot(plane.normal), 1 - 1e-12);
        for (std::size_t j = 0; j < i; ++j) ASSERT_GE((x - (*points)[j]).norm(), 2);
    }
}

TEST(Packing, knows_when_there_is_no_room) {
    EXPECT_FALSE(pack_around(Vec::Zero(), 52.5, 2.5, 1800, 1)) << "more than the whole surface";
    EXPECT_FALSE(pack_room({{Vec::Zero(), Vec(1, 10, 10)}, {}, {}, {}}, 1, 1, 1)) << "the box is too thin";
}

TEST(SphereMesh, a_carrier_that_turns_carries_its_spheres) {
    const MeshResult made = meshed(head + elastic +
                                   spheres("carrier",
                                           "radius = \"50 um\"\ncentres = [[0, 0, \"1 mm\"]]\n"
                                           "initial_velocity = [0, 0, \"-5 m/s\"]\n"
                                           "initial_spin = [\"1e5 rad/s\", 0, 0]") +
                                   spheres("drug", "radius = \"2.5 um\"\naround = \"carrier\"\ncoverage = 0.5"));
    const ParticleSet& set = made.particles;
    ASSERT_EQ(set.size(), 883U);
    EXPECT_EQ(set.count(PartKind::spheres), 883U);
    EXPECT_NEAR(set.mass[0], 1000 * 4.0 / 3 * std::numbers::pi * std::pow(50e-6, 3), 1e-22);
    EXPECT_EQ(set.spacing, 5e-6);
    for (std::size_t i = 1; i < set.size(); ++i) {
        const Vec from = set.position[i] - set.position[0];
        EXPECT_NEAR(from.norm(), 52.5e-6, 1e-16);
        EXPECT_NEAR((set.velocity[i] - Vec(0, 0, -5) - Vec(1e5, 0, 0).cross(from)).norm(), 0, 1e-12);
        EXPECT_EQ(set.angular_velocity[i], Vec(1e5, 0, 0));
    }
    EXPECT_NEAR(made.report.spheres[1].coverage, 0.5, 1e-12);
    EXPECT_THAT(made.report.text(),
                HasSubstr("spheres of drug: 882, radius 2.5e-06 m, 5.773e-11 kg together; they hide 0.5000 of the "
                          "surface of carrier\n"));
}

TEST(SphereMesh, spheres_that_adhere_start_pressed_in_where_they_rest) {
    // Hertz' 4/3 E* sqrt(R*) d^1.5 against the pull: d = 1.4454 nm for a drug particle on lactose (docs/spheres.md).
    const std::string pair = "[[contact_pair]]\nparts = [\"drug\", \"carrier\"]\nrestitution = 1\nfriction = 0.1\n";
    const auto depth = [&](const std::string& adhesion) {
        const std::string carrier =
            "[[part]]\nname = \"carrier\"\nkind = \"spheres\"\nyoungs_modulus = \"63 GPa\"\n"
            "poisson_ratio = 0.24\ndensity = \"2502 kg/m^3\"\nradius = \"50 um\"\n"
            "centres = [[0, 0, 0]]\n";
        const std::string drug =
            "[[part]]\nname = \"drug\"\nkind = \"spheres\"\nyoungs_modulus = \"2.15 GPa\"\n"
            "poisson_ratio = 0.3\ndensity = \"1290 kg/m^3\"\nradius = \"2.5 um\"\n"
            "around = \"carrier\"\ncount = 3\n";
        const MeshResult made = meshed(head + elastic + carrier + drug + pair + adhesion);
        return made.report.deepest_overlap;
    };
    const std::string bradley = "adhesion = \"bradley\"\nequilibrium_distance = \"0.4 nm\"\n";
    EXPECT_NEAR(depth(bradley + "pull_off_force = \"258 nN\"\n"), 1.4454e-9, 1e-13);
    const double effective = 50.0 * 2.5 / 52.5 * 1e-6, work = 258e-9 / (2 * std::numbers::pi * effective);
    EXPECT_NEAR(depth(bradley + "work_of_adhesion = \"" + std::to_string(1e6 * work) + " uJ/m^2\"\n"), 1.4454e-9,
                1e-13);
    // JKR without load (Johnson, Kendall & Roberts 1971): d = a^2 / 3 R*, a^3 = 9 pi W R*^2 / (2 E*).
    const double modulus = 3.0427e9 * 0.75;
    const double radius = std::cbrt(4.5 * std::numbers::pi * work * effective * effective / modulus);
    EXPECT_NEAR(depth("normal = \"jkr\"\nwork_of_adhesion = \"" + std::to_string(1e6 * work) + " uJ/m^2\"\n"),
                radius * radius / (3 * effective), 1e-13);
}

TEST(SphereMesh, a_table_gives_places_sizes_and_motion_in_its_units) {
    const std::string table =
        "# three spheres\nz [mm], x [m], y [um], radius [mm], vx [m/s], vy [mm/s], vz [m/s]\n"
        "1, 0, 0, 0.5, 1, 2, 3\n3, 0, 500, 0.25,0,0,0\n-2.5e0, +1, 0, 0.5, 0, 0, 0\n";
    const ParticleSet set = meshed(head + elastic + spheres("beads", "positions = \"table.csv\""), table).particles;
    ASSERT_EQ(set.size(), 3U);
    EXPECT_EQ(set.position[1], Vec(0, 500e-6, 3e-3));
    EXPECT_EQ(set.position[2], Vec(1, 0, -2.5e-3));
    EXPECT_EQ(set.radius[1], 0.25e-3);
    EXPECT_EQ(set.velocity[0], Vec(1, 2e-3, 3));
    EXPECT_EQ(set.angular_velocity[0], Vec::Zero());
}

TEST(SphereMesh, a_table_may_be_as_spreadsheets_save_it) {
    const ParticleSet plain = meshed(head + elastic + spheres("beads", "radius = \"1 mm\"\npositions = \"table.csv\""),
                                     "x [mm], y [mm], z [mm]\n1.5, 2, 3\n4, 5, -6\n")
                                  .particles;
    for (const char* table : {"\xEF\xBB\xBFx [mm],y [mm],z [mm]\r\n1.5,2,3\r\n4,5,-6\r\n",
                              "\"x [mm]\",\"y [mm]\",\"z [mm]\"\n\"1.5\",\" 2 \",\"3\"\n4,5,-6\n",
                              "x [mm];y [mm];z [mm]\n1.5;2;3\n4;5;-6\n",
                              "\xEF\xBB\xBF\"x [mm]\";\"y [mm]\";\"z [mm]\"\r\n\"1.5\";2;3\r\n4;5;-6\r\n"})
        EXPECT_EQ(meshed(head + elastic + spheres("beads", "radius = \"1 mm\"\npositions = \"table.csv\""), table)
                      .particles.position,
                  plain.position)
            << table;
}

TEST(SphereMesh, a_box_is_filled_beside_what_stands_in_it) {
    const MeshResult made =
        meshed(head + elastic +
               "[[part]]\nname = \"floor\"\nkind = \"plane\"\npoint = [0, 0, \"2 mm\"]\nnormal = [0, 0, 1]\n" +
               spheres("beads",
                       "radius = \"1 mm\"\nfill_from = [0, 0, 0]\nfill_to = [\"10 mm\", \"20 mm\", \"20 mm\"]\n"
                       "volume_fraction = 0.3\ninitial_velocity = [\"2 m/s * z / 1 m\"]") +
               spheres("ball", "radius = \"3 mm\"\ncentres = [[\"5 mm\", \"10 mm\", \"10 mm\"]]\nfixed = true"));
    const ParticleSet& set = made.particles;
    EXPECT_EQ(set.parts[1].name, "ball") << "what is placed comes before what fills the rest";
    EXPECT_EQ(set.size(), 1U + static_cast<std::size_t>(std::lround(0.3 * 4000 * 3 / (4 * std::numbers::pi))));
    EXPECT_EQ(set.fixed[0], 1);
    EXPECT_EQ(set.fixed[1], 0);
    EXPECT_EQ(made.report.touching, 0U);
    for (std::size_t i = 1; i < set.size(); ++i) {
        EXPECT_GE(set.position[i][2], 3e-3 - 1e-15);
        EXPECT_NEAR(set.velocity[i][0], 2 * set.position[i][2], 1e-15);
    }
    EXPECT_NEAR(made.report.spheres[1].volume_fraction, 0.3, 1e-3);
    EXPECT_THAT(made.report.text(), HasSubstr("wall floor: a plane\n"));
}

TEST(SphereMesh, comes_into_its_periods) {
    const MeshResult made = meshed(
        head + elastic + "[flow]\nperiodic = [\"x\"]\n[box]\nfrom = [0, 0, 0]\nto = [\"10 mm\", \"1 mm\", \"1 mm\"]\n" +
        spheres("beads", "radius = \"1 mm\"\ncentres = [[\"-1 mm\", 0, 0], [\"0.99 mm\", 0, 0]]"));
    EXPECT_NEAR(made.particles.position[0][0], 9e-3, 1e-17);
    EXPECT_EQ(made.particles.box.high[0], 10e-3);
    EXPECT_EQ(made.particles.box.low[1], -1e-3) << "along the others the box holds the spheres";
    EXPECT_EQ(made.report.touching, 1U);
    EXPECT_NEAR(made.report.deepest_overlap, 0.01e-3, 1e-17);
}

TEST(WrongSphereMesh, spheres_in_each_other_are_named) {
    const std::string beads = spheres("beads", "radius = \"1 mm\"\ncentres = [[0, 0, 0], [0, 0, \"5 mm\"]]");
    const std::string ball = spheres("ball", "radius = \"0.5 mm\"\ncentres = [[0, 0, \"6 mm\"]]");
    EXPECT_EQ(fault(head + elastic + beads + ball),
              "scene.toml:20:8: sphere 1 of 'beads' at (0, 0, 0.005) m and sphere 0 of 'ball' at (0, 0, 0.006) m "
              "overlap by 0.0005 m at the start\n"
              "  move them apart: at most 0.05 of the smaller radius, 2.5e-05 m, may overlap");
    EXPECT_EQ(fault(head + "[[contact_pair]]\nparts = [\"any\", \"any\"]\nenabled = false\n" + beads + ball),
              "no error");
}

TEST(WrongSphereMesh, spheres_in_walls_are_named) {
    const std::string beads = spheres("beads", "radius = \"1 mm\"\ncentres = [[0, 0, \"0.5 mm\"]]");
    EXPECT_EQ(
        fault(head + elastic + beads +
              "[[part]]\nname = \"floor\"\nkind = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n"),
        "scene.toml:12:8: sphere 0 of 'beads' at (0, 0, 0.0005) m lies behind or in the wall 'floor' at the start: "
        "its centre is 0.0005 m from it\n"
        "  move it away by its radius or more");
    const std::string triangle =
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex -9 -9 0\nvertex 9 -9 0\nvertex 0 9 "
        "0\nendloop\nendfacet\nendsolid\n";
    const std::string tube = "[[part]]\nname = \"tube\"\nkind = \"surface\"\nfile = \"table.csv\"\nunit = \"1 mm\"\n";
    EXPECT_EQ(
        fault(head + elastic + beads + tube, triangle),
        "scene.toml:12:8: sphere 0 of 'beads' at (0, 0, 0.0005) m lies in the wall 'tube' at the start: its centre "
        "is 0.0005 m from it\n"
        "  move it away by its radius or more");
    const MeshResult made =
        meshed(head + elastic + tube + spheres("beads", "radius = \"1 mm\"\ncentres = [[0, 0, \"1 mm\"]]"), triangle);
    ASSERT_EQ(made.particles.wall_triangles.size(), 1U);
    EXPECT_NEAR((made.particles.wall_corners[2] - Vec(0, 9e-3, 0)).norm(), 0, 1e-17);
    EXPECT_THAT(made.report.text(), HasSubstr("wall tube: 1 triangles of 162 mm^2\n"));
}

TEST(WrongSphereMesh, too_many_spheres) {
    EXPECT_EQ(fault(head + elastic + spheres("carrier", "radius = \"10 mm\"\ncentres = [[0, 0, 0]]") +
                    spheres("drug", "radius = \"1 mm\"\naround = \"carrier\"\ncount = 600")),
              "scene.toml:27:9: 600 spheres of 'drug' of radius 0.001 m do not fit in without overlap\n"
              "  ask for fewer, or a coverage of at most 0.8");
}

TEST(WrongSphereMesh, around_a_table_of_several) {
    EXPECT_EQ(fault(head + elastic + spheres("carrier", "radius = \"10 mm\"\npositions = \"table.csv\"") +
                        spheres("drug", "radius = \"1 mm\"\naround = \"carrier\"\ncount = 6"),
                    "x [mm], y [mm], z [mm]\n0,0,0\n100,0,0\n"),
              "scene.toml:26:10: part 'drug': its spheres sit around one sphere, and 'carrier' has 2\n"
              "  name a part of one sphere");
}

struct TableFault {
    const char* table;
    const char* message;
};

TEST(WrongSphereTable, says_where_and_what_to_do) {
    const std::string start = "x [mm], y [mm], z [mm]\n";
    for (const auto& [table, message] :
         {TableFault{"", "scene.toml:17:13: './table.csv' lists no sphere\n  give it rows"},
          TableFault{"x [mm], y [mm], z\n",
                     "./table.csv:1:17: column 'z' has no unit\n  write it behind the name: z [mm]"},
          TableFault{"x [mm], y [s], z [mm]\n1,1,1\n",
                     "./table.csv:1:9: column y: found \"1 s\" (time), expected a length such as \"1 mm\""},
          TableFault{"x [mm], y [mm]\n1,1\n", "./table.csv:1:1: the table has no column 'z'"},
          TableFault{"x [mm], y [mm], z [mm], vx [m/s]\n", "./table.csv:1:1: the table has no column 'vy'"},
          TableFault{"x [mm], y [mm], z [mm], radios [mm]\n",
                     "./table.csv:1:25: unknown column 'radios'\n  did you mean 'radius'?"},
          TableFault{"x [mm], y [mm], x [mm]\n", "./table.csv:1:17: column 'x' stands twice"},
          TableFault{"x [mm], y [mm], z [mm]\n1,2\n", "./table.csv:2:1: found 2 values in a table of 3 columns"},
          TableFault{"x [mm], y [mm], z [mm]\n1, 2, nan\n", "./table.csv:2:7: found \"nan\", expected a number"},
          TableFault{"x [mm]; y [mm]; z [mm]\n1,5; 2; 3\n",
                     "./table.csv:2:1: found \"1,5\", expected a number\n  write 1.5, not 1,5"},
          TableFault{"x [mm], y [mm], z [mm], radius [mm]\n1,2,3,-1\n",
                     "./table.csv:2:7: a sphere's radius is more than 0"}})
        EXPECT_THAT(fault(head + elastic + spheres("beads", "positions = \"table.csv\"\nradius = \"1 mm\""), table),
                    HasSubstr(message));
    EXPECT_THAT(fault(head + elastic + spheres("beads", "positions = \"table.csv\""), start + "0,0,0\n"),
                HasSubstr("part 'beads': radius is neither in the scene nor in the table"));
}

}  // namespace
}  // namespace dmp::tests::sphere_meshes_tests
