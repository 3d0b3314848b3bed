// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/panel_layout.hpp"

#include <Eigen/LU>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "postproc/viewpoint.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::panel_layout_tests {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Box sized(double width, double height) { return {Vec(1, 2, 0), Vec(1 + width, 2 + height, 0)}; }

struct Outlined {
    int width = 0, height = 0;
};

/// Fills each drawing with a colour of its own; what is left of each on the panel.
struct Panel {
    std::vector<Outlined> drawn;
    Image image;
    std::vector<long> pixels;
};

Panel panel_of(const PanelLayout& layout, std::size_t count, int width) {
    Panel panel;
    panel.drawn.resize(count);
    const int height = static_cast<int>(std::lround(width * layout.area().extent().y() / layout.area().extent().x()));
    panel.image = layout.draw(width, height, [&](std::size_t k, int wide, int high) {
        panel.drawn[k] = {wide, high};
        Canvas canvas(wide, high);
        canvas.fill(0, 0, wide, high, {static_cast<std::uint8_t>(10 * k + 10), 200, 0});
        return canvas.image();
    });
    panel.pixels.assign(count, 0);
    for (int y = 0; y < panel.image.height; ++y)
        for (int x = 0; x < panel.image.width; ++x)
            for (std::size_t k = 0; k < count; ++k)
                if (panel.image.at(x, y) == Colour{static_cast<std::uint8_t>(10 * k + 10), 200, 0}) ++panel.pixels[k];
    return panel;
}

TEST(PanelLayout, OfOneDrawingIsThatDrawing) {
    const PanelLayout layout({{sized(4, 3), ""}});
    EXPECT_DOUBLE_EQ(layout.area().extent().x(), 4);
    EXPECT_DOUBLE_EQ(layout.area().extent().y(), 3);
    const Panel panel = panel_of(layout, 1, 400);
    EXPECT_EQ(panel.drawn[0].width, 400);
    EXPECT_EQ(panel.drawn[0].height, 300);
    EXPECT_EQ(panel.pixels[0], 400 * 300);
}

TEST(PanelLayout, DrawingsOfOneScaleDoNotCoverEachOther) {
    for (const double length : {0.2, 1.0, 3.0}) {
        SCOPED_TRACE(length);
        const PanelLayout layout({{sized(length, 1), "one"}, {sized(1, 1), "two"}, {sized(1.5, 1.4), "three"}});
        const Panel panel = panel_of(layout, 3, 800);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(1.0 * panel.drawn[k].width / panel.drawn[0].width, layout[k].area.extent().x() / length,
                        0.06 / length);
            EXPECT_EQ(panel.pixels[k], 1L * panel.drawn[k].width * panel.drawn[k].height);
            EXPECT_THAT(layout[k].caption, Not(HasSubstr(" : 1")));
        }
    }
}

TEST(PanelLayout, StandsInTheRowsThatShowMost) {
    // cubes beside each other, long ones below each other
    EXPECT_GT(PanelLayout({{sized(1, 1), ""}, {sized(1, 1), ""}}).area().extent().x(), 2);
    EXPECT_DOUBLE_EQ(PanelLayout({{sized(4, 1), ""}, {sized(4, 1), ""}}).area().extent().x(), 4);
}

TEST(PanelLayout, MagnifiesBelowALongDrawingAndSaysSo) {
    const PanelLayout layout({{sized(20, 1), "along"}, {sized(1, 1), "across"}});
    EXPECT_EQ(layout[0].caption, "along");
    EXPECT_EQ(layout[1].caption, "across, 5 : 1");
    const Panel panel = panel_of(layout, 2, 1000);
    EXPECT_NEAR(panel.drawn[1].height, 5 * panel.drawn[0].height, 3);
    EXPECT_EQ(panel.pixels[1], 1L * panel.drawn[1].width * panel.drawn[1].height);
}

TEST(Viewpoint, IsRightHandedWhicheverTheAxes) {
    for (const auto& [right, up] : {std::pair{0, 1}, {0, 2}, {1, 2}, {2, 1}}) {
        const Viewpoint front = along(right, up, Vec(1, 2, 3));
        for (const Viewpoint& view : {front, aslant(front)}) {
            EXPECT_NEAR(view.axes.determinant(), 1, 1e-12);
            EXPECT_NEAR((view.axes * view.axes.transpose() - Eigen::Matrix3d::Identity()).norm(), 0, 1e-12);
            EXPECT_NEAR(view(Vec(1, 2, 3)).norm(), 0, 1e-12);
            EXPECT_GT(view(Vec(1, 2, 3) + Vec::Unit(right)).x(), 0.5);
            EXPECT_GT(view(Vec(1, 2, 3) + Vec::Unit(up)).y(), 0.5);
        }
    }
    const Box box = along(0, 2)(Box{Vec(0, 0, 0), Vec(1, 2, 3)});
    EXPECT_NEAR((box.low - Vec(0, 0, -2)).norm(), 0, 1e-12) << "y runs away from the eye";
    EXPECT_NEAR((box.high - Vec(1, 3, 0)).norm(), 0, 1e-12);
}

TEST(Viewpoint, SaysWhereASliceLies) {
    EXPECT_EQ(slice_text(0, 2, Vec(1, -0.0025, 7), 0.03), "x right, z up, at y = -2.5 mm");
    EXPECT_EQ(slice_text(1, 2, Vec(1e-12, 0, 0), 0.03), "y right, z up, at x = 0 mm");
}

}  // namespace
}  // namespace dmp::tests::panel_layout_tests
