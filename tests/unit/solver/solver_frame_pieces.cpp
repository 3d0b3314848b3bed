// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "solver/output/frame_file.hpp"
#include "solver/output/frame_index.hpp"
#include "solver/output/frame_pieces.hpp"
#include "tests/modules.hpp"
#include "tests/unit/damage.hpp"
#include "tests/unit/postproc/synthetic_run.hpp"
#include "tests/unit/solver/equal_frames.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_frame_pieces_tests {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const RunLabel label{"Channel with a flap", "0123456789abcdef", "0.2.0"};

/// Particle k of a group, and nothing else of it.
void take(FrameGroup& to, const FrameGroup& from, std::size_t k) {
    to.id.push_back(from.id[k]);
    to.part.push_back(from.part[k]);
    for (std::size_t axis = 0; axis < 3; ++axis) to.position.push_back(from.position[3 * k + axis]);
    for (std::size_t n = 0; n < from.fields.size(); ++n) {
        const auto components = static_cast<std::size_t>(from.fields[n].components);
        for (std::size_t c = 0; c < components; ++c)
            to.fields[n].values.push_back(from.fields[n].values[components * k + c]);
    }
}

FrameGroup without_particles(FrameGroup group) {
    group.position.clear();
    group.id.clear();
    group.part.clear();
    group.bond_ends.clear();
    for (FrameField& field : group.fields) field.values.clear();
    for (FrameField& field : group.bond_fields) field.values.clear();
    return group;
}

/// As ranks hold a frame: fluid and walls here and there, backwards; the solid with the first one.
std::vector<Frame> in_pieces(const Frame& whole, std::size_t count) {
    std::vector<Frame> pieces(count, whole);
    for (std::size_t rank = 0; rank < count; ++rank) {
        Frame& piece = pieces[rank];
        piece.groups.clear();
        for (const FrameGroup& group : whole.groups) {
            if (group.name == "solid") {
                if (rank == 0) piece.groups.push_back(group);
                continue;
            }
            FrameGroup& share = piece.groups.emplace_back(without_particles(group));
            for (std::size_t k = group.size(); k-- > 0;)
                if (k * k % count == rank) take(share, group, k);
        }
    }
    return pieces;
}

class FramePieces : public ::testing::Test {
  protected:
    [[nodiscard]] std::vector<fs::path> write(const std::vector<Frame>& pieces) const {
        std::vector<fs::path> files;
        for (const Frame& piece : pieces) {
            files.push_back(folder_.path() / piece_name(static_cast<int>(files.size())));
            write_frame(files.back(), piece, label);
        }
        return files;
    }
    [[nodiscard]] std::string refusal(const std::vector<Frame>& pieces) const {
        return text_thrown<InputError>([&] { (void)read_frame(write(pieces)); });
    }

    TemporaryFolder folder_;
};

TEST_F(FramePieces, MakeTheFrameThatWasCutIntoThem) {
    Frame whole = channel_frame(0.1, true);
    FrameField stress{"stress", "Pa", 6, {}};
    for (std::size_t k = 0; k < 6 * whole.groups[0].size(); ++k) stress.values.push_back(0.5F * static_cast<float>(k));
    whole.groups[0].fields.push_back(stress);
    for (const std::size_t count : {1U, 2U, 3U, 5U}) {
        const StoredFrame read = read_frame(write(in_pieces(whole, count)));
        EXPECT_EQ(read.label.title, label.title);
        if (count > 1) expect_equal(read.frame, whole);
    }
}

TEST_F(FramePieces, KeepTheEndsOfTheirBonds) {
    Frame frame = channel_frame(0, false);
    FrameGroup& solid = frame.groups[1];
    std::ranges::reverse(solid.id);
    std::rotate(solid.id.begin(), solid.id.begin() + 3, solid.id.end());
    const auto by_id = [](const FrameGroup& group) {
        std::vector<std::int64_t> ends;
        for (const std::int32_t end : group.bond_ends) ends.push_back(group.id[static_cast<std::size_t>(end)]);
        return ends;
    };
    const auto before = by_id(solid);
    sort_by_id(solid);
    EXPECT_TRUE(std::ranges::is_sorted(solid.id));
    EXPECT_EQ(by_id(solid), before);

    Frame both = frame, other = frame;
    for (std::int64_t& id : other.groups[1].id) id += 100;
    other.groups[0] = without_particles(other.groups[0]);
    ASSERT_EQ(add_piece(both, std::move(other)), "");
    ASSERT_EQ(finish_pieces(both), "");
    const auto ends = by_id(both.groups[1]);
    ASSERT_EQ(ends.size(), 2 * before.size());
    for (std::size_t n = 0; n < before.size(); ++n) EXPECT_EQ(ends[before.size() + n], before[n] + 100);
}

