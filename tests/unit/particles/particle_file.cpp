// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particle_file.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <variant>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "base/sealed_file.hpp"
#include "tests/modules.hpp"
#include "tests/unit/damage.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::particle_file_tests {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A set in which each number is another one, so that a mix-up shows.
ParticleSet some_particles(int count = 50) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto vector = [&] { return Vec(number(random), number(random), number(random)); };
    ParticleSet set;
    set.dimension = 3;
    set.spacing = 0.1;
    set.box = {Vec(-1, -2, -3), Vec(1, 2, 3.25)};
    set.periodic = {true, false, true};
    set.mirrored[1] = {true, false};
    set.parts = {{"blood", PartKind::fluid}, {"wall", PartKind::rigid}, {"leaflets", PartKind::elastic}};
    for (int i = 0; i < count; ++i) {
        set.position.push_back(vector());
        set.volume.push_back(number(random));
        set.mass.push_back(number(random));
        set.part.push_back(i % 3);
        set.body.push_back(i % 5 - 1);
        set.fixed.push_back(i % 2 == 0);
        set.seated.push_back(i % 7 == 0);
        set.wall_normal.push_back(vector());
        set.wall_distance.push_back(number(random));
    }
    for (int i = 2; i < count; ++i) {
        set.bonds.push_back({i, i - 1, number(random), number(random)});
        set.hinges.push_back({i, i - 1, i - 2, std::abs(number(random)), number(random)});
        set.dihedrals.push_back({i, i - 1, i - 2, (i + 1) % count, number(random), number(random)});
    }
    return set;
}

void expect_equal(const ParticleSet& read, const ParticleSet& written) {
    EXPECT_EQ(read.dimension, written.dimension);
    EXPECT_EQ(read.spacing, written.spacing);
    EXPECT_EQ(read.box.low, written.box.low);
    EXPECT_EQ(read.box.high, written.box.high);
    EXPECT_EQ(read.periodic, written.periodic);
    EXPECT_EQ(read.mirrored, written.mirrored);
    ASSERT_EQ(read.parts.size(), written.parts.size());
    for (std::size_t n = 0; n < read.parts.size(); ++n) {
        EXPECT_EQ(read.parts[n].name, written.parts[n].name);
        EXPECT_EQ(read.parts[n].kind, written.parts[n].kind);
    }
    EXPECT_EQ(read.position, written.position);
    EXPECT_EQ(read.volume, written.volume);
    EXPECT_EQ(read.mass, written.mass);
    EXPECT_EQ(read.part, written.part);
    EXPECT_EQ(read.body, written.body);
    EXPECT_EQ(read.fixed, written.fixed);
    EXPECT_EQ(read.seated, written.seated);
    EXPECT_EQ(read.wall_normal, written.wall_normal);
    EXPECT_EQ(read.wall_distance, written.wall_distance);
    ASSERT_EQ(read.bonds.size(), written.bonds.size());
    for (std::size_t n = 0; n < read.bonds.size(); ++n) {
        EXPECT_EQ(read.bonds[n].a, written.bonds[n].a);
        EXPECT_EQ(read.bonds[n].b, written.bonds[n].b);
        EXPECT_EQ(read.bonds[n].rest_length, written.bonds[n].rest_length);
        EXPECT_EQ(read.bonds[n].stiffness, written.bonds[n].stiffness);
    }
    ASSERT_EQ(read.hinges.size(), written.hinges.size());
    for (std::size_t n = 0; n < read.hinges.size(); ++n) {
        EXPECT_EQ(read.hinges[n].a, written.hinges[n].a);
        EXPECT_EQ(read.hinges[n].centre, written.hinges[n].centre);
        EXPECT_EQ(read.hinges[n].b, written.hinges[n].b);
        EXPECT_EQ(read.hinges[n].rest_angle, written.hinges[n].rest_angle);
        EXPECT_EQ(read.hinges[n].stiffness, written.hinges[n].stiffness);
    }
    ASSERT_EQ(read.dihedrals.size(), written.dihedrals.size());
    for (std::size_t n = 0; n < read.dihedrals.size(); ++n) {
        const Dihedral &is = read.dihedrals[n], &was = written.dihedrals[n];
        EXPECT_EQ((std::array<int, 4>{is.a, is.b, is.c, is.d}), (std::array<int, 4>{was.a, was.b, was.c, was.d}));
        EXPECT_EQ(is.rest_angle, was.rest_angle);
        EXPECT_EQ(is.stiffness, was.stiffness);
    }
}

class ParticleFile : public ::testing::Test {
  protected:
    TemporaryFolder folder_;
    fs::path file_ = folder_.path() / "particles.h5";
};

