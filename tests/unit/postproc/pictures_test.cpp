// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/pictures.hpp"

#include <array>
#include <cstdlib>
#include <limits>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include "base/errors.hpp"
#include "postproc/canvas.hpp"
#include "postproc/frame_scene.hpp"
#include "postproc/measure_plot.hpp"
#include "postproc/tables.hpp"
#include "postproc/virtual_display.hpp"
#include "postproc/vtk_sink.hpp"
#include "synthetic_run.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::pictures_tests {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const PictureOptions small{"velocity", 400, 4};

/// Puts an environment variable back at the end of the test.
class Environment {
  public:
    Environment(const char* name, const char* value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        if (value != nullptr)
            setenv(name, value, 1);
        else
            unsetenv(name);
    }
    ~Environment() {
        if (before_)
            setenv(name_, before_->c_str(), 1);
        else
            unsetenv(name_);
    }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    const char* name_;
    std::optional<std::string> before_;
};

void write_run(const fs::path& folder, int frames) {
    VtkSink sink(folder, {"Channel", "0123456789abcdef", "0.1.0"});
    MeasureSeries measures{{"flux"}, {"m^2/s"}, {}, {}};
    for (int k = 0; k < frames; ++k) {
        sink.write(channel_frame(0.1 * k, k == 0));
        measures.time.push_back(0.1 * k);
        measures.rows.push_back({0.5 * k});
    }
    write_measures_csv(folder, measures);
}

Image read_png(const fs::path& file) {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    int size[3];
    reader->GetOutput()->GetDimensions(size);
    Image image{size[0], size[1], {}};
    for (int y = size[1] - 1; y >= 0; --y)
        for (int x = 0; x < size[0]; ++x) {
            std::uint32_t pixel = 0;
            for (int c = 0; c < 3; ++c)
                pixel = pixel << 8 |
                        static_cast<std::uint32_t>(reader->GetOutput()->GetScalarComponentAsDouble(x, y, 0, c));
            image.pixels.push_back(pixel);
        }
    return image;
}

double share_of(const Image& image, const std::function<bool(Colour)>& wanted) {
    int count = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) count += wanted(image.at(x, y)) ? 1 : 0;
    return static_cast<double>(count) / (image.width * image.height);
}

bool is_white(Colour c) { return c == colours::white; }

class PicturesWithDisplay : public ::testing::Test {
  protected:
    void SetUp() override {
        if (const VirtualDisplay display; !display.usable()) GTEST_SKIP() << display.problem();
    }
};

TEST_F(PicturesWithDisplay, AreDrawnFromTheFolderAlone) {
    const TemporaryFolder folder;
    write_run(folder.path(), 9);
    const Pictures pictures = write_pictures(folder.path(), small);
    EXPECT_EQ(pictures.warning, "");
    EXPECT_THAT(pictures.files, ElementsAre("last_frame.png", "cycle.png", "measures.png"));
    for (const std::string& file : pictures.files) {
        SCOPED_TRACE(file);
        const Image image = read_png(folder.path() / file);
        EXPECT_LE(image.width, 400);
        EXPECT_GE(image.width, 200);  // a sheet is narrower where its height is the limit
        EXPECT_GT(image.height, 60);
        EXPECT_LT(image.height, 500);
    }
    EXPECT_GT(distinct_colours(read_png(folder.path() / "last_frame.png")), 300U);
    EXPECT_GT(distinct_colours(read_png(folder.path() / "cycle.png")), 300U);
}

TEST_F(PicturesWithDisplay, FluidWallsAndSolidsCoverWhatTheyShould) {
    const TemporaryFolder folder;
    write_run(folder.path(), 2);
    write_pictures(folder.path(), small);
    const Image image = read_png(folder.path() / "last_frame.png");
    // the picture: 42 x 16 spacings (a margin of one and half a disc), 380 pixels wide below a title of 21
    const double per_spacing = 380.0 / 41;
    const double drawing = 380 * 15 * per_spacing / (static_cast<double>(image.width) * image.height);
    const double covered = 1 - share_of(image, is_white);
    EXPECT_GT(covered, 0.85 * drawing);
    EXPECT_LT(covered, drawing + 0.15);
    const auto close_to = [](Colour wanted) {
        return [wanted](Colour c) {
            return std::abs(c.red - wanted.red) + std::abs(c.green - wanted.green) + std::abs(c.blue - wanted.blue) <
                   12;
        };
    };
    const double pixels = static_cast<double>(image.width) * image.height;
    EXPECT_NEAR(share_of(image, close_to(colours::solid)) * pixels / (per_spacing * per_spacing), 9, 2.5);
    EXPECT_NEAR(share_of(image, close_to(colours::wall)) * pixels / (per_spacing * per_spacing), 160, 40);
}

