// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A soft cap glued to a soft stem on the floor of a channel, from the geometry and from a particle file.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::joined_solids_tests {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string cad_geometry = R"(Point(1) = {0, 0, 0};
Point(2) = {4e-3, 0, 0};
Point(3) = {4e-3, 1e-3, 0};
Point(4) = {0, 1e-3, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("blood") = {1};
Physical Curve("wall") = {1, 3};
Point(11) = {1e-3, 0, 0};
Point(12) = {1.2e-3, 0, 0};
Point(13) = {1.2e-3, 0.35e-3, 0};
Point(14) = {1e-3, 0.35e-3, 0};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 11};
Curve Loop(2) = {11, 12, 13, 14};
Plane Surface(2) = {2};
Physical Surface("stem") = {2};
Point(15) = {0.9e-3, 0.35e-3, 0};
Point(16) = {1.5e-3, 0.35e-3, 0};
Point(17) = {1.5e-3, 0.55e-3, 0};
Point(18) = {0.9e-3, 0.55e-3, 0};
Line(15) = {15, 16};
Line(16) = {16, 17};
Line(17) = {17, 18};
Line(18) = {18, 15};
Curve Loop(3) = {15, 16, 17, 18};
Plane Surface(3) = {3};
Physical Surface("cap") = {3};
)";

const std::string scene = R"(schema = 1
title = "A cap on a stem"
dimension = 2

[geometry]
file = "channel.geo"
unit = "1 m"

[particles]
spacing = "0.05 mm"
fill = "relaxed"

[[part]]
name = "blood"
kind = "fluid"
density = "1060 kg/m^3"
viscosity = "3.5 mPa*s"

[[part]]
name = "wall"
kind = "rigid"

[[part]]
name = "stem"
kind = "elastic"
model = "springs"
density = "1100 kg/m^3"
youngs_modulus = "20 kPa"
anchor = "wall"
bonds_within = "0.08 mm"

[[part]]
name = "cap"
kind = "elastic"
model = "springs"
density = "1100 kg/m^3"
youngs_modulus = "50 kPa"
bonds_within = "0.08 mm"

[[join]]
name = "glue"
parts = ["stem", "cap"]

[[break]]
name = "tear"
part = "glue"
force_above = "10 N"

[flow]
acceleration = ["20 m/s^2", 0]
periodic = ["x"]
largest_speed = "0.3 m/s"

[run]
duration = "1 ms"

[output]
every = "0.5 ms"
)";

class JoinedSolids : public ::testing::Test {
  protected:
    JoinedSolids() {
        folder_.write("channel.geo", cad_geometry);
        folder_.write("scene.toml", scene);
    }
    [[nodiscard]] Outcome dmp(const std::vector<std::string>& words) const { return run_dmp(folder_.path(), words); }
    [[nodiscard]] std::string hash(const std::string& out) const {
        return nlohmann::json::parse(folder_.read(out + "/summary.json")).at("state_hash").get<std::string>();
    }
    CaseFolder folder_;
};

TEST_F(JoinedSolids, AreOneBodyAndAreSaidToBe) {
    const Outcome run = dmp({"run", ".", "--out", "out", "--set", "output.pictures=false"});
    ASSERT_EQ(run.code, 0) << run.errors;
    EXPECT_THAT(
        run.output,
        AllOf(ContainsRegex("springs stem  a solid of E 2e\\+?0?4 Pa, nu 0.25; [0-9]+ bonds of k_b [0-9.e+]+ N/m to "),
              ContainsRegex("join glue +[0-9]+ bonds of k_b [0-9.e+]+ N/m between stem and cap"),
              ContainsRegex("glue +0 bonds made, 0 broken"), Not(HasSubstr(" 0 particles in"))));
    const Outcome mesh = dmp({"mesh", ".", "--particles", "both.h5"});
    ASSERT_EQ(mesh.code, 0) << mesh.errors;
    EXPECT_THAT(mesh.output, ContainsRegex("join glue: [0-9]+ bonds of k_b = "));
    const Outcome again =
        dmp({"run", ".", "--particles", "both.h5", "--out", "again", "--set", "output.pictures=false"});
    ASSERT_EQ(again.code, 0) << again.errors;
    EXPECT_THAT(again.output, ContainsRegex("join glue +[0-9]+ bonds of k_b [0-9.e+]+ N/m, from the file"));
    EXPECT_EQ(hash("again"), hash("out"));
}

TEST_F(JoinedSolids, AreRefusedWithParticlesOfAnotherJoin) {
    ASSERT_EQ(dmp({"mesh", ".", "--particles", "both.h5"}).code, 0);
    folder_.replace("scene.toml", "name = \"glue\"", "name = \"glue\"\nwithin = \"0.12 mm\"");
    const Outcome run = dmp({"run", ".", "--particles", "both.h5", "--out", "refused"});
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.errors,
                AllOf(HasSubstr("the particles were made for another scene"), HasSubstr("join.glue.within")));
}

}  // namespace
}  // namespace dmp::tests::joined_solids_tests
