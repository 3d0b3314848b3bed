// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/vtk_sink.hpp"

#include <fstream>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "postproc/read_frames.hpp"
#include "synthetic_run.hpp"
#include "tests/modules.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::vtk_sink_tests {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const RunLabel label{"Channel with a flap", "0123456789abcdef", "0.1.0"};

/// VTK's own reader on a file.
class Opened {
  public:
    explicit Opened(const fs::path& file) {
        reader_->SetFileName(file.c_str());
        reader_->Update();
    }
    vtkPolyData& data() { return *reader_->GetOutput(); }
    std::string text(const char* name, vtkIdType entry = 0) {
        auto* array = vtkStringArray::SafeDownCast(data().GetFieldData()->GetAbstractArray(name));
        return array != nullptr && entry < array->GetNumberOfValues() ? std::string(array->GetValue(entry)) : "none";
    }
    double number(const char* name) {
        vtkDataArray* array = data().GetFieldData()->GetArray(name);
        return array != nullptr ? array->GetComponent(0, 0) : std::numeric_limits<double>::quiet_NaN();
    }

  private:
    vtkNew<vtkXMLPolyDataReader> reader_;
};

std::vector<std::string> names_of(vtkFieldData& arrays) {
    std::vector<std::string> names;
    names.reserve(static_cast<std::size_t>(arrays.GetNumberOfArrays()));
    for (int i = 0; i < arrays.GetNumberOfArrays(); ++i) names.emplace_back(arrays.GetArrayName(i));
    return names;
}

TEST(VtkSink, FluidComesBackAsWritten) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path() / "out", label);
    const Frame frame = channel_frame(0.125, true);
    sink.write(frame);

    Opened file(folder.path() / "out/frames/fluid_000000.vtp");
    vtkPolyData& data = file.data();
    const FrameGroup& fluid = frame.groups[0];
    ASSERT_EQ(data.GetNumberOfPoints(), 400);
    EXPECT_EQ(data.GetNumberOfVerts(), 400);
    EXPECT_EQ(data.GetNumberOfLines(), 0);
    EXPECT_THAT(names_of(*data.GetPointData()), ElementsAre("id", "part", "velocity", "pressure"));
    EXPECT_THAT(names_of(*data.GetCellData()), ElementsAre());
    vtkDataArray* velocity = data.GetPointData()->GetArray("velocity");
    EXPECT_EQ(velocity->GetDataType(), VTK_FLOAT);
    ASSERT_EQ(velocity->GetNumberOfComponents(), 3);
    EXPECT_STREQ(velocity->GetComponentName(0), "x");
    EXPECT_STREQ(velocity->GetComponentName(2), "z");
    EXPECT_EQ(data.GetPointData()->GetArray("id")->GetDataTypeSize(), 8);
    EXPECT_EQ(data.GetPointData()->GetArray("part")->GetDataTypeSize(), 4);
    for (vtkIdType i = 0; i < 400; ++i) {
        const auto k = static_cast<std::size_t>(i);
        EXPECT_EQ(data.GetPointData()->GetArray("id")->GetComponent(i, 0), static_cast<double>(fluid.id[k]));
        EXPECT_EQ(data.GetPointData()->GetArray("pressure")->GetComponent(i, 0), fluid.fields[1].values[k]);
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t c = 3 * k + static_cast<std::size_t>(axis);
            EXPECT_EQ(velocity->GetComponent(i, axis), fluid.fields[0].values[c]);
            EXPECT_EQ(data.GetPoint(i)[axis], fluid.position[c]);
        }
    }
}

