// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/sealed_file.hpp"

#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "tests/modules.hpp"
#include "tests/unit/damage.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::sealed_file_tests {
namespace {

namespace fs = std::filesystem;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr SealedKind kind{"test data", 3};

std::vector<double> numbers() {
    std::vector<double> values(5000);
    std::iota(values.begin(), values.end(), 0.5);
    return values;
}

void write_sealed(const fs::path& file, SealedKind as = kind) {
    SealedWriter writer(file, as);
    writer.contents().write_array<double>("numbers", numbers());
    writer.contents().write_text("text", "what it is");
    writer.finish();
}

class SealedFile : public ::testing::Test {
  protected:
    SealedFile() { write_sealed(file_); }

    /// What reading it throws.
    [[nodiscard]] std::string problem() const {
        return text_thrown<InputError>([&] { const SealedReader reader(file_, kind); });
    }

    TemporaryFolder folder_;
    fs::path file_ = folder_.path() / "data.h5";
    std::mt19937_64 random_{20240601};
};

TEST_F(SealedFile, ComesBackAsWritten) {
    const SealedReader reader(file_, kind);
    EXPECT_EQ(reader.contents().array<double>("numbers"), numbers());
    EXPECT_EQ(reader.contents().text("text"), "what it is");
    EXPECT_THAT(files_in(folder_.path()), ElementsAre("data.h5"));
}

TEST_F(SealedFile, IsHdf5ForOtherPrograms) { EXPECT_EQ(Hdf5Reader(file_).array<double>("numbers"), numbers()); }

TEST_F(SealedFile, NotFinishedLeavesTheOldOneAndNothingElse) {
    const std::string before = bytes_of(file_);
    {
        SealedWriter writer(file_, kind);
        writer.contents().write_text("text", "something else");
        EXPECT_THAT(files_in(folder_.path()), ElementsAre(".data.h5.unfinished", "data.h5"));
    }
    EXPECT_THAT(files_in(folder_.path()), ElementsAre("data.h5"));
    EXPECT_EQ(bytes_of(file_), before);
}

TEST_F(SealedFile, EveryTruncationIsRefused) {
    const std::string whole = bytes_of(file_);
    std::vector<std::size_t> lengths{1, 7, 8, 100, 511, 512, 513, whole.size() - 1};
    for (int n = 0; n < 100; ++n) lengths.push_back(1 + random_() % (whole.size() - 1));
    for (const std::size_t length : lengths) {
        fs::resize_file(file_, length);
        EXPECT_THAT(problem(), HasSubstr(": truncated: " + std::to_string(length))) << length;
        put_bytes(file_, whole);
    }
    EXPECT_EQ(problem(), "nothing was thrown");
    fs::resize_file(file_, 1000);
    EXPECT_THAT(problem(), HasSubstr("truncated: 1000 of " + std::to_string(whole.size()) + " bytes\n  "));
    fs::resize_file(file_, 0);
    EXPECT_THAT(problem(), HasSubstr(": empty\n"));
}

TEST_F(SealedFile, EveryFlippedBitIsRefused) {
    const std::uint64_t bits = fs::file_size(file_) * 8;
    std::vector<std::uint64_t> flips(seal_size * 8);  // all of the seal's
    std::iota(flips.begin(), flips.end(), std::uint64_t{0});
    for (int n = 0; n < 1000; ++n) flips.push_back(random_() % bits);
    for (const std::uint64_t bit : flips) {
        flip_bit(file_, bit);
        EXPECT_THAT(problem(), bit < 64 ? HasSubstr("not a dmp test data") : HasSubstr("damaged: ")) << bit;
        flip_bit(file_, bit);
    }
    EXPECT_EQ(problem(), "nothing was thrown");
}

TEST_F(SealedFile, BytesBehindItsEndAreRefused) {
    put_bytes(file_, bytes_of(file_) + std::string(1, '\0'));
    EXPECT_THAT(problem(), HasSubstr("more than were written"));
}

TEST_F(SealedFile, OtherFilesAreRefused) {
    put_bytes(file_, "solid cube\n");
    EXPECT_THAT(problem(), HasSubstr("not a dmp test data: it begins otherwise"));
    put_bytes(file_, std::string(2000, '\0'));
    EXPECT_THAT(problem(), HasSubstr("not a dmp test data: it begins otherwise"));
    write_sealed(file_, {"picture", 1});
    EXPECT_THAT(problem(), HasSubstr("not a dmp test data but a dmp picture"));
    write_sealed(file_, {kind.name, 4});
    EXPECT_THAT(problem(), HasSubstr("of a newer format: 4, and this dmp knows up to 3"));
    write_sealed(file_, {kind.name, 2});
    EXPECT_EQ(problem(), "nothing was thrown");
    fs::remove(file_);
    EXPECT_THAT(problem(), HasSubstr("not readable: No such file or directory"));
    fs::create_directory(file_);
    EXPECT_THAT(problem(), HasSubstr("not readable: Is a directory"));
}

TEST_F(SealedFile, AFullDiskLeavesTheOldOneAndNothingElse) {
    const std::string before = bytes_of(file_);
    for (const double share : {0.0, 0.01, 0.02, 0.5, 0.9, 0.999}) {
        SCOPED_TRACE(share);
        std::string message;
        {
            const FileSizeLimit limit(static_cast<rlim_t>(static_cast<double>(before.size()) * share));
            message = text_thrown<ResourceError>([&] { write_sealed(file_); });
        }
        EXPECT_THAT(message, HasSubstr("'" + file_.string() + "': File too large"));
        EXPECT_THAT(files_in(folder_.path()), ElementsAre("data.h5"));
    }
    EXPECT_EQ(bytes_of(file_), before);
}

TEST_F(SealedFile, AFolderThatIsGoneIsAResourceError) {
    EXPECT_THAT(text_thrown<ResourceError>([&] { write_sealed(folder_.path() / "none/data.h5"); }),
                HasSubstr("none/data.h5': No such file or directory"));
    SealedWriter writer(file_, kind);
    fs::remove_all(folder_.path());
    EXPECT_THAT(text_thrown<ResourceError>([&] { writer.finish(); }), HasSubstr(file_.string()));
}

TEST(UnfinishedName, IsUndoneByFinishedName) {
    EXPECT_EQ(unfinished_name("a/b.h5"), fs::path("a/.b.h5.unfinished"));
    EXPECT_EQ(finished_name("a/.b.h5.unfinished"), fs::path("a/b.h5"));
    for (const char* other : {"a/b.h5", ".unfinished", "..unfinished", "b.h5.unfinished", ".b.h5"})
        EXPECT_FALSE(finished_name(other)) << other;
}

}  // namespace
}  // namespace dmp::tests::sealed_file_tests
