// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a fluid in 3-D: what the slices hold, and what is in front of what.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "postproc/group_box.hpp"
#include "postproc/particle_view.hpp"
#include "postproc/pictures.hpp"
#include "postproc/views.hpp"
#include "postproc/virtual_display.hpp"
#include "postproc/vtk_sink.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::space_pictures_tests {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr float dx = 1e-3F;
constexpr float radius = 6.5F * dx;
enum Part : std::int32_t { water, pipe, strut, flap };

void add(FrameGroup& group, float x, float y, float z, std::int32_t part) {
    group.id.push_back(static_cast<std::int64_t>(group.id.size()));
    group.part.push_back(part);
    group.position.insert(group.position.end(), {x, y, z});
}

/// Water in a pipe along x, 24 spacings long and 13 across; a strut 4 spacings high from the wall's lowest line, at 8
/// to 10 spacings from the left; a chain of bonded particles from the wall above, with a bond round the border. The
/// pressure is 100 Pa in front of y = -0.75 dx, -100 Pa behind 0.75 dx, and in between the particle's x in dx.
Frame pipe_frame(double time) {
    Frame frame;
    frame.time = time;
    frame.spacing = dx;
    frame.parts = {"water", "pipe", "strut", "flap"};
    FrameGroup fluid, walls, solid;
    fluid.name = "fluid";
    walls.name = "walls";
    solid.name = "solid";
    FrameField velocity{"velocity", "m/s", 3, {}}, pressure{"pressure", "Pa", 1, {}};
    for (int i = 0; i < 24; ++i)
        for (int j = -10; j <= 10; ++j)
            for (int k = -10; k <= 10; ++k) {
                const float x = (static_cast<float>(i) + 0.5F) * dx;
                const float y = static_cast<float>(j) * dx, z = static_cast<float>(k) * dx;
                const float r = std::hypot(y, z);
                if (r > radius) {
                    if (r < radius + 3 * dx) add(walls, x, y, z, pipe);
                } else if (i >= 8 && i < 10 && std::abs(j) <= 1 && k < -2) {
                    add(walls, x, y, z, strut);
                } else {
                    add(fluid, x, y, z, water);
                    velocity.values.insert(velocity.values.end(),
                                           {static_cast<float>(1 + time) * (1 - r * r / (radius * radius)), 0, 0});
                    pressure.values.push_back(y < -0.75F * dx ? 100.0F : y > 0.75F * dx ? -100.0F : x / dx);
                }
            }
    fluid.fields = {velocity, pressure};
    for (int k = 0; k < 5; ++k) {
        add(solid, 16 * dx, 0, radius - static_cast<float>(k) * dx, flap);
        if (k > 0) solid.bond_ends.insert(solid.bond_ends.end(), {k - 1, k});
    }
    add(solid, 0.5F * dx, 0, 0, flap);
    add(solid, 23.5F * dx, 0, 0, flap);
    solid.bond_ends.insert(solid.bond_ends.end(), {5, 6});
    solid.bond_fields = {{"strain", "1", 1, std::vector<float>(solid.bonds(), 0.0F)}};
    frame.groups = {fluid, solid};
    if (time == 0) frame.groups.push_back(walls);
    return frame;
}

void write_run(const TemporaryFolder& folder, const std::vector<Frame>& frames) {
    VtkSink sink(folder.path(), {"Pipe with a strut", "", ""});
    for (const Frame& frame : frames) sink.write(frame);
}

std::set<std::int64_t> ids(const FrameGroup& group) { return {group.id.begin(), group.id.end()}; }

/// The particles of a group within the slab |place - origin| <= 0.75 dx across an axis.
std::set<std::int64_t> in_slab(const FrameGroup& group, int axis, double origin, std::int32_t part) {
    std::set<std::int64_t> found;
    for (std::size_t i = 0; i < group.size(); ++i)
        if (group.part[i] == part && std::abs(position_of(group, i)[axis] - origin) <= 0.75 * dx)
            found.insert(group.id[i]);
    return found;
}

class ViewsOfAPipe : public ::testing::Test {
  protected:
    void SetUp() override { write_run(folder_, {pipe_frame(0), pipe_frame(1)}); }
    TemporaryFolder folder_;
};