/// Spheres, a fluid particle and walls.
ParticleSet some_spheres() {
    ParticleSet set = some_particles(12);
    set.parts = {{"water", PartKind::fluid}, {"floor", PartKind::rigid}, {"beads", PartKind::spheres}};
    set.bonds.clear();
    set.hinges.clear();
    set.dihedrals.clear();
    for (std::size_t i = 0; i < set.size(); ++i) {
        const bool sphere = set.kind(i) == PartKind::spheres;
        set.mass[i] = std::abs(set.mass[i]);
        set.radius.push_back(sphere ? 0.5 + static_cast<double>(i) : 0);
        set.velocity.emplace_back(sphere ? 0.1 * static_cast<double>(i) : 0, 2, 3);
        set.angular_velocity.emplace_back(-1, sphere ? 0.2 * static_cast<double>(i) : 0, 7);
    }
    set.wall_planes = {{1, Vec(1, 2, 3), Vec(0, 0.6, 0.8)}, {1, Vec(4, 5, 6), Vec(1, 0, 0)}};
    set.wall_corners = {Vec(0, 0, 0), Vec(1, 0, 0), Vec(0, 1, 0), Vec(0, 0, 1)};
    set.wall_triangles = {{1, 0, 1, 2}, {1, 3, 2, 1}};
    return set;
}

TEST_F(ParticleFile, GivesSpheresAndTheirWallsBack) {
    const ParticleSet written = some_spheres();
    write_particles(file_, written);
    const ParticleSet read = read_particles(file_);
    expect_equal(read, written);
    EXPECT_EQ(read.radius, written.radius);
    EXPECT_EQ(read.velocity, written.velocity);
    EXPECT_EQ(read.angular_velocity, written.angular_velocity);
    ASSERT_EQ(read.wall_planes.size(), 2U);
    EXPECT_EQ(read.wall_planes[0].normal, Vec(0, 0.6, 0.8));
    EXPECT_EQ(read.wall_planes[1].point, Vec(4, 5, 6));
    EXPECT_EQ(read.wall_corners, written.wall_corners);
    ASSERT_EQ(read.wall_triangles.size(), 2U);
    EXPECT_EQ(read.wall_triangles[1].a, 3);
    EXPECT_EQ(read.wall_triangles[1].c, 1);
    EXPECT_EQ(read.wall_triangles[1].part, 1);
}

TEST_F(ParticleFile, GivesTheSurfacesThatTouchBackAndRefusesThoseThatAreNone) {
    ParticleSet written = some_spheres();
    written.contact_points = {Vec(1, 2, 0), Vec(3, 4, 0), Vec(5, 6, 0)};
    written.contact_pieces = {{1, 0, 1, 2, 0.25}, {1, 1, 2, 0, 0.5}};
    write_particles(file_, written);
    const ParticleSet read = read_particles(file_);
    EXPECT_EQ(read.contact_points, written.contact_points);
    ASSERT_EQ(read.contact_pieces.size(), 2U);
    EXPECT_EQ(read.contact_pieces[1].part, 1);
    EXPECT_EQ(read.contact_pieces[1].a, 1);
    EXPECT_EQ(read.contact_pieces[1].b, 2);
    EXPECT_EQ(read.contact_pieces[1].c, 0);
    EXPECT_EQ(read.contact_pieces[1].thickness, 0.5);
    written.contact_pieces[0].b = 3;
    EXPECT_THAT(text_thrown<std::invalid_argument>([&] { write_particles(file_, written); }),
                HasSubstr("contact piece 0 has a point that is not there"));
    written.contact_pieces[0] = {9, 0, 1, 2, 0.25};
    EXPECT_THAT(text_thrown<std::invalid_argument>([&] { write_particles(file_, written); }),
                HasSubstr("its part is not there"));
}

TEST_F(ParticleFile, HasNothingOfSpheresWhereThereAreNone) {
    write_particles(file_, some_particles());
    const SealedReader reader(file_, {"particle set", 1});
    for (const char* name : {"particles/radius", "particles/velocity", "wall_planes/part", "wall_triangles/a"})
        EXPECT_FALSE(reader.contents().has(name)) << name;
}

