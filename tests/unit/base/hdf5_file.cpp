// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/hdf5_file.hpp"

#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <numeric>

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "base/errors.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::hdf5_file_tests {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Bytes of files that this process keeps open and nobody else sees any more.
std::uintmax_t hidden_bytes() {
    std::uintmax_t bytes = 0;
    for (const std::string& descriptor : files_in("/proc/self/fd")) {
        struct stat about {};
        if (fstat(std::stoi(descriptor), &about) == 0 && S_ISREG(about.st_mode) && about.st_nlink == 0)
            bytes += static_cast<std::uintmax_t>(about.st_size);
    }
    return bytes;
}

template <class T>
std::vector<T> counted(std::size_t length) {
    std::vector<T> values(length);
    std::iota(values.begin(), values.end(), T{1});
    return values;
}

class Hdf5File : public ::testing::Test {
  protected:
    TemporaryFolder folder_;
    fs::path file_ = folder_.path() / "data.h5";
};

template <class T>
class Hdf5Array : public Hdf5File {};
using Numbers = ::testing::Types<double, float, std::int64_t, std::int32_t, std::uint16_t, std::uint8_t>;
TYPED_TEST_SUITE(Hdf5Array, Numbers);

TYPED_TEST(Hdf5Array, ComesBackAsWritten) {
    using T = TypeParam;
    std::vector<T> values = counted<T>(1000);
    values[1] = std::numeric_limits<T>::lowest();
    values[2] = std::numeric_limits<T>::max();
    {
        Hdf5Writer writer(this->file_);
        writer.write_array<T>("array", values);
        writer.write_array<T>("none", {});
        writer.write_number<T>("number", values[2]);
        writer.set_attribute<T>("array", "first", values[0]);
        writer.close();
    }
    const Hdf5Reader reader(this->file_);
    EXPECT_EQ(reader.array<T>("array"), values);
    EXPECT_TRUE(reader.array<T>("none").empty());
    EXPECT_EQ(reader.number<T>("number"), values[2]);
    EXPECT_EQ(reader.number_attribute<T>("array", "first"), values[0]);
    EXPECT_EQ(reader.length("array"), 1000U);
    EXPECT_EQ(reader.type("array"), hdf5_type<T>());
}

TEST_F(Hdf5File, KeepsEveryBitOfADouble) {
    const std::vector<double> values{-0.0, std::nan("7"), std::numeric_limits<double>::denorm_min(),
                                     -std::numeric_limits<double>::infinity(), 0.1};
    {
        Hdf5Writer writer(file_);
        writer.write_array<double>("values", values);
        writer.close();
    }
    const std::vector<double> read = Hdf5Reader(file_).array<double>("values");
    for (std::size_t n = 0; n < values.size(); ++n)
        EXPECT_EQ(std::bit_cast<std::uint64_t>(read.at(n)), std::bit_cast<std::uint64_t>(values[n]));
}

TEST_F(Hdf5File, IsWrittenAndReadInSlices) {
    const std::vector<std::int32_t> values = counted<std::int32_t>(1000);
    {
        Hdf5Writer writer(file_);
        writer.create<std::int32_t>("numbers", values.size(), {.chunk = 64});
        const std::span<const std::int32_t> all = values;
        writer.write<std::int32_t>("numbers", 700, all.subspan(700));
        writer.write<std::int32_t>("numbers", 0, all.subspan(0, 65));
        writer.write<std::int32_t>("numbers", 65, all.subspan(65, 635));
        writer.write<std::int32_t>("numbers", 1000, {});
        writer.close();
    }
    const Hdf5Reader reader(file_);
    EXPECT_EQ(reader.array<std::int32_t>("numbers"), values);
    for (const std::size_t offset : {0, 63, 64, 500, 999}) {
        std::vector<std::int32_t> slice(std::min<std::size_t>(130, 1000 - offset));
        reader.read<std::int32_t>("numbers", offset, slice);
        EXPECT_EQ(slice.front(), values[offset]);
        EXPECT_EQ(slice.back(), values[offset + slice.size() - 1]);
    }
    std::vector<std::int32_t> slice(2);
    EXPECT_THAT(text_thrown<InputError>([&] { reader.read<std::int32_t>("numbers", 999, slice); }),
                HasSubstr("'numbers' has 1000 elements, fewer than the 2 from number 999 on"));
}