TEST_F(FramePieces, OfAnotherFrameAreRefused) {
    const auto pieces = in_pieces(channel_frame(0.1, true), 3);
    const auto with = [&](auto&& change) {
        auto changed = pieces;
        change(changed[2]);
        return refusal(changed);
    };
    EXPECT_THAT(with([](Frame& piece) { ++piece.step; }),
                AllOf(HasSubstr("piece_002.h5"), HasSubstr("of step 101, not 100")));
    EXPECT_THAT(with([](Frame& piece) { piece.parts.pop_back(); }), HasSubstr("of another run"));
    EXPECT_THAT(with([](Frame& piece) { piece.groups[0].fields[1].name = "density"; }),
                HasSubstr("with other fields in the group 'fluid'"));
    EXPECT_THAT(with([&](Frame& piece) { piece = pieces[1]; }), HasSubstr("is in two pieces"));
    const auto files = write(pieces);
    write_frame(files[1], pieces[1], {"Channel with a flap", "another scene's", "0.2.0"});
    EXPECT_THAT(text_thrown<InputError>([&] { (void)read_frame(files); }), HasSubstr("of another scene"));
    fs::remove(files[1]);
    EXPECT_THAT(text_thrown<InputError>([&] { (void)read_frame(files); }), HasSubstr("piece_001.h5"));
}

TEST_F(FramePieces, AreFoundThroughTheIndex) {
    write_frame_index(folder_.path(), label,
                      {{"frames/frame_000000", 2, 0.0, 0}, {"frames/frame_000001.h5", 0, 0.30000000000000004, 7}});
    const auto frames = read_frame_index(folder_.path());
    ASSERT_EQ(frames.size(), 2U);
    EXPECT_THAT(frames[0].files("run"),
                ElementsAre("run/frames/frame_000000/piece_000.h5", "run/frames/frame_000000/piece_001.h5"));
    EXPECT_THAT(frames[1].files("run"), ElementsAre("run/frames/frame_000001.h5"));
    EXPECT_EQ(frames[1].time, 0.30000000000000004);
    EXPECT_EQ(frames[1].step, 7);
    EXPECT_FALSE(frames[0].is_there(folder_.path()));
    for (const char* file : {"piece_000.h5", "piece_001.h5"}) {
        EXPECT_FALSE(frames[0].is_there(folder_.path())) << "half of it is none";
        fs::create_directories(piece_folder(folder_.path(), 0));
        put_bytes(piece_folder(folder_.path(), 0) / file, "x");
    }
    EXPECT_TRUE(frames[0].is_there(folder_.path()));
}

TEST_F(FramePieces, GoWithTheFramesThatAreRemoved) {
    for (const long number : {0, 1, 2}) {
        fs::create_directories(piece_folder(folder_.path(), number));
        for (const char* file : {"piece_000.h5", "piece_001.h5", ".piece_002.h5.unfinished"})
            put_bytes(piece_folder(folder_.path(), number) / file, "x");
    }
    put_bytes(piece_folder(folder_.path(), 2) / "notes.txt", "mine");
    put_bytes(frame_path(folder_.path(), 3), "x");
    EXPECT_EQ(remove_frames(folder_.path(), 1), 7U);
    EXPECT_THAT(files_in(frame_folder(folder_.path())), ElementsAre("frame_000000", "frame_000002"));
    EXPECT_THAT(files_in(piece_folder(folder_.path(), 2)), ElementsAre("notes.txt"));
    EXPECT_EQ(files_in(piece_folder(folder_.path(), 0)).size(), 3U);
}

}  // namespace
}  // namespace dmp::tests::solver_frame_pieces_tests
