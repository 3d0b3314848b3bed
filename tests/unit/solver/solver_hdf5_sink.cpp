// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "solver/output/frame_file.hpp"
#include "solver/output/hdf5_sink.hpp"
#include "tests/modules.hpp"
#include "tests/unit/damage.hpp"
#include "tests/unit/postproc/synthetic_run.hpp"
#include "tests/unit/solver/equal_frames.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_hdf5_sink_tests {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const RunLabel label{"Channel with a flap", "0123456789abcdef", "0.2.0"};

class Hdf5Frames : public ::testing::Test {
  protected:
    [[nodiscard]] std::vector<std::string> frames() const { return files_in(folder_.path() / "frames"); }
    [[nodiscard]] nlohmann::json index() const {
        return nlohmann::json::parse(bytes_of(folder_.path() / "frames.json"));
    }
    /// Writes `count` frames, the first with walls, at the times 0, 1, ...
    void write_run(int count) const {
        Hdf5Sink sink(folder_.path(), label);
        for (int n = 0; n < count; ++n) sink.write(channel_frame(n, n == 0));
    }

    TemporaryFolder folder_;
};

TEST_F(Hdf5Frames, ComeBackAsTheyWere) {
    Frame written = channel_frame(0.1, true);
    std::swap(written.groups[0], written.groups[2]);  // not in alphabetical order
    std::swap(written.groups[1].bond_fields[0].name, written.groups[1].bond_fields[0].unit);
    written.groups[2].fields[0].values[5] = std::numeric_limits<float>::quiet_NaN();  // a run that diverged
    written.groups[2].fields[1].values[0] = -0.0F;
    written.groups[2].fields.push_back({"id", "1", 1, std::vector<float>(400, 7.0F)});  // as the array of numbers
    Hdf5Sink sink(folder_.path() / "new/out", label);
    sink.write(written);
    const StoredFrame stored = read_frame(frame_path(folder_.path() / "new/out", 0));
    expect_equal(stored.frame, written);
    EXPECT_EQ(stored.label.title, label.title);
    EXPECT_EQ(stored.label.scene_hash, label.scene_hash);
    EXPECT_EQ(stored.label.version, label.version);
}

TEST_F(Hdf5Frames, WithoutAnythingInThemComeBackToo) {
    Frame written;
    written.groups.push_back({"fluid", {}, {}, {}, {{"velocity", "m/s", 3, {}}}, {}, {}});
    write_frame(folder_.path() / "frame.h5", written, {});
    expect_equal(read_frame(folder_.path() / "frame.h5").frame, written);
}

TEST_F(Hdf5Frames, AreNumberedAndIndexed) {
    Hdf5Sink sink(folder_.path(), label);
    EXPECT_THAT(sink.files(), IsEmpty());
    sink.write(channel_frame(0, true));
    sink.write(channel_frame(0.30000000000000004, false));
    EXPECT_EQ(sink.frames(), 2);
    EXPECT_THAT(sink.files(), ElementsAre("frames", "frames.json"));
    EXPECT_THAT(frames(), ElementsAre("frame_000000.h5", "frame_000001.h5"));
    EXPECT_THAT(files_in(folder_.path()), ElementsAre("frames", "frames.json"));
    EXPECT_EQ(index().at("title"), label.title);
    ASSERT_EQ(index().at("frames").size(), 2U);
    EXPECT_EQ(index().at("frames")[1].at("file"), "frames/frame_000001.h5");
    EXPECT_EQ(index().at("frames")[1].at("time"), 0.30000000000000004);
    EXPECT_EQ(index().at("frames")[1].at("step"), 300);
}

TEST_F(Hdf5Frames, OfAnEarlierRunDoNotMixWithTheNew) {
    write_run(3);
    put_bytes(folder_.path() / "frames/notes.txt", "mine");
    put_bytes(folder_.path() / "frames/.frame_000007.h5.unfinished", "x");
    Hdf5Sink sink(folder_.path(), label);
    EXPECT_EQ(index().at("frames").size(), 3U) << "nothing is removed before there is a new frame";
    sink.write(channel_frame(5, false));
    EXPECT_THAT(frames(), ElementsAre("frame_000000.h5", "notes.txt"));
    ASSERT_EQ(index().at("frames").size(), 1U);
    EXPECT_EQ(index().at("frames")[0].at("time"), 5);
}