TEST_F(Hdf5File, HoldsTextsAndNamesInGroups) {
    const std::vector<std::string> words{"", "blood", "a leaflet's part", "\u00e9"};
    {
        Hdf5Writer writer(file_);
        writer.write_text("run/scene", "title = \"valve\"\n");
        writer.write_text("run/empty", "");
        writer.write_texts("parts", words);
        writer.write_texts("no_parts", {});
        writer.write_array<double>("fluid/mass", counted<double>(3));
        writer.set_attribute("fluid/mass", "unit", "kg");
        writer.close();
    }
    const Hdf5Reader reader(file_);
    EXPECT_THAT(reader.names(), ElementsAre("fluid/mass", "no_parts", "parts", "run/empty", "run/scene"));
    EXPECT_TRUE(reader.has("fluid/mass"));
    EXPECT_FALSE(reader.has("fluid"));
    EXPECT_EQ(reader.type("parts"), Hdf5Type::text);
    EXPECT_EQ(reader.text("run/scene"), "title = \"valve\"\n");
    EXPECT_EQ(reader.text("run/empty"), "");
    EXPECT_EQ(reader.texts("parts"), words);
    EXPECT_TRUE(reader.texts("no_parts").empty());
    EXPECT_EQ(reader.text_attribute("fluid/mass", "unit"), "kg");
}

TEST_F(Hdf5File, TheSameCallsGiveTheSameBytes) {
    std::string bytes[2];
    for (std::string& content : bytes) {
        Hdf5Writer writer(file_);
        writer.create<double>("group/a", 10, {.chunk = 8});
        writer.write<double>("group/a", 0, counted<double>(10));
        writer.write_text("b", "text");
        writer.close();
        std::ifstream stream(file_, std::ios::binary);
        content.assign(std::istreambuf_iterator<char>(stream), {});
    }
    EXPECT_GT(bytes[0].size(), 80U);
    EXPECT_EQ(bytes[0], bytes[1]);
}

TEST_F(Hdf5File, DeflateMakesItSmallerAndChangesNothing) {
    const std::vector<std::int64_t> values = counted<std::int64_t>(100000);
    std::uintmax_t sizes[2]{};
    for (const int deflate : {0, 1}) {
        Hdf5Writer writer(file_);
        writer.write_array<std::int64_t>("id", values, {.deflate = deflate});
        writer.close();
        sizes[deflate] = fs::file_size(file_);
        EXPECT_EQ(Hdf5Reader(file_).array<std::int64_t>("id"), values);
    }
    EXPECT_LT(sizes[1], sizes[0] / 4);
}

TEST_F(Hdf5File, WrongUseOfTheWriterIsABug) {
    Hdf5Writer writer(file_);
    writer.create<double>("a", 3);
    EXPECT_THROW(writer.create<double>("a", 3), std::logic_error);
    EXPECT_THROW(writer.write<double>("b", 0, counted<double>(3)), std::logic_error);
    EXPECT_THROW(writer.write<float>("a", 0, counted<float>(3)), std::logic_error);
    EXPECT_THROW(writer.write<double>("a", 1, counted<double>(3)), std::logic_error);
    EXPECT_THROW(writer.write<double>("a", 4, {}), std::logic_error);
    writer.write<double>("a", 1, counted<double>(2));
    EXPECT_THROW(writer.close(), std::logic_error) << "element 0 was not written";
    writer.write<double>("a", 0, counted<double>(1));
    writer.close();
}

