// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <numeric>
#include <random>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "solver/state/checkpoint_file.hpp"
#include "tests/modules.hpp"
#include "tests/unit/damage.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_checkpoint_file_tests {
namespace {

namespace fs = std::filesystem;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::size_t slice_length = 40000;

/// A slice of the velocities: what rank `rank` would hand to the one that writes.
std::vector<double> velocities_of(std::size_t rank) {
    std::vector<double> values(slice_length);
    std::iota(values.begin(), values.end(), 0.1 + static_cast<double>(rank * slice_length));
    return values;
}

void write_checkpoint(const fs::path& file) {
    CheckpointWriter writer(file);
    writer.contents().write_text("run/scene", "title = \"a run\"");
    writer.contents().write_number<std::int64_t>("run/step", 1234);
    writer.contents().write_number<double>("run/time", 0.3);
    writer.contents().create<double>("fluid/velocity", 3 * slice_length);
    for (std::size_t rank = 0; rank < 3; ++rank)
        writer.contents().write<double>("fluid/velocity", rank * slice_length, velocities_of(rank));
    writer.finish();
}

class CheckpointFile : public ::testing::Test {
  protected:
    CheckpointFile() { write_checkpoint(file_); }

    [[nodiscard]] std::string problem() const {
        return text_thrown<InputError>([&] { const CheckpointReader reader(file_); });
    }

    TemporaryFolder folder_;
    fs::path file_ = folder_.path() / "step_000001234.h5";
    std::mt19937_64 random_{77};
};

TEST_F(CheckpointFile, ComesBackInSlices) {
    const CheckpointReader reader(file_);
    const Hdf5Reader& contents = reader.contents();
    EXPECT_EQ(contents.text("run/scene"), "title = \"a run\"");
    EXPECT_EQ(contents.number<std::int64_t>("run/step"), 1234);
    EXPECT_EQ(contents.number<double>("run/time"), 0.3);
    for (std::size_t rank = 0; rank < 3; ++rank) {
        std::vector<double> slice(slice_length);
        contents.read<double>("fluid/velocity", rank * slice_length, slice);
        EXPECT_EQ(slice, velocities_of(rank));
    }
}

TEST_F(CheckpointFile, CutOffAnywhereIsCalledTruncated) {
    const std::string whole = bytes_of(file_);
    for (int n = 0; n < 20; ++n) {
        const std::size_t length = 512 + random_() % (whole.size() - 512);
        fs::resize_file(file_, length);
        EXPECT_THAT(problem(), HasSubstr("truncated: " + std::to_string(length) + " of " +
                                         std::to_string(whole.size()) + " bytes"));
        put_bytes(file_, whole);
    }
}

TEST_F(CheckpointFile, WithABitTurnedOverAnywhereIsRefused) {
    const std::uint64_t bits = fs::file_size(file_) * 8;
    for (int n = 0; n < 200; ++n) {
        const std::uint64_t bit = random_() % bits;
        flip_bit(file_, bit);
        EXPECT_THAT(problem(), AnyOf(HasSubstr("damaged: "), HasSubstr("not a dmp checkpoint"))) << bit;
        flip_bit(file_, bit);
    }
    EXPECT_EQ(problem(), "nothing was thrown");
}

TEST_F(CheckpointFile, AFullDiskKeepsTheOneBefore) {
    const std::string before = bytes_of(file_);
    for (const double share : {0.001, 0.3, 0.8, 0.99}) {
        std::string message;
        {
            const FileSizeLimit limit(static_cast<rlim_t>(static_cast<double>(before.size()) * share));
            message = text_thrown<ResourceError>([&] { write_checkpoint(file_); });
        }
        EXPECT_THAT(message, HasSubstr("step_000001234.h5': File too large"));
        EXPECT_THAT(message, HasSubstr("Free some room"));
        EXPECT_THAT(files_in(folder_.path()), ElementsAre("step_000001234.h5"));
    }
    EXPECT_EQ(bytes_of(file_), before);
}

}  // namespace
}  // namespace dmp::tests::solver_checkpoint_file_tests