TEST_F(ViewsOfAPipe, AreASliceAlongOneAcrossAndOneCutOpen) {
    const RunFolder run(folder_.path());
    EXPECT_FALSE(run.flat());
    const std::vector<View> views = cameras(run);
    ASSERT_EQ(views.size(), 3U);
    EXPECT_EQ(views[0].caption, "x right, z up, at y = 0 mm");
    // the strut is thicker than the flap, at 8.5 and 9.5 dx
    EXPECT_THAT(views[1].caption, HasSubstr("y right, z up, at x = "));
    EXPECT_NEAR(views[1].cut.origin.x(), 9 * dx, 0.51 * dx);
    EXPECT_EQ(views[2].shows, View::Shows::opened);
    for (const View& view : views) EXPECT_THAT(view.bodies, ElementsAre(strut)) << "the pipe is around the fluid";
    for (const View& view : views) {
        const Vec size = view.area.extent();
        EXPECT_GT(size.minCoeff(), 10 * dx);
        EXPECT_LT(size.maxCoeff(), 45 * dx);
    }
}

TEST_F(ViewsOfAPipe, SlicesHoldTheirSlabAndNoOthers) {
    const RunFolder run(folder_.path());
    const std::vector<View> views = cameras(run);
    const RunFrame frame = run.read(1);
    for (const std::size_t k : {0U, 1U}) {
        SCOPED_TRACE(views[k].caption);
        const int across = k == 0 ? 1 : 0;
        const double origin = views[k].cut.origin[across];
        const Seen shown = seen(views[k], frame, run.walls());
        ASSERT_TRUE(shown.frame.fluid && shown.walls && shown.frame.bodies);
        EXPECT_EQ(ids(*shown.frame.fluid), in_slab(*frame.fluid, across, origin, water));
        EXPECT_EQ(ids(*shown.walls), in_slab(*run.walls(), across, origin, pipe));
        EXPECT_EQ(ids(*shown.frame.bodies), in_slab(*run.walls(), across, origin, strut));
        for (std::size_t i = 0; i < shown.frame.fluid->size(); ++i) {
            const Vec position = position_of(*shown.frame.fluid, i);
            EXPECT_LE(std::abs(position.z()), 0.75 * dx) << "of the cut, which is z = 0";
            EXPECT_TRUE(contains(views[k].area, position, 2));
        }
        // fields travel with their particles
        const FrameField* pressure = find_field(*shown.frame.fluid, "pressure");
        ASSERT_NE(pressure, nullptr);
        ASSERT_EQ(pressure->values.size(), shown.frame.fluid->size());
        if (k == 1) continue;
        for (std::size_t i = 0; i < shown.frame.fluid->size(); ++i)
            EXPECT_NEAR(dx * pressure->values[i], position_of(*shown.frame.fluid, i).x() + views[k].cut.origin.x(),
                        1e-3 * dx);
    }
    EXPECT_EQ(seen(views[0], frame, run.walls()).frame.solid->bond_ends.size(), 8U)
        << "the flap's four bonds, not the one round the border";
    EXPECT_FALSE(seen(views[1], frame, run.walls()).frame.solid) << "the flap is elsewhere";
}

TEST_F(ViewsOfAPipe, OpenedHasTheFarHalfOfWallAndFluidAndAllOfWhatStandsInIt) {
    const RunFolder run(folder_.path());
    const View view = cameras(run)[2];
    const RunFrame frame = run.read(0);
    const Seen shown = seen(view, frame, run.walls());
    std::size_t far_wall = 0, struts = 0;
    for (std::size_t i = 0; i < run.walls()->size(); ++i) {
        const Vec position = position_of(*run.walls(), i);
        if (run.walls()->part[i] == strut)
            ++struts;
        else if (position.y() >= -0.75 * dx && position.x() >= view.low && position.x() <= view.high)
            ++far_wall;
    }
    EXPECT_EQ(shown.walls->size(), far_wall) << "the eye is in front, at negative y";
    EXPECT_LT(far_wall, 0.6 * static_cast<double>(run.walls()->size()));
    EXPECT_EQ(shown.frame.bodies->size(), struts);
    EXPECT_EQ(shown.frame.solid->size(), frame.solid->size());
    for (const ParticleLayer& layer : layers_of(view, shown, "velocity", FieldRange().scale()))
        EXPECT_EQ(layer.radii.size(), layer.colour.size());
    for (const auto* group : {&shown.walls, &shown.frame.bodies, &shown.frame.solid, &shown.frame.fluid})
        for (std::size_t i = 0; i < (*group)->size(); ++i) EXPECT_TRUE(contains(view.area, position_of(**group, i), 2));
}