TEST_F(PicturesWithDisplay, FluidHasNoGaps) {
    const TemporaryFolder folder;
    write_run(folder.path(), 2);
    write_pictures(folder.path(), small);
    const Image image = read_png(folder.path() / "last_frame.png");
    const int middle = 21 + static_cast<int>(0.5 * 15 * 380 / 41);
    for (int y = middle - 30; y < middle + 30; ++y)
        for (int x = 30; x < 370; ++x) ASSERT_FALSE(is_white(image.at(x, y))) << x << ", " << y;
}

TEST_F(PicturesWithDisplay, PressureIsBlueToRed) {
    const TemporaryFolder folder;
    write_run(folder.path(), 1);
    const Pictures pictures = write_pictures(folder.path(), {"pressure", 400, 4});
    EXPECT_THAT(pictures.files, ElementsAre("last_frame.png", "measures.png"));
    const Image image = read_png(folder.path() / "last_frame.png");
    const int middle = 21 + static_cast<int>(0.5 * 15 * 380 / 41);
    EXPECT_GT(image.at(30, middle).red, image.at(30, middle).blue + 60);  // +20 Pa on the left
    EXPECT_GT(image.at(370, middle).blue, image.at(370, middle).red + 60);
}

TEST_F(PicturesWithDisplay, SayWhatTheyCouldNotShow) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), {"Channel", "", ""});
    sink.write(channel_frame(0, true));
    Frame last = channel_frame(1, false);
    last.groups[0].position[0] = 1000;
    last.groups[0].position[3] = std::numeric_limits<float>::quiet_NaN();
    sink.write(last);
    const Pictures pictures = write_pictures(folder.path(), {"temperature", 300, 4});
    EXPECT_THAT(pictures.warning, HasSubstr("2 particles at t = 1 s lie outside the picture"));
    EXPECT_THAT(pictures.warning, HasSubstr("no field 'temperature'"));
    EXPECT_THAT(pictures.files, ElementsAre("last_frame.png", "cycle.png"));
    EXPECT_GT(1 - share_of(read_png(folder.path() / "last_frame.png"), is_white), 0.3);
}

TEST_F(PicturesWithDisplay, AnUnusableDisplayIsReplacedAndPutBack) {
    const Environment display("DISPLAY", ":32123");
    pid_t server = -1;
    {
        const VirtualDisplay virtual_display;
        ASSERT_TRUE(virtual_display.usable());
        server = virtual_display.server();
        ASSERT_GT(server, 0);
        EXPECT_EQ(kill(server, 0), 0);
        EXPECT_STRNE(std::getenv("DISPLAY"), ":32123");
        const VirtualDisplay second;  // the first one serves
        EXPECT_EQ(second.server(), -1);
    }
    EXPECT_EQ(kill(server, 0), -1);
    EXPECT_STREQ(std::getenv("DISPLAY"), ":32123");
}

TEST(Pictures, WithoutXvfbOnlyMeasuresAreDrawnAndThatIsSaid) {
    const TemporaryFolder folder;
    write_run(folder.path(), 2);
    const Environment display("DISPLAY", nullptr);
    const Environment path("PATH", "/nowhere");
    const Pictures pictures = write_pictures(folder.path(), small);
    EXPECT_THAT(pictures.files, ElementsAre("measures.png"));
    EXPECT_THAT(pictures.warning, HasSubstr("apt install xvfb"));
    EXPECT_FALSE(fs::exists(folder.path() / "last_frame.png"));
}