TEST(VtkSink, TensorsHaveTheComponentsThatParaViewKnows) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), label);
    Frame frame = channel_frame(0.125, false);
    for (const std::size_t number : {0, 1}) {
        FrameGroup& group = frame.groups[number];
        FrameField stress{"stress", "Pa", 6, {}};
        for (std::size_t k = 0; k < 6 * group.size(); ++k) stress.values.push_back(0.5F * static_cast<float>(k));
        group.fields.push_back(stress);
    }
    sink.write(frame);
    for (const auto& [name, group] : {std::pair{"fluid", frame.groups[0]}, std::pair{"solid", frame.groups[1]}}) {
        const fs::path file = folder.path() / ("frames/" + std::string(name) + "_000000.vtp");
        Opened opened(file);
        vtkDataArray* stress = opened.data().GetPointData()->GetArray("stress");
        ASSERT_NE(stress, nullptr) << name;
        ASSERT_EQ(stress->GetNumberOfComponents(), 6);
        std::vector<std::string> components(6);
        for (int c = 0; c < 6; ++c) components[static_cast<std::size_t>(c)] = stress->GetComponentName(c);
        EXPECT_THAT(components, ElementsAre("XX", "YY", "ZZ", "XY", "YZ", "XZ"));
        for (vtkIdType i = 0; i < stress->GetNumberOfTuples(); ++i)
            for (int c = 0; c < 6; ++c) EXPECT_EQ(stress->GetComponent(i, c), 0.5 * static_cast<double>(6 * i + c));
        EXPECT_EQ(opened.text("units:stress"), "Pa");
        const FrameField read = read_frame(file, name).frame.groups[0].fields.back();
        EXPECT_EQ(read.components, 6);
        EXPECT_EQ(read.values, group.fields.back().values);
    }
}

TEST(VtkSink, BondsAreLineCellsAfterTheVertices) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), label);
    sink.write(channel_frame(0.125, true));

    Opened file(folder.path() / "frames/solid_000000.vtp");
    vtkPolyData& data = file.data();
    ASSERT_EQ(data.GetNumberOfPoints(), 9);
    ASSERT_EQ(data.GetNumberOfVerts(), 9);
    ASSERT_EQ(data.GetNumberOfLines(), 8);
    EXPECT_THAT(names_of(*data.GetCellData()), ElementsAre("is_bond", "strain"));
    for (vtkIdType cell = 0; cell < 17; ++cell) {
        const bool bond = cell >= 9;
        EXPECT_EQ(data.GetCellData()->GetArray("is_bond")->GetComponent(cell, 0), bond ? 1 : 0);
        const float strain = bond ? 0.01F * static_cast<float>(cell - 8) : 0.0F;
        EXPECT_EQ(data.GetCellData()->GetArray("strain")->GetComponent(cell, 0), strain);
    }
    vtkNew<vtkIdList> ends;
    data.GetCellPoints(12, ends);
    ASSERT_EQ(ends->GetNumberOfIds(), 2);
    EXPECT_EQ(ends->GetId(0), 3);
    EXPECT_EQ(ends->GetId(1), 4);
}

TEST(VtkSink, SolidWithoutBondsKeepsItsCellArrays) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), label);
    Frame frame = channel_frame(1, false);
    frame.groups[1].bond_ends.clear();
    frame.groups[1].bond_fields[0].values.clear();
    sink.write(frame);
    Opened file(folder.path() / "frames/solid_000000.vtp");
    EXPECT_EQ(file.data().GetNumberOfLines(), 0);
    EXPECT_THAT(names_of(*file.data().GetCellData()), ElementsAre("is_bond", "strain"));
}

TEST(VtkSink, FieldDataSaysWhenWhatAndInWhichUnit) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), label);
    sink.write(channel_frame(0.125, true));
    Opened fluid(folder.path() / "frames/fluid_000000.vtp");
    EXPECT_EQ(fluid.number("TimeValue"), 0.125);
    EXPECT_EQ(fluid.number("Step"), 125);
    EXPECT_EQ(fluid.number("spacing"), 0.001);
    EXPECT_EQ(fluid.text("units:velocity"), "m/s");
    EXPECT_EQ(fluid.text("units:pressure"), "Pa");
    EXPECT_EQ(fluid.text("units:position"), "m");
    EXPECT_EQ(fluid.text("part_names", 0), "water");
    EXPECT_EQ(fluid.text("part_names", 2), "flap");
    EXPECT_EQ(fluid.text("title"), "Channel with a flap");
    EXPECT_EQ(fluid.text("scene_hash"), "0123456789abcdef");
    EXPECT_EQ(fluid.text("dmp_version"), "0.1.0");
    Opened solid(folder.path() / "frames/solid_000000.vtp");
    EXPECT_EQ(solid.text("units:strain"), "1");
}

