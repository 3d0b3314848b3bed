// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <gmock/gmock.h>

#include "cli/diagnosis.hpp"
#include "solver/parallel/resources.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::cli_diagnosis_tests {

namespace {

using namespace cli;
using testing::HasSubstr;

constexpr double gibibyte = 1024.0 * 1024 * 1024;

BuildFacts good_build() { return {"0.1.0", "Release", "GNU 12.2.0", "", "VTK 9.1.0, gmsh 4.8.4"}; }

Machine good_machine() {
    Machine machine;
    machine.processors = 4;
    machine.memory = 16 * gibibyte;
    machine.memory_free = 12 * gibibyte;
    machine.disk_free = 100 * gibibyte;
    machine.xvfb = "/usr/bin/Xvfb";
    machine.vector_units = {"avx2", "avx512"};
    return machine;
}

Finding about(const std::string& what, const BuildFacts& build, const Machine& machine) {
    const auto findings = diagnose(build, machine);
    const auto found = std::ranges::find(findings, what, &Finding::what);
    return found == findings.end() ? Finding{Health::bad, "missing", what} : *found;
}

TEST(Doctor, FindsNothingWrongWithAGoodMachine) {
    for (const auto& finding : diagnose(good_build(), good_machine())) {
        EXPECT_EQ(finding.health, Health::ok) << finding.what;
        EXPECT_EQ(finding.to_do, "") << finding.what;
    }
}

TEST(Doctor, OfABuildForClustersNamesNoLibraryThatItLacks) {
    BuildFacts build = good_build();
    build.libraries = "";
    Machine machine = good_machine();
    machine.xvfb = "";
    for (const auto& finding : diagnose(build, machine)) {
        EXPECT_EQ(finding.health, Health::ok) << finding.what;
        for (const char* word : {"VTK", "gmsh", "ParaView", "Xvfb"})
            EXPECT_THAT(finding.found, testing::Not(HasSubstr(word))) << finding.what;
    }
    EXPECT_EQ(about("for clusters", build, machine).health, Health::ok);
    EXPECT_EQ(about("for clusters", good_build(), machine).what, "missing");
}

TEST(Doctor, WarnsOfSlowBuilds) {
    BuildFacts build = good_build();
    build.build_type = "Debug";
    EXPECT_EQ(about("build", build, good_machine()).health, Health::warn);
    build = good_build();
    build.sanitizers = "address,undefined";
    EXPECT_THAT(about("build", build, good_machine()).found, HasSubstr("address,undefined"));
}

TEST(Doctor, SaysWhichVectorUnitIsUsed) {
    Machine machine = good_machine();
    EXPECT_EQ(about("vector unit", good_build(), machine).found, "avx512 is used, the widest there is (avx2, avx512)");
    machine.vector_units = {"avx2"};
    EXPECT_EQ(about("vector unit", good_build(), machine).found, "avx2 is used, the widest there is");
}

TEST(Doctor, AProcessorWithoutVectorUnitsIsBad) {
    Machine machine = good_machine();
    machine.vector_units.clear();
    const auto finding = about("vector unit", good_build(), machine);
    EXPECT_EQ(finding.health, Health::bad);
    EXPECT_THAT(finding.to_do, HasSubstr("2013"));
}

TEST(Doctor, KnowsControlGroups) {
    Machine machine = good_machine();
    machine.processor_quota = 2;
    const auto finding = about("processors", good_build(), machine);
    EXPECT_EQ(finding.health, Health::warn);
    EXPECT_EQ(finding.to_do, "Run with --threads 2.");
}

TEST(Doctor, AFolderThatCannotBeWrittenIsBad) {
    Machine machine = good_machine();
    machine.write_error = "Read-only file system";
    const auto finding = about("writing", good_build(), machine);
    EXPECT_EQ(finding.health, Health::bad);
    EXPECT_THAT(finding.found, HasSubstr("Read-only file system"));
    EXPECT_NE(finding.to_do, "");
}

TEST(Doctor, WarnsOfLittleMemoryLittleDiskAndNoScreen) {
    Machine machine = good_machine();
    machine.memory_free = 0.5 * gibibyte;
    machine.disk_free = 0.1 * gibibyte;
    machine.xvfb.clear();
    for (const char* what : {"memory", "disk", "pictures"}) {
        const auto finding = about(what, good_build(), machine);
        EXPECT_EQ(finding.health, Health::warn) << what;
        EXPECT_NE(finding.to_do, "") << what;
    }
    machine.display = ":0";
    EXPECT_EQ(about("pictures", good_build(), machine).health, Health::ok);
}

TEST(Doctor, SeesThisMachine) {
    const Machine machine = inspect_machine(testing::TempDir());
    EXPECT_GE(machine.processors, 1);
    EXPECT_GT(machine.memory, 0);
    EXPECT_GT(machine.disk_free, 0);
    EXPECT_EQ(machine.write_error, "");
    ASSERT_FALSE(machine.vector_units.empty());
    EXPECT_EQ(machine.vector_units.back(), to_string(chosen_vector_unit(VectorUnit::widest)));
    EXPECT_NE(inspect_machine("/no/such/folder").write_error, "");
}

}  // namespace

}  // namespace dmp::tests::cli_diagnosis_tests