TEST(Views3d, AreNoLargerForAStrayParticle) {
    const TemporaryFolder folder, with_stray;
    write_run(folder, {pipe_frame(0), pipe_frame(1)});
    Frame last = pipe_frame(1);
    last.groups[0].position[1] = 1000;
    last.groups[1].position[1] = -1000;
    write_run(with_stray, {pipe_frame(0), last});
    const std::vector<View> views = cameras(RunFolder(folder.path()));
    const std::vector<View> others = cameras(RunFolder(with_stray.path()));
    ASSERT_EQ(views.size(), others.size());
    for (std::size_t k = 0; k < views.size(); ++k)
        EXPECT_NEAR((views[k].area.extent() - others[k].area.extent()).norm(), 0, 1e-3 * dx);
}

TEST(Views3d, CutWhatStandsInTheFluid) {
    // turned about the pipe's axis, the strut and the flap stand along y
    const auto turned = [](Frame frame) {
        for (FrameGroup& group : frame.groups)
            for (std::size_t i = 0; i < group.size(); ++i) {
                float* position = &group.position[3 * i];
                std::swap(position[1], position[2]);
                if (group.name == "solid") position[2] += 4 * dx;
            }
        return frame;
    };
    const TemporaryFolder folder;
    write_run(folder, {turned(pipe_frame(0))});
    const std::vector<View> views = cameras(RunFolder(folder.path()));
    ASSERT_EQ(views.size(), 3U);
    EXPECT_EQ(views[0].caption, "x right, y up, at z = 0 mm");
    EXPECT_THAT(views[1].caption, HasSubstr("z right, y up, at x = "));
}

TEST(Views3d, CutStrutsAcrossAndNotAlong) {
    // the plane y = 0 has a bar along the pipe, the plane z = 0 three struts that it joins
    Frame frame = pipe_frame(0);
    std::erase_if(frame.groups, [](const FrameGroup& group) { return group.name == "solid"; });
    FrameGroup& walls = frame.groups.back();
    for (int i = 5; i < 18; ++i) {
        add(walls, (static_cast<float>(i) + 0.5F) * dx, 0, 5 * dx, strut);
        for (int j = 0; i % 5 < 2 && j < 2; ++j)
            add(walls, (static_cast<float>(i) + 0.5F) * dx, static_cast<float>(4 + j) * dx, 0, strut);
    }
    const TemporaryFolder folder;
    write_run(folder, {frame});
    EXPECT_EQ(cameras(RunFolder(folder.path()))[0].caption, "x right, y up, at z = 0 mm");
}

TEST(Views3d, TakeTheLargerPlaneAndTheMiddleWhereNothingStandsInTheFluid) {
    Frame frame = pipe_frame(0);
    frame.groups.resize(1);
    for (std::size_t i = 0; i < frame.groups[0].size(); ++i) frame.groups[0].position[3 * i + 2] /= 2;
    const TemporaryFolder folder;
    write_run(folder, {frame});
    const std::vector<View> views = cameras(RunFolder(folder.path()));
    ASSERT_EQ(views.size(), 2U);
    EXPECT_EQ(views[0].caption, "x right, y up, at z = 0 mm");
    EXPECT_EQ(views[1].caption, "z right, y up, at x = 12 mm");
}