TEST(Pictures, NeedARunsFolder) {
    const TemporaryFolder folder;
    EXPECT_THROW(write_pictures(folder.path(), small), InputError);
    write_run(folder.path(), 2);
    fs::resize_file(folder.path() / "frames/fluid_000001.vtp", 500);
    EXPECT_THROW(write_pictures(folder.path(), small), InputError);
}

TEST(Pictures, DoNotDrawBondsRoundAPeriodicBorder) {
    RunFrame frame;
    frame.spacing = 1;
    frame.fluid.emplace();
    frame.solid.emplace();
    frame.fluid->position = {0, 0, 0, 9, 4, 0};
    frame.fluid->id = {0, 1};
    frame.solid->position = {0.5F, 1, 0, 1.5F, 1, 0, 8.5F, 1, 0};
    frame.solid->id = {2, 3, 4};
    frame.solid->bond_ends = {0, 1, 0, 2};
    RunFrame without_fluid = frame;
    without_fluid.fluid.reset();
    leave_out_bonds_round_borders(frame);
    EXPECT_THAT(layers_of(frame, {}, "velocity", FieldRange().scale()).back().lines, ElementsAre(0, 1));
    leave_out_bonds_round_borders(without_fluid);
    EXPECT_THAT(layers_of(without_fluid, {}, "velocity", FieldRange().scale()).back().lines, ElementsAre(0, 1, 0, 2))
        << "as nobody knows";
}

TEST(Canvas, DrawsWhereItIsTold) {
    Canvas canvas(100, 60);
    canvas.fill(10, 20, 30, 5, {10, 20, 30});
    EXPECT_EQ(canvas.image().at(10, 20), (Colour{10, 20, 30}));
    EXPECT_EQ(canvas.image().at(39, 24), (Colour{10, 20, 30}));
    EXPECT_EQ(canvas.image().at(40, 24), colours::white);
    EXPECT_EQ(canvas.image().at(39, 25), colours::white);
    canvas.line({{{50.5, 5.5}}, {{50.5, 50.5}}}, {0, 0, 255}, 1);
    EXPECT_EQ(canvas.image().at(50, 30), (Colour{0, 0, 255}));
    EXPECT_EQ(canvas.image().at(52, 30), colours::white);
    canvas.triangle({{{60, 0}, {90, 0}, {60, 30}}}, {0, 255, 0});
    EXPECT_EQ(canvas.image().at(65, 5), (Colour{0, 255, 0}));
    EXPECT_EQ(canvas.image().at(88, 28), colours::white);
    canvas.line({{{-50, -50}}, {{200, 200}}}, {0, 0, 0}, 3);  // what falls off the sheet is harmless
}

TEST(Canvas, LinesOfManyPointsAreWholeAndOnePointIsADot) {
    Canvas canvas(400, 40);
    std::vector<std::array<double, 2>> points;
    for (int k = 0; k <= 380; ++k) points.push_back({10.0 + k, 20.5});
    canvas.line(points, {0, 0, 255}, 3);
    for (int x = 10; x < 390; ++x) EXPECT_EQ(canvas.image().at(x, 20), (Colour{0, 0, 255})) << x;
    canvas.line({{{200.5, 8.5}}}, {255, 0, 0}, 7);
    EXPECT_EQ(canvas.image().at(200, 8), (Colour{255, 0, 0}));
    EXPECT_EQ(canvas.image().at(201, 9), (Colour{255, 0, 0}));
    EXPECT_EQ(canvas.image().at(204, 12), colours::white);
}

TEST(Canvas, PastesWholePixels) {
    Canvas tile(3, 2);
    tile.fill(0, 0, 2, 2, {10, 20, 30});
    Canvas canvas(10, 10);
    canvas.paste(tile.image(), 8, 4);
    EXPECT_EQ(canvas.image().at(8, 4), (Colour{10, 20, 30}));
    EXPECT_EQ(canvas.image().at(9, 5), (Colour{10, 20, 30}));
    EXPECT_EQ(canvas.image().at(7, 4), colours::white);
    EXPECT_EQ(canvas.image().at(8, 6), colours::white);
    canvas.paste({}, 0, 0);  // nothing
    canvas.fill(0, 0, 1, 1, {1, 2, 3});
    EXPECT_EQ(canvas.image().at(0, 0), (Colour{1, 2, 3}));
}