TEST_F(ParticleFile, RefusesSpheresAndWallsThatAreNone) {
    const auto fault = [&](const auto& spoil) {
        ParticleSet set = some_spheres();
        spoil(set);
        return text_thrown<std::invalid_argument>([&] { write_particles(file_, set); });
    };
    EXPECT_THAT(fault([](ParticleSet& set) { set.radius[2] = 0; }),
                HasSubstr("particle 2: its radius is not more than 0"));
    EXPECT_THAT(fault([](ParticleSet& set) { set.mass[5] = 0; }), HasSubstr("particle 5: its mass is not more than 0"));
    EXPECT_THAT(fault([](ParticleSet& set) { set.velocity[5][1] = nan; }), HasSubstr("particle 5: its velocity"));
    EXPECT_THAT(fault([](ParticleSet& set) { set.velocity.pop_back(); }), HasSubstr("velocity of 11"));
    EXPECT_THAT(fault([](ParticleSet& set) { set.wall_planes[0].part = 2; }), HasSubstr("its part is no rigid part"));
    EXPECT_THAT(fault([](ParticleSet& set) { set.wall_planes[1].normal *= 2; }), HasSubstr("wall plane 1"));
    EXPECT_THAT(fault([](ParticleSet& set) { set.wall_corners[3][0] = infinity; }), HasSubstr("wall corner 3"));
    EXPECT_THAT(fault([](ParticleSet& set) { set.wall_triangles[1].b = 4; }), HasSubstr("wall triangle 1"));
}

TEST_F(ParticleFile, GivesTheParticlesBackBitForBit) {
    const ParticleSet written = some_particles();
    write_particles(file_, written);
    expect_equal(read_particles(file_), written);
}

TEST_F(ParticleFile, SaysWhatTheyWereMadeFrom) {
    const std::vector<std::string> lines{"particles.spacing = \"1 mm\"", "dimension = 2"};
    write_particles(file_, some_particles(), lines);
    EXPECT_EQ(read_particle_file(file_).made_from, lines);
    expect_equal(read_particle_file(file_).particles, some_particles());
    write_particles(file_, some_particles());
    EXPECT_TRUE(read_particle_file(file_).made_from.empty());
}

TEST_F(ParticleFile, GivesAnEmptySetBack) {
    ParticleSet written;
    written.spacing = 1;
    write_particles(file_, written);
    expect_equal(read_particles(file_), written);
}

TEST_F(ParticleFile, NamesUnits) {
    write_particles(file_, some_particles());
    const Hdf5Reader reader(file_);
    EXPECT_EQ(reader.text_attribute("particles/position", "unit"), "m");
    EXPECT_EQ(reader.text_attribute("hinges/stiffness", "unit"), "J");
    EXPECT_THAT(reader.texts("parts/kind"), ElementsAre("fluid", "rigid", "elastic"));
}

TEST_F(ParticleFile, DamageIsRefused) {
    write_particles(file_, some_particles());
    const std::string whole = bytes_of(file_);
    std::mt19937_64 random(3);
    for (int n = 0; n < 100; ++n) {
        flip_bit(file_, random() % (whole.size() * 8));
        EXPECT_THROW((void)read_particles(file_), InputError);
        put_bytes(file_, whole.substr(0, random() % whole.size()));
        EXPECT_THROW((void)read_particles(file_), InputError);
        put_bytes(file_, whole);
    }
    expect_equal(read_particles(file_), some_particles());
}

TEST_F(ParticleFile, AFullDiskIsAResourceError) {
    const FileSizeLimit limit(4000);
    EXPECT_THAT(text_thrown<ResourceError>([&] { write_particles(file_, some_particles(1000)); }),
                HasSubstr(file_.string()));
    EXPECT_THAT(files_in(folder_.path()), ElementsAre());
}

TEST_F(ParticleFile, ASetThatCouldNotBeReadBackIsNotWritten) {
    ParticleSet set = some_particles();
    set.position[7].y() = nan;
    EXPECT_THAT(text_thrown<std::invalid_argument>([&] { write_particles(file_, set); }),
                HasSubstr("particle 7: its position is not finite"));
    EXPECT_FALSE(fs::exists(file_));
}

/// Copies the particles' file with other contents under one name, sealed as dmp does it; without values: leaves it out.
template <Hdf5Number T>
void replace(const fs::path& file, const std::string& changed, const std::vector<T>& values) {
    const fs::path original = file.parent_path() / "original.h5";
    fs::rename(file, original);
    const Hdf5Reader from(original);
    SealedWriter writer(file, {"particle set", 1});
    Hdf5Writer& to = writer.contents();
    const auto copy_array = [&]<class Number>(const std::string& name, Number) {
        if (name == "dimension" || name == "spacing")
            to.write_number<Number>(name, from.number<Number>(name));
        else
            to.write_array<Number>(name, from.array<Number>(name));
    };
    for (const std::string& name : from.names()) {
        if (name == changed) {
            if (values.size() == 1)
                to.write_number<T>(name, values[0]);
            else if (!values.empty())
                to.write_array<T>(name, values);
            continue;
        }
        switch (from.type(name)) {
            case Hdf5Type::float64:
                copy_array(name, double{});
                break;
            case Hdf5Type::int32:
                copy_array(name, std::int32_t{});
                break;
            case Hdf5Type::uint8:
                copy_array(name, std::uint8_t{});
                break;
            default:
                to.write_texts(name, from.texts(name));
        }
    }
    writer.finish();
}