TEST_F(Hdf5Frames, OfARunThatIsTakenUpAgainAreKept) {
    write_run(4);
    Hdf5Sink sink(folder_.path(), label);
    sink.go_on(2);
    EXPECT_EQ(sink.frames(), 2);
    sink.write(channel_frame(7, false));
    EXPECT_THAT(frames(), ElementsAre("frame_000000.h5", "frame_000001.h5", "frame_000002.h5"));
    ASSERT_EQ(index().at("frames").size(), 3U);
    EXPECT_EQ(index().at("frames")[1].at("time"), 1);
    EXPECT_EQ(index().at("frames")[2].at("time"), 7);
    EXPECT_EQ(read_frame(frame_path(folder_.path(), 2)).frame.time, 7);
}

TEST_F(Hdf5Frames, ToKeepThatAreNotThereAreAnInputError) {
    write_run(2);
    Hdf5Sink sink(folder_.path(), label);
    EXPECT_THAT(text_thrown<InputError>([&] { sink.go_on(3); }), HasSubstr("frame 2 of the run to go on with"));
    fs::remove(frame_path(folder_.path(), 0));
    EXPECT_THAT(text_thrown<InputError>([&] { sink.go_on(2); }), HasSubstr("frame 0 of the run to go on with"));
    for (const char* wrong : {"{\"frames\": [", "{\"frames\": [{\"file\": 3}]}", "[]"}) {
        put_bytes(folder_.path() / "frames.json", wrong);
        EXPECT_THAT(text_thrown<InputError>([&] { sink.go_on(1); }), HasSubstr("not an index of frames")) << wrong;
    }
    fs::remove(folder_.path() / "frames.json");
    EXPECT_THAT(text_thrown<InputError>([&] { sink.go_on(1); }),
                testing::AllOf(HasSubstr("the run to be continued has written no HDF5 frames"),
                               HasSubstr("the same --frames")));
    sink.go_on(0);
    sink.write(channel_frame(0, true));
    EXPECT_THAT(frames(), ElementsAre("frame_000000.h5"));
}

TEST_F(Hdf5Frames, ThatDoNotFitAreRefused) {
    const fs::path file = folder_.path() / "frame.h5";
    Frame frame = channel_frame(0, false);
    frame.groups[0].fields[0].values.pop_back();
    EXPECT_THAT(text_thrown<std::invalid_argument>([&] { write_frame(file, frame, label); }),
                HasSubstr("field velocity has 1199 values, expected 1200"));
    for (const char* name : {"", ".", "a/b"}) {
        frame = channel_frame(0, false);
        frame.groups[0].fields[0].name = name;
        EXPECT_THROW(write_frame(file, frame, label), std::invalid_argument) << name;
        frame = channel_frame(0, false);
        frame.groups[1].name = name;
        EXPECT_THROW(write_frame(file, frame, label), std::invalid_argument) << name;
    }
    EXPECT_THAT(files_in(folder_.path()), IsEmpty());
}

TEST_F(Hdf5Frames, ThatAreDamagedAreRefused) {
    write_run(1);
    const fs::path file = frame_path(folder_.path(), 0);
    const std::string whole = bytes_of(file);
    std::mt19937_64 random(8);
    for (int n = 0; n < 100; ++n) {
        flip_bit(file, random() % (whole.size() * 8));
        EXPECT_THROW((void)read_frame(file), InputError);
        put_bytes(file, whole.substr(0, random() % whole.size()));
        EXPECT_THROW((void)read_frame(file), InputError);
        put_bytes(file, whole);
    }
    EXPECT_EQ(read_frame(file).frame.groups.size(), 3U);
}

TEST_F(Hdf5Frames, OnAFullDiskAreAResourceErrorAndThoseBeforeStay) {
    write_run(1);
    const auto whole = fs::file_size(frame_path(folder_.path(), 0));
    Hdf5Sink sink(folder_.path(), label);
    sink.write(channel_frame(0, true));
    for (const double share : {0.0, 0.01, 0.5, 0.9}) {
        std::string message;
        {
            const FileSizeLimit limit(static_cast<rlim_t>(static_cast<double>(whole) * share));
            message = text_thrown<ResourceError>([&] { sink.write(channel_frame(1, true)); });
        }
        EXPECT_THAT(message, HasSubstr("frames/frame_000001.h5"));
        EXPECT_THAT(frames(), ElementsAre("frame_000000.h5"));
        EXPECT_EQ(index().at("frames").size(), 1U);
    }
    sink.write(channel_frame(1, true));  // room again: the run may go on
    EXPECT_EQ(index().at("frames").size(), 2U);
}

TEST_F(Hdf5Frames, BelowAFileAreAnInputError) {
    put_bytes(folder_.path() / "file", "x");
    EXPECT_THROW(Hdf5Sink(folder_.path() / "file/out", label), InputError);
}

}  // namespace
}  // namespace dmp::tests::solver_hdf5_sink_tests
