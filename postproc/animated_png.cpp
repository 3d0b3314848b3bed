// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/animated_png.hpp"

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace dmp::postproc {

namespace {

constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";

struct Chunk {
    std::string_view type, data;
};

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8U | static_cast<unsigned char>(bytes[at + k]);
    return value;
}

std::string big_endian(std::uint32_t value, int bytes) {
    std::string text;
    for (int k = bytes - 1; k >= 0; --k) text += static_cast<char>(value >> (8U * static_cast<unsigned>(k)));
    return text;
}

/// CRC-32 of ISO 3309, as PNG has it.
std::uint32_t checksum(std::string_view bytes) {
    std::uint32_t crc = 0xFFFFFFFF;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xEDB88320 : crc >> 1U;
    }
    return ~crc;
}

std::string chunk(std::string_view type, std::string_view data) {
    const std::string body = std::string(type).append(data);
    return big_endian(static_cast<std::uint32_t>(data.size()), 4) + body + big_endian(checksum(body), 4);
}

std::vector<Chunk> chunks_of(std::string_view png) {
    if (!png.starts_with(signature)) throw std::invalid_argument("an image of a film is no PNG");
    std::vector<Chunk> chunks;
    for (std::size_t at = signature.size(); at < png.size();) {
        if (png.size() - at < 12 || png.size() - at - 12 < number_at(png, at))
            throw std::invalid_argument("an image of a film is not complete");
        const std::size_t size = number_at(png, at);
        chunks.push_back({png.substr(at + 4, 4), png.substr(at + 8, size)});
        at += size + 12;
    }
    if (chunks.empty() || chunks.front().type != "IHDR" || chunks.front().data.size() != 13)
        throw std::invalid_argument("an image of a film has no header");
    constexpr std::size_t colour_type = 9;
    constexpr char palette = 3;
    if (chunks.front().data[colour_type] == palette)
        throw std::invalid_argument("an image of a film has a palette, which is not taken over");
    return chunks;
}

}  // namespace

std::string animated_png(const std::vector<std::string>& images, int milliseconds) {
    if (images.empty()) throw std::invalid_argument("a film of no images");
    const std::string_view header = chunks_of(images.front()).front().data;
    std::string film = std::string(signature) + chunk("IHDR", header) +
                       chunk("acTL", big_endian(static_cast<std::uint32_t>(images.size()), 4) + big_endian(0, 4));
    std::uint32_t sequence = 0;
    for (const std::string& image : images) {
        const std::vector<Chunk> chunks = chunks_of(image);
        if (chunks.front().data != header) throw std::invalid_argument("the images of a film are unlike");
        const std::string whole_area = std::string(header.substr(0, 8)) + big_endian(0, 8);
        const std::string shown = big_endian(static_cast<std::uint32_t>(milliseconds), 2) + big_endian(1000, 2);
        film += chunk("fcTL", big_endian(sequence++, 4) + whole_area + shown + big_endian(0, 2));
        for (const Chunk& part : chunks) {
            if (part.type != "IDAT") continue;
            film += &image == &images.front() ? chunk("IDAT", part.data)
                                              : chunk("fdAT", big_endian(sequence++, 4).append(part.data));
        }
    }
    return film + chunk("IEND", "");
}

}  // namespace dmp::postproc
