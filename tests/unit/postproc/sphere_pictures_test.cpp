// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Spheres in files for ParaView and in pictures.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "postproc/particle_view.hpp"
#include "postproc/pictures.hpp"
#include "postproc/virtual_display.hpp"
#include "postproc/vtk_sink.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::sphere_pictures_tests {
namespace {

using ::testing::ElementsAre;

constexpr Colour red{200, 0, 0}, blue{0, 0, 200};

/// How many pixels are mainly of each of the two colours.
struct Count {
    double red = 0, blue = 0;
};

Count count_pixels(const Image& image) {
    Count count;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Colour colour = image.at(x, y);
            if (colour.red > 1.5 * colour.blue) ++count.red;
            if (colour.blue > 1.5 * colour.red) ++count.blue;
        }
    return count;
}

ParticleLayer sphere(const std::vector<float>& centre, float radius, Colour colour) {
    ParticleLayer layer;
    layer.position = centre;
    layer.colour = {colour};
    layer.radii = {radius};
    return layer;
}

TEST(SpherePictures, show_spheres_of_their_size_the_nearer_before_the_farther) {
    const VirtualDisplay display;
    if (!display.usable()) GTEST_SKIP() << display.problem();
    ParticleView view;
    const Box area{Vec(-2, -1, 0), Vec(2, 1, 0)};
    const double pixels = 400.0 * 200.0, whole = 8;
    const auto disc = [&](double radius) { return std::numbers::pi * radius * radius / whole * pixels; };
    const Count alone = count_pixels(view.draw({sphere({0, 0, 5}, 0.8F, red)}, area, 400, 200));
    EXPECT_NEAR(alone.red, disc(0.8), 0.02 * disc(0.8));
    EXPECT_EQ(alone.blue, 0);

    const ParticleLayer large = sphere({0, 0, 0}, 0.8F, red);
    const Count before = count_pixels(view.draw({large, sphere({0, 0, 1}, 0.3F, blue)}, area, 400, 200));
    EXPECT_NEAR(before.blue, disc(0.3), 0.03 * disc(0.3));
    EXPECT_NEAR(before.red, disc(0.8) - disc(0.3), 0.03 * disc(0.8));
    const Count behind = count_pixels(view.draw({large, sphere({0, 0, -1}, 0.3F, blue)}, area, 400, 200));
    EXPECT_EQ(behind.blue, 0);

    // A wall between the eye and the sphere lets it shine through.
    ParticleLayer wall;
    wall.position = {-2, -1, 1, 2, -1, 1, 0, 3, 1};
    wall.colour = {colours::wall, colours::wall, colours::wall};
    wall.triangles = {0, 1, 2};
    const Image through = view.draw({wall, large}, area, 400, 200);
    const Colour middle = through.at(200, 100), corner = through.at(2, 2);
    EXPECT_GT(middle.red, middle.blue + 40);
    EXPECT_GT(middle.blue, 40) << "the wall's grey lies over it";
    EXPECT_EQ(corner, colours::white);
}

Frame carrier_frame(double time) {
    Frame frame;
    frame.time = time;
    frame.spacing = 0.1;
    frame.parts = {"carrier", "drug", "floor"};
    FrameGroup spheres;
    spheres.name = "spheres";
    spheres.position = {0, 0, 2, 0, -1.1F, 2, static_cast<float>(1.1 + time), 0, 2};
    spheres.id = {0, 1, 2};
    spheres.part = {0, 1, 1};
    spheres.fields = {{"radius", "m", 1, {1, 0.1F, 0.1F}}, {"velocity", "m/s", 3, {0, 0, -1, 0, 0, -1, 1, 0, -1}}};
    FrameGroup walls;
    walls.name = "walls";
    walls.position = {-2, -2, 0, 2, -2, 0, 2, 2, 0, -2, 2, 0};
    walls.id = {0, 1, 2, 3};
    walls.part = {2, 2, 2, 2};
    walls.triangles = {0, 1, 2, 0, 2, 3};
    frame.groups = {spheres, walls};
    return frame;
}

TEST(SphereFiles, have_the_radius_at_each_point_and_walls_of_triangles) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), {"Impact", "0", "0"});
    sink.write(carrier_frame(0));
    sink.write(carrier_frame(1));
    EXPECT_THAT(sink.files(), ElementsAre("spheres.pvd", "walls.vtp", "open_in_paraview.py"));
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName((folder.path() / "frames/spheres_000001.vtp").c_str());
    reader->Update();
    ASSERT_NE(reader->GetOutput()->GetPointData()->GetArray("radius"), nullptr);
    EXPECT_EQ(reader->GetOutput()->GetPointData()->GetArray("radius")->GetComponent(0, 0), 1);
    EXPECT_FLOAT_EQ(static_cast<float>(reader->GetOutput()->GetPoint(2)[0]), 2.1F);
    reader->SetFileName((folder.path() / "walls.vtp").c_str());
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), 2);

    VtkSink again(folder.path(), {"Impact", "0", "0"});
    again.go_on(1);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "frames/spheres_000001.vtp")) << "later frames go";
    again.write(carrier_frame(2));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "frames/spheres_000001.vtp"));
}

TEST(SpherePictures, are_drawn_of_a_run_in_space) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), {"Impact", "0", "0"});
    sink.write(carrier_frame(0));
    sink.write(carrier_frame(1));
    const Pictures pictures = write_pictures(folder.path(), {"velocity", 600, 2});
    const VirtualDisplay display;
    if (!display.usable()) GTEST_SKIP() << display.problem();
    EXPECT_EQ(pictures.warning, "");
    EXPECT_THAT(pictures.files, ElementsAre("last_frame.png", "cycle.png"));
}

}  // namespace
}  // namespace dmp::tests::sphere_pictures_tests