TEST(VtkSink, FilesAreInlineBinaryWithLz4) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), label);
    sink.write(channel_frame(0, true));
    const std::string text = read_file(folder.path() / "frames/fluid_000000.vtp");
    EXPECT_THAT(text, HasSubstr("compressor=\"vtkLZ4DataCompressor\""));
    EXPECT_THAT(text, HasSubstr("header_type=\"UInt64\""));
    EXPECT_THAT(text, HasSubstr("format=\"binary\""));
    EXPECT_THAT(text, Not(HasSubstr("format=\"appended\"")));
    EXPECT_THAT(text, Not(HasSubstr("<AppendedData")));
}

TEST(VtkSink, SeriesListsEachFrameWithItsExactTime) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), label);
    const std::vector<double> times{0, 0.1, 0.30000000000000004, 1e-9 + 1};
    for (std::size_t k = 0; k < times.size(); ++k) {
        sink.write(channel_frame(times[k], k == 0));
        for (const char* name : {"fluid.pvd", "solid.pvd"}) {
            const std::vector<SeriesEntry> series = read_series(folder.path() / name);
            ASSERT_EQ(series.size(), k + 1);
            for (std::size_t i = 0; i <= k; ++i) {
                EXPECT_EQ(series[i].time, times[i]);
                EXPECT_GT(Opened(series[i].file).data().GetNumberOfPoints(), 0);
            }
        }
    }
    EXPECT_THAT(files_in(folder.path()),
                ElementsAre("fluid.pvd", "frames", "open_in_paraview.py", "solid.pvd", "walls.vtp"));
    EXPECT_THAT(sink.files(), ElementsAre("fluid.pvd", "solid.pvd", "walls.vtp", "open_in_paraview.py"));
    EXPECT_EQ(sink.frames(), 4);
    EXPECT_THAT(read_file(folder.path() / "fluid.pvd"),
                StartsWith("<?xml version=\"1.0\"?>\n"
                           "<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                           "  <Collection>\n"
                           "    <DataSet timestep=\"0\" part=\"0\" file=\"frames/fluid_000000.vtp\"/>\n"
                           "    <DataSet timestep=\"0.1\" part=\"0\" file=\"frames/fluid_000001.vtp\"/>\n"));
}

TEST(VtkSink, WallsAreWrittenOnce) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), label);
    sink.write(channel_frame(0, true));
    EXPECT_EQ(Opened(folder.path() / "walls.vtp").data().GetNumberOfPoints(), 160);
    fs::remove(folder.path() / "walls.vtp");
    sink.write(channel_frame(1, true));
    EXPECT_FALSE(fs::exists(folder.path() / "walls.vtp"));
}

TEST(VtkSink, EmptyGroupsAreSkipped) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), label);
    Frame frame = channel_frame(0, false);
    frame.groups[1] = FrameGroup{"solid", {}, {}, {}, {}, {}, {}};
    sink.write(frame);
    EXPECT_THAT(files_in(folder.path() / "frames"), ElementsAre("fluid_000000.vtp"));
    EXPECT_FALSE(fs::exists(folder.path() / "solid.pvd"));
}