struct Wrong {
    std::string dataset;
    std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::uint8_t>> values;
    std::string says;
};

TEST_F(ParticleFile, ContentsThatAreNoParticlesAreNamed) {
    using Reals = std::vector<double>;
    using Integers = std::vector<std::int32_t>;
    using Flags = std::vector<std::uint8_t>;
    const std::vector<Wrong> wrongs{
        {"particles/mass", Reals{}, "has no dataset 'particles/mass'"},
        {"particles/mass", Integers{1, 2, 3, 4}, "'particles/mass' holds int32, not float64"},
        {"particles/mass", Reals{1, 2, 3}, "there are positions of 4 particles, and mass of 3"},
        {"particles/mass", Reals{1, 2, nan, 4}, "particle 2: its volume or mass is not finite"},
        {"particles/position", Reals{1, 2, 3, 4}, "particles/position has 4 numbers, no three a vector"},
        {"particles/position", Reals{1, 2, 3, 4, 5, 6, 7, 8, infinity, 10, 11, 12}, "particle 2: its position"},
        {"particles/wall_normal", Reals{1, 2, 3, 4, 5, 6}, "and wall_normal of 2"},
        {"particles/wall_distance", Reals{0, 0, 0, nan}, "particle 3: its wall_normal or wall_distance"},
        {"particles/part", Integers{0, 1, 2, 3}, "particle 3: its part is number 3 of 3"},
        {"particles/part", Integers{-1, 1, 2, 3}, "particle 0: its part is number -1"},
        {"particles/body", Integers{-1, -2, 0, 0}, "particle 1: its body is number -2"},
        {"particles/fixed", Flags{0, 1, 2, 0}, "particle 2: its fixed or seated"},
        {"bonds/a", Integers{3, 4}, "bond 1 ends at a particle that is not there"},
        {"bonds/b", Integers{-1, 1}, "bond 0 ends at a particle that is not there"},
        {"bonds/b", Integers{1, 2, 3}, "bonds/b has 3 elements, not 2"},
        {"bonds/stiffness", Reals{1, infinity}, "bond 1: its rest_length or stiffness"},
        {"hinges/centre", Integers{1, 4}, "hinge 1 joins a particle that is not there"},
        {"hinges/rest_angle", Reals{nan, 1}, "hinge 0: its rest_angle or stiffness"},
        {"hinges/rest_angle", Reals{1, -0.5}, "hinge 1: its rest_angle is not between 0 and pi"},
        {"dihedrals/d", Integers{0, 4}, "dihedral 1 joins a particle that is not there"},
        {"dihedrals/b", Integers{1, 2, 3}, "dihedrals/b has 3 elements, not 2"},
        {"dihedrals/rest_angle", Reals{0, nan}, "dihedral 1: its rest_angle or stiffness"},
        {"dimension", Integers{2}, "it has dihedrals, and there are none in 2-D"},
        {"dimension", Integers{4}, "4 dimensions"},
        {"spacing", Reals{0}, "spacing is not more than 0"},
        {"box/low", Reals{0, 3, 0}, "box is none"},
        {"box/high", Reals{1, 2, 3, 4, 5, 6}, "box/high is not one vector"},
        {"periodic", Flags{0, 2, 0}, "periodic is not 0 or 1"},
        {"mirrored", Flags{0, 1, 0}, "mirrored is not 0 or 1"},
        {"parts/kind", Flags{0, 1, 2}, "'parts/kind' holds uint8, not text"},
    };
    for (const Wrong& wrong : wrongs) {
        write_particles(file_, some_particles(4));
        std::visit([&](const auto& values) { replace(file_, wrong.dataset, values); }, wrong.values);
        const std::string text = text_thrown<InputError>([&] { (void)read_particles(file_); });
        EXPECT_THAT(text, HasSubstr(file_.string() + ": "));
        EXPECT_THAT(text, HasSubstr(wrong.says)) << wrong.dataset;
    }
}

TEST_F(ParticleFile, TheCopyWithNothingChangedIsRead) {  // else the test above would test its own copying
    write_particles(file_, some_particles(4));
    replace<double>(file_, "nothing", {});
    expect_equal(read_particles(file_), some_particles(4));
}

TEST_F(ParticleFile, OtherFilesAreRefused) {
    SealedWriter(file_, {"frame", 1}).finish();
    EXPECT_THAT(text_thrown<InputError>([&] { (void)read_particles(file_); }),
                HasSubstr("not a dmp particle set but a dmp frame"));
    EXPECT_THAT(text_thrown<InputError>([&] { (void)read_particles(folder_.path() / "none.h5"); }),
                HasSubstr("not readable: No such file"));
}

}  // namespace
}  // namespace dmp::tests::particle_file_tests