TEST_F(Hdf5File, ThatIsNotClosedIsRemoved) {
    {
        Hdf5Writer writer(file_);
        writer.write_array<double>("a", counted<double>(3));
        EXPECT_TRUE(fs::exists(file_));
    }
    EXPECT_FALSE(fs::exists(file_));
}

TEST_F(Hdf5File, WhatIsNotThereIsAnInputError) {
    {
        Hdf5Writer writer(file_);
        writer.write_array<double>("a", counted<double>(3));
        writer.write_text("t", "text");
        writer.close();
    }
    const Hdf5Reader reader(file_);
    EXPECT_THAT(text_thrown<InputError>([&] { (void)reader.array<double>("b"); }),
                ::testing::StartsWith(file_.string() + ": has no dataset 'b'\n  "));
    EXPECT_THAT(text_thrown<InputError>([&] { (void)reader.array<float>("a"); }),
                HasSubstr("'a' holds float64, not float32"));
    EXPECT_THAT(text_thrown<InputError>([&] { (void)reader.text("a"); }), HasSubstr("'a' holds float64, not text"));
    EXPECT_THAT(text_thrown<InputError>([&] { (void)reader.number<double>("a"); }), HasSubstr("3 elements, not one"));
    EXPECT_THAT(text_thrown<InputError>([&] { (void)reader.number<double>("t"); }), HasSubstr("holds text"));
    EXPECT_THAT(text_thrown<InputError>([&] { (void)reader.text_attribute("a", "unit"); }),
                HasSubstr("no attribute 'unit'"));
}

TEST_F(Hdf5File, ThatCannotBeReadIsAnInputError) {
    EXPECT_THAT(text_thrown<InputError>([&] { const Hdf5Reader reader(file_); }),
                HasSubstr("cannot be read: No such file or directory"));
    std::ofstream(file_) << "something else";
    EXPECT_THAT(text_thrown<InputError>([&] { const Hdf5Reader reader(file_); }), HasSubstr("cannot be read: "));
}

TEST_F(Hdf5File, ThatCannotBeMadeIsAResourceError) {
    EXPECT_THAT(text_thrown<ResourceError>([&] { const Hdf5Writer writer(folder_.path() / "none/data.h5"); }),
                HasSubstr("none/data.h5': No such file or directory"));
    const FileSizeLimit limit(0);
    EXPECT_THAT(text_thrown<ResourceError>([&] { const Hdf5Writer writer(file_); }), HasSubstr("File too large"));
}

/// Writes 100 000 doubles in slices, and a text.
void write_much(const fs::path& file) {
    const std::vector<double> values = counted<double>(10000);
    Hdf5Writer writer(file);
    writer.write_text("text", "text");
    writer.create<double>("values", 100000);
    writer.create<std::int32_t>("group/numbers", 1000);
    for (std::uint64_t offset = 0; offset < 100000; offset += 10000) writer.write<double>("values", offset, values);
    writer.write<std::int32_t>("group/numbers", 0, counted<std::int32_t>(1000));
    writer.close();
}

TEST_F(Hdf5File, AFullDiskIsAResourceErrorAndTakesNoRoom) {
    write_much(file_);
    const auto whole = fs::file_size(file_);
    const std::uintmax_t before = hidden_bytes();
    for (const double share : {0.0001, 0.001, 0.01, 0.2, 0.5, 0.9, 0.99, 0.999, 0.9999}) {
        SCOPED_TRACE(share);
        std::string message;
        {
            const FileSizeLimit limit(static_cast<rlim_t>(static_cast<double>(whole) * share));
            message = text_thrown<ResourceError>([&] { write_much(file_); });
        }
        EXPECT_THAT(message, HasSubstr(file_.string() + "': File too large"));
        EXPECT_THAT(message, HasSubstr("ulimit -f"));
        EXPECT_EQ(hidden_bytes(), before);
        EXPECT_FALSE(fs::exists(file_));
    }
    write_much(file_);  // room again
    EXPECT_EQ(Hdf5Reader(file_).length("values"), 100000U);
}

}  // namespace
}  // namespace dmp::tests::hdf5_file_tests