TEST(VtkSink, AnEarlierRunsFramesDoNotMixWithTheNew) {
    const TemporaryFolder folder;
    {
        VtkSink sink(folder.path(), label);
        for (int k = 0; k < 3; ++k) sink.write(channel_frame(k, k == 0));
    }
    std::ofstream(folder.path() / "frames/notes.txt") << "mine";
    VtkSink sink(folder.path(), label);
    EXPECT_EQ(read_series(folder.path() / "fluid.pvd").size(), 3U);  // nothing is removed before there is a new frame
    sink.write(channel_frame(5, false));
    EXPECT_THAT(files_in(folder.path() / "frames"), ElementsAre("fluid_000000.vtp", "notes.txt", "solid_000000.vtp"));
    EXPECT_FALSE(fs::exists(folder.path() / "walls.vtp"));
    ASSERT_EQ(read_series(folder.path() / "fluid.pvd").size(), 1U);
    EXPECT_EQ(read_series(folder.path() / "fluid.pvd")[0].time, 5);
}

TEST(VtkSink, GoesOnWhereSolidsCameLateAndNotWhereFramesAreMissing) {
    const TemporaryFolder folder;
    {
        VtkSink sink(folder.path(), label);
        for (int k = 0; k < 4; ++k) {
            Frame frame = channel_frame(0.1 * k, k == 0);
            if (k < 2) std::erase_if(frame.groups, [](const FrameGroup& group) { return group.name == "solid"; });
            sink.write(frame);
        }
    }
    const auto problem = [&](long frames) {
        VtkSink sink(folder.path(), label);
        return text_thrown<InputError>([&] { sink.go_on(frames); });
    };
    EXPECT_THAT(problem(5), HasSubstr("the series lists fewer frames than the run has written"));
    VtkSink sink(folder.path(), label);
    sink.go_on(3);
    sink.write(channel_frame(0.35, false));
    EXPECT_EQ(sink.frames(), 4);
    const std::string series = read_file(folder.path() / "solid.pvd");
    EXPECT_THAT(series, HasSubstr("solid_000002.vtp"));
    EXPECT_THAT(series, HasSubstr("timestep=\"0.35\" part=\"0\" file=\"frames/solid_000003.vtp\""));
    EXPECT_THAT(series, Not(HasSubstr("solid_000001")));
    fs::remove(folder.path() / "solid.pvd");
    VtkSink liquid(folder.path(), label);
    liquid.go_on(2);
}

TEST(VtkSink, FolderBelowAFileIsAnInputError) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "file") << "x";
    try {
        const VtkSink sink(folder.path() / "file" / "out", label);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr((folder.path() / "file").string() + "' is a file"));
        EXPECT_THAT(error.what_to_do(), HasSubstr("Name a folder"));
    }
}

TEST(VtkSink, ArraysThatDoNotFitAreRefused) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), label);
    Frame frame = channel_frame(0, false);
    frame.groups[0].fields[0].values.pop_back();
    EXPECT_THROW(sink.write(frame), std::invalid_argument);
    frame = channel_frame(0, false);
    frame.groups[1].bond_ends[3] = 9;
    EXPECT_THROW(sink.write(frame), std::invalid_argument);
    EXPECT_FALSE(fs::exists(folder.path() / "fluid.pvd"));
}

TEST(VtkSink, AFullDiskIsAResourceErrorAndTheSeriesStaysWhole) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), label);
    sink.write(channel_frame(0, true));
    const auto whole = fs::file_size(folder.path() / "frames/fluid_000000.vtp");
    ASSERT_GT(whole, 8000U);
    for (const double share : {0.0, 0.05, 0.3, 0.6, 0.9, 0.98, 0.9999}) {
        SCOPED_TRACE(share);
        std::string message;
        {
            const FileSizeLimit limit(static_cast<rlim_t>(static_cast<double>(whole) * share));
            try {
                sink.write(channel_frame(0, false));
            } catch (const ResourceError& error) {
                message = error.what();
            }
        }
        EXPECT_THAT(message, HasSubstr("frames/fluid_"));
        EXPECT_THAT(message, HasSubstr("ulimit -f"));
        EXPECT_THAT(message, HasSubstr("Free some room"));
        EXPECT_THAT(files_in(folder.path() / "frames"), ElementsAre("fluid_000000.vtp", "solid_000000.vtp"));
        for (const char* name : {"fluid.pvd", "solid.pvd"}) {
            const std::vector<SeriesEntry> series = read_series(folder.path() / name);
            ASSERT_EQ(series.size(), 1U);
            EXPECT_GT(Opened(series[0].file).data().GetNumberOfPoints(), 0);
        }
    }
    sink.write(channel_frame(1, false));  // room again: the run may go on
    EXPECT_EQ(read_series(folder.path() / "fluid.pvd").size(), 2U);
}