TEST(Views3d, CutAtAPlaneOfSymmetryAndLookFromOutside) {
    // the lower quarter of the pipe, on either side of y = 0
    for (const bool high : {false, true}) {
        SCOPED_TRACE(high);
        const float side = high ? -1 : 1;
        Frame quarter = pipe_frame(0);
        const std::vector<FrameGroup> whole = std::exchange(quarter.groups, {});
        for (const FrameGroup& group : whole) {
            if (group.name == "solid") continue;
            FrameGroup kept;
            kept.name = group.name;
            for (std::size_t i = 0; i < group.size(); ++i) {
                const Vec position = position_of(group, i);
                if (side * position.y() < -0.5 * dx || position.z() > 0.5 * dx) continue;
                const float* at = &group.position[3 * i];
                add(kept, at[0], at[1] + side * 0.5F * dx, at[2], group.part[i]);
            }
            quarter.groups.push_back(kept);
        }
        const TemporaryFolder folder;
        write_run(folder, {quarter});
        const RunFolder run(folder.path());
        std::array<std::array<bool, 2>, 3> mirrored{};
        mirrored[1].at(high ? 1 : 0) = true;
        const std::vector<View> views = cameras(run, mirrored);
        ASSERT_EQ(views.size(), 3U);
        EXPECT_EQ(views[0].caption, "x right, z up, at y = 0 mm");
        const RunFrame frame = run.read(0);
        const Seen cut = seen(views[0], frame, run.walls());
        EXPECT_EQ(ids(*cut.frame.fluid), in_slab(*frame.fluid, 1, 0, water));
        const Seen opened = seen(views[2], frame, run.walls());
        std::size_t near = 0;
        for (std::size_t i = 0; i < frame.fluid->size(); ++i) {
            const double x = position_of(*frame.fluid, i).x();
            near += x >= views[2].low && x <= views[2].high ? 1 : 0;
        }
        EXPECT_EQ(opened.frame.fluid->size(), near) << "all of it is behind the cut";
        EXPECT_GT(near, 400U);
    }
}

TEST(Views3d, AtSpringBodiesAloneAreAslant) {
    Frame frame = pipe_frame(1);
    frame.groups.erase(frame.groups.begin());
    add(frame.groups[0], 0, 5 * dx, 0, flap);
    const TemporaryFolder folder;
    write_run(folder, {frame});
    const RunFolder run(folder.path());
    const std::vector<View> views = cameras(run);
    ASSERT_EQ(views.size(), 1U);
    const Seen shown = seen(views[0], run.read(0), run.walls());
    EXPECT_FALSE(shown.frame.fluid);
    EXPECT_EQ(shown.frame.solid->size(), 8U);
}

/// Shares of the picture that are clearly red and clearly blue.
struct Shares {
    double red = 0, blue = 0;
};

Shares shares_of(const Image& image) {
    Shares shares;
    const double pixel = 1.0 / (image.width * image.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Colour colour = image.at(x, y);
            if (colour.red > colour.blue + 60) shares.red += pixel;
            if (colour.blue > colour.red + 60) shares.blue += pixel;
        }
    return shares;
}

class SpacePictures : public ViewsOfAPipe {
  protected:
    void SetUp() override {
        if (!display_.usable()) GTEST_SKIP() << display_.problem();
        ViewsOfAPipe::SetUp();
    }
    const VirtualDisplay display_;
};

TEST_F(SpacePictures, HaveTheFluidOfTheSlab) {
    const RunFolder run(folder_.path());
    const std::vector<View> views = cameras(run);
    RunFrame frame = run.read(0);
    // 1 in the slab, -1 elsewhere
    FrameField mark{"mark", "1", 1, {}};
    for (std::size_t i = 0; i < frame.fluid->size(); ++i)
        mark.values.push_back(std::abs(position_of(*frame.fluid, i).y()) <= 0.75 * dx ? 1.0F : -1.0F);
    frame.fluid->fields.push_back(mark);
    FieldRange range;
    range.include(frame, "mark");
    ParticleView renderer;
    const auto draw = [&](const View& view) {
        const int height = static_cast<int>(std::lround(300 * view.area.extent().y() / view.area.extent().x()));
        return renderer.draw(layers_of(view, seen(view, frame, run.walls()), "mark", range.scale()), view.area, 300,
                             height);
    };
    const Image along_the_pipe = draw(views[0]);
    const Shares cut = shares_of(along_the_pipe);
    EXPECT_EQ(cut.blue, 0);
    const double pipe_area = 24 * 13 - 2 * 4 - 4;  // less strut and flap, in dx^2
    const Vec size = views[0].area.extent() / dx;
    EXPECT_NEAR(cut.red, pipe_area / (size.x() * size.y()), 0.06);
    // no gap where there is water
    for (int x = 40; x < 260; ++x)
        ASSERT_NE(along_the_pipe.at(x, along_the_pipe.height / 2), colours::white) << "at " << x;

    const Shares section = shares_of(draw(views[1]));
    EXPECT_GT(section.red, 0.02) << "a strip along z";
    EXPECT_GT(section.blue, 3 * section.red);
}