TEST(Canvas, ThatIsTooLargeIsAnError) { EXPECT_THROW(Canvas(40'000, 1), ResourceError); }

/// The rows in which a column of the picture shows the curve's colour.
std::vector<int> rows_of_curve(const Image& image, int x) {
    std::vector<int> rows;
    for (int y = 0; y < image.height; ++y)
        if (const Colour c = image.at(x, y); c.blue > 140 && c.red < 90) rows.push_back(y);
    return rows;
}

TEST(MeasurePlot, CurvesRiseWithTheirValuesAndStopWhereTheyAreMissing) {
    MeasureSeries measures{{"flux"}, {"m^2/s"}, {}, {}};
    for (int k = 0; k <= 100; ++k) {
        measures.time.push_back(0.01 * k);
        measures.rows.push_back({k < 45 || k > 55 ? 101325 + 1e-3 * k : std::numeric_limits<double>::quiet_NaN()});
    }
    const Image image = draw_measures(measures, "A title", 1600).image();
    EXPECT_EQ(image.width, 1600);
    EXPECT_EQ(image.height, 84 + 300 + 90);
    // the panel: from 140 to 1550 and from 124 to 348; 8 % of the values' range stay free above and below
    const auto expected = [](double share) { return 348 - 224 * (share + 0.08) / 1.16; };
    for (const double share : {0.1, 0.3, 0.7, 0.9}) {
        const std::vector<int> rows = rows_of_curve(image, 140 + static_cast<int>(1410 * share));
        ASSERT_FALSE(rows.empty()) << share;
        EXPECT_NEAR((rows.front() + rows.back()) / 2.0, expected(share), 1.5) << share;
    }
    EXPECT_TRUE(rows_of_curve(image, 140 + 1410 / 2).empty());
}

TEST(MeasurePlot, OfAHundredAndTwentyMeasuresFitsOnACanvas) {
    MeasureSeries measures{std::vector<std::string>(120, "flux"), std::vector<std::string>(120, "m^2/s"), {0, 1}, {}};
    measures.rows.assign(2, std::vector<double>(120, 1));
    const Canvas canvas = draw_measures(measures, "A title", 1600);
    EXPECT_LE(canvas.image().height, Canvas::largest);
    EXPECT_GT(canvas.image().height, Canvas::largest - 2);
    EXPECT_NEAR(canvas.image().width, 1600.0 * Canvas::largest / (174 + 300 * 120), 1);
}

TEST(Canvas, TextHasInkWhereItsEndsSay) {
    Canvas canvas(200, 40);
    canvas.text(190, 20, "25 mm", {20, Align::right});
    const double width = Canvas::text_width("25 mm", {20, Align::right});
    EXPECT_GT(width, 40);
    EXPECT_LT(width, 90);
    int first = 200, last = 0, top = 40, bottom = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 200; ++x)
            if (canvas.image().at(x, y) != colours::white) {
                first = std::min(first, x);
                last = std::max(last, x);
                top = std::min(top, y);
                bottom = std::max(bottom, y);
            }
    EXPECT_NEAR(first, 190 - width, 3);
    EXPECT_NEAR(last, 189, 3);
    EXPECT_NEAR((top + bottom) / 2.0, 20, 4);
}

TEST(Canvas, LongTextsShrinkToTheirRoom) {
    Canvas canvas(300, 40);
    canvas.text_within(100, 10, 20, "A title that is longer than the sheet is wide, by far", {20});
    int last = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 300; ++x)
            if (canvas.image().at(x, y) != colours::white) last = std::max(last, x);
    EXPECT_GT(last, 60);
    EXPECT_LT(last, 125);  // sizes are whole pixels
}

TEST(Canvas, CountsColours) {
    Canvas canvas(10, 10);
    EXPECT_EQ(distinct_colours(canvas.image()), 1U);
    canvas.fill(0, 0, 2, 2, {1, 2, 3});
    canvas.fill(4, 4, 2, 2, {3, 2, 1});
    EXPECT_EQ(distinct_colours(canvas.image()), 3U);
    EXPECT_EQ(distinct_colours(canvas.image(), 2), 2U);
}

}  // namespace
}  // namespace dmp::tests::pictures_tests