#ifndef __SANITIZE_ADDRESS__  // which takes terabytes of addresses for itself
TEST(VtkSink, TooLittleMemoryIsAResourceErrorBeforeVtkCrashesOnIt) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), label);
    Frame frame;
    frame.spacing = 1e-3;
    frame.parts = {"water"};
    FrameGroup group;
    group.name = "fluid";
    for (int i = 0; i < 300'000; ++i) {
        group.id.push_back(i);
        group.part.push_back(0);
        group.position.insert(group.position.end(), {static_cast<float>(i), 0, 0});
    }
    frame.groups.push_back(std::move(group));
    std::string message;
    {
        const AddressLimit limit(rlim_t{32} << 20U);
        try {
            sink.write(frame);
        } catch (const ResourceError& error) {
            message = error.what();
        }
    }
    EXPECT_THAT(message, HasSubstr("frames/fluid_000000.vtp' was not written: VTK may take "));
    EXPECT_THAT(message, HasSubstr("--frames hdf5"));
    EXPECT_TRUE(files_in(folder.path() / "frames").empty());
    sink.write(frame);
    EXPECT_EQ(Opened(folder.path() / "frames/fluid_000000.vtp").data().GetNumberOfPoints(), 300'000);
}
#endif

TEST(VtkSink, ATextThatCannotBeWrittenLeavesTheOldOne) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "list.pvd";
    write_file(file, "old");
    {
        const FileSizeLimit limit(10);
        EXPECT_THROW(write_file(file, std::string(100, 'x')), ResourceError);
    }
    EXPECT_EQ(read_file(file), "old");
    EXPECT_THAT(files_in(folder.path()), ElementsAre("list.pvd"));
}

TEST(ReadFrames, GiveTheFrameBack) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), label);
    const Frame written = channel_frame(0.25, true);
    sink.write(written);
    const FrameFile file = read_frame(folder.path() / "frames/solid_000000.vtp", "solid");
    EXPECT_EQ(file.title, "Channel with a flap");
    EXPECT_EQ(file.frame.time, 0.25);
    EXPECT_EQ(file.frame.step, 250);
    EXPECT_EQ(file.frame.parts, written.parts);
    const FrameGroup& solid = file.frame.groups.at(0);
    EXPECT_EQ(solid.position, written.groups[1].position);
    EXPECT_EQ(solid.id, written.groups[1].id);
    EXPECT_EQ(solid.part, written.groups[1].part);
    EXPECT_EQ(solid.bond_ends, written.groups[1].bond_ends);
    ASSERT_EQ(solid.bond_fields.size(), 1U);
    EXPECT_EQ(solid.bond_fields[0].values, written.groups[1].bond_fields[0].values);
    EXPECT_EQ(solid.bond_fields[0].unit, "1");
}

TEST(ReadFrames, BrokenFilesAreNamed) {
    const TemporaryFolder folder;
    VtkSink sink(folder.path(), label);
    sink.write(channel_frame(0, false));
    const fs::path file = folder.path() / "frames/fluid_000000.vtp";
    fs::resize_file(file, fs::file_size(file) / 2);
    EXPECT_THROW(read_frame(file, "fluid"), InputError);
    EXPECT_THROW(read_frame(folder.path() / "frames/none.vtp", "fluid"), InputError);
    std::ofstream(folder.path() / "fluid.pvd") << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collec";
    EXPECT_THROW(read_series(folder.path() / "fluid.pvd"), InputError);
    EXPECT_TRUE(read_series(folder.path() / "none.pvd").empty());
}

}  // namespace
}  // namespace dmp::tests::vtk_sink_tests