TEST_F(SpacePictures, OfTheParticlesAtAPlaceShowTheOneNearestTheCut) {
    ParticleView view;
    for (const bool turned : {false, true}) {
        ParticleLayer layer;
        layer.radius = 1;
        layer.position = {0, 0, 0.2F, 0, 0, -0.7F};
        layer.colour = {{200, 0, 0}, {0, 0, 200}};
        if (turned) {
            std::swap(layer.position[2], layer.position[5]);
            std::swap(layer.colour[0], layer.colour[1]);
        }
        const Image image = view.draw({layer}, {Vec(-0.5, -0.5, 0), Vec(0.5, 0.5, 0)}, 40, 40);
        EXPECT_EQ(shares_of(image).blue, 0);
        EXPECT_NEAR(shares_of(image).red, 1, 0.01);
    }
}

TEST_F(SpacePictures, AreDrawnOfARunInTheFieldAskedFor) {
    for (const char* field : {"velocity", "pressure"}) {
        SCOPED_TRACE(field);
        const Pictures pictures = write_pictures(folder_.path(), {field, 500, 4});
        EXPECT_EQ(pictures.warning, "");
        EXPECT_THAT(pictures.files, ElementsAre("last_frame.png", "cycle.png"));
        for (const std::string& file : pictures.files)
            EXPECT_GT(std::filesystem::file_size(folder_.path() / file), 5000U) << file;
    }
    const RunFolder run(folder_.path());
    FieldRange speed, pressure;
    speed.include(run.read(1), "velocity");
    pressure.include(run.read(1), "pressure");
    const View view = cameras(run)[0];
    const Seen shown = seen(view, run.read(1), run.walls());
    const auto colours_of = [&](const char* field, const FieldRange& range) {
        const ColourScale scale = range.scale();
        const FrameField* values = find_field(*shown.frame.fluid, field);
        const ParticleLayer fluid = layers_of(view, shown, field, scale)[0];
        std::size_t right = 0;
        for (std::size_t i = 0; i < fluid.colour.size(); ++i) {
            double value = 0;
            for (int c = 0; c < values->components; ++c)
                value = std::hypot(value, values->values[values->components * i + c]);
            right += fluid.colour[i] == scale.map(value) ? 1 : 0;
        }
        return right == fluid.colour.size();
    };
    EXPECT_TRUE(colours_of("velocity", speed));
    EXPECT_TRUE(colours_of("pressure", pressure));
}

TEST_F(SpacePictures, SayWhatTheyCouldNotShow) {
    Frame last = pipe_frame(2);
    FrameGroup& fluid = last.groups[0];
    for (std::size_t i = 0; i < fluid.size(); ++i)
        if (std::abs(fluid.position[3 * i + 1]) < dx) fluid.position[3 * i + 1] = 2 * dx;
    fluid.position[1] = 1;  // metres behind
    write_run(folder_, {pipe_frame(0), last});
    const Pictures pictures = write_pictures(folder_.path(), {"velocity", 400, 4});
    EXPECT_THAT(pictures.warning,
                HasSubstr("last_frame.png: no fluid at t = 2 s in the slice with x right, z up, at y = 0 mm"));
    EXPECT_THAT(pictures.warning, HasSubstr("1 particles at t = 2 s lie outside the picture"));
}

}  // namespace
}  // namespace dmp::tests::space_pictures_tests
