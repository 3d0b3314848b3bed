// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/animated_png.hpp"

#include <stdexcept>

#include <gmock/gmock.h>

#include "postproc/canvas.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::animated_png_tests {
namespace {

using testing::ElementsAre;

std::string picture(int width, Colour colour) {
    Canvas canvas(width, 20);
    canvas.fill(2, 2, 10, 10, colour);
    return canvas.png();
}

struct Chunk {
    std::string type, data, checksum;
};

unsigned number(const std::string& bytes, std::size_t at) {
    unsigned value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = 256 * value + static_cast<unsigned char>(bytes.at(at + k));
    return value;
}

std::vector<Chunk> chunks_of(const std::string& png) {
    std::vector<Chunk> chunks;
    for (std::size_t at = 8; at < png.size();) {
        const unsigned size = number(png, at);
        chunks.push_back({png.substr(at + 4, 4), png.substr(at + 8, size), png.substr(at + 8 + size, 4)});
        at += size + 12;
    }
    return chunks;
}

std::string data_of(const std::vector<Chunk>& chunks, const std::string& type, std::size_t skipped) {
    std::string data;
    for (const Chunk& chunk : chunks)
        if (chunk.type == type) data += chunk.data.substr(skipped);
    return data;
}

TEST(AnimatedPng, HoldsTheDataOfItsImagesInOrder) {
    const std::string red = picture(30, {255, 0, 0}), blue = picture(30, {0, 0, 255});
    const std::string film = animated_png({red, blue}, 40);
    EXPECT_EQ(film.substr(0, 8), red.substr(0, 8));
    const auto chunks = chunks_of(film);
    std::vector<std::string> types;
    for (const Chunk& chunk : chunks) types.push_back(chunk.type);
    ASSERT_THAT(types, ElementsAre("IHDR", "acTL", "fcTL", "IDAT", "fcTL", "fdAT", "IEND"));
    EXPECT_EQ(number(chunks[1].data, 0), 2U) << "images";
    EXPECT_EQ(number(chunks[1].data, 4), 0U) << "without end";
    for (const std::size_t k : {2U, 4U}) {
        EXPECT_EQ(number(chunks[k].data, 4), 30U) << "width";
        EXPECT_EQ(number(chunks[k].data, 8), 20U) << "height";
        EXPECT_EQ(number(chunks[k].data, 20), 40U * 65536 + 1000) << "40 / 1000 s";
    }
    EXPECT_EQ(number(chunks[2].data, 0), 0U);
    EXPECT_EQ(number(chunks[4].data, 0), 1U);
    EXPECT_EQ(number(chunks[5].data, 0), 2U);
    EXPECT_EQ(data_of(chunks, "IDAT", 0), data_of(chunks_of(red), "IDAT", 0));
    EXPECT_EQ(data_of(chunks, "fdAT", 4), data_of(chunks_of(blue), "IDAT", 0));
    // Cairo's library has worked these out, too.
    EXPECT_EQ(chunks[0].checksum, chunks_of(red)[0].checksum);
    EXPECT_EQ(chunks[3].checksum, chunks_of(red)[chunks_of(red).size() - 2].checksum);
}

TEST(AnimatedPng, RefusesImagesThatAreUnlikeOrNone) {
    const std::string one = picture(30, {255, 0, 0});
    EXPECT_THROW(static_cast<void>(animated_png({}, 40)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(animated_png({one, picture(31, {255, 0, 0})}, 40)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(animated_png({one, "GIF89a"}, 40)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(animated_png({one.substr(0, one.size() - 3)}, 40)), std::invalid_argument);
}

}  // namespace
}  // namespace dmp::tests::animated_png_tests
