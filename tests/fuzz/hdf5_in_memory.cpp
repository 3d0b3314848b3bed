// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/hdf5_in_memory.hpp"

#include <cstring>
#include <fstream>
#include <stdexcept>

#include "base/errors.hpp"

namespace dmp::tests {

std::size_t StoredDataset::width() const {
    switch (type) {
        case Hdf5Type::float64:
        case Hdf5Type::int64:
            return 8;
        case Hdf5Type::float32:
        case Hdf5Type::int32:
            return 4;
        case Hdf5Type::uint16:
            return 2;
        case Hdf5Type::uint8:
        case Hdf5Type::text:
        case Hdf5Type::other:
            break;
    }
    return 1;
}

StoredFile& stored_file() {
    static StoredFile file;
    return file;
}

}  // namespace dmp::tests

namespace dmp {

using tests::stored_file;
using tests::StoredDataset;

namespace {

[[noreturn]] void not_of_checkpoints() { throw std::logic_error("checkpoints do not use this part of HDF5"); }

}  // namespace

struct Hdf5Writer::State {};

Hdf5Writer::Hdf5Writer(const std::filesystem::path& file, const Hdf5FileOptions& options) {
    // The seal needs a file.
    std::ofstream(file, std::ios::binary) << std::string(options.user_block + 1, '\0');
    stored_file().clear();
}
Hdf5Writer::~Hdf5Writer() = default;

void Hdf5Writer::create(const std::string& name, Hdf5Type type, std::uint64_t length, Hdf5Storage /*storage*/) {
    StoredDataset made{type, {}};
    made.bytes.resize(length * made.width());
    stored_file()[name] = made;
}

void Hdf5Writer::write(const std::string& name, Hdf5Type /*type*/, std::uint64_t offset, std::uint64_t count,
                       const void* slice) {
    StoredDataset& to = stored_file().at(name);
    if (count > 0) std::memcpy(to.bytes.data() + offset * to.width(), slice, count * to.width());
}

void Hdf5Writer::write_number(const std::string& name, Hdf5Type type, const void* value) {
    create(name, type, 1, {});
    write(name, type, 0, 1, value);
}

void Hdf5Writer::write_text(const std::string& name, std::string_view text) {
    stored_file()[name] = {Hdf5Type::text, {text.begin(), text.end()}};
}

// Those of frames, which share the library with checkpoints; checkpoints have no attributes and no lists of texts.
void Hdf5Writer::write_texts(const std::string& /*name*/, std::span<const std::string> /*texts*/) {
    not_of_checkpoints();
}
void Hdf5Writer::set_attribute(const std::string& /*dataset*/, const std::string& /*name*/, std::string_view /*text*/) {
    not_of_checkpoints();
}
void Hdf5Writer::set_attribute(const std::string& /*dataset*/, const std::string& /*name*/, Hdf5Type /*type*/,
                               const void* /*number*/) {
    not_of_checkpoints();
}

void Hdf5Writer::close() {}

struct Hdf5Reader::State {};

Hdf5Reader::Hdf5Reader(const std::filesystem::path& /*file*/) {}

const std::vector<std::string>& Hdf5Reader::names() const { not_of_checkpoints(); }
Hdf5Type Hdf5Reader::type(const std::string& /*name*/) const { not_of_checkpoints(); }
std::vector<std::string> Hdf5Reader::texts(const std::string& /*name*/) const { not_of_checkpoints(); }
std::string Hdf5Reader::text_attribute(const std::string& /*dataset*/, const std::string& /*name*/) const {
    not_of_checkpoints();
}
void Hdf5Reader::read_attribute(const std::string& /*dataset*/, const std::string& /*name*/, Hdf5Type /*type*/,
                                void* /*value*/) const {
    not_of_checkpoints();
}
Hdf5Reader::~Hdf5Reader() = default;

void Hdf5Reader::refuse(const std::string& problem) const {
    throw InputError(problem, "Restore the file from a copy, or make it again.");
}

bool Hdf5Reader::has(const std::string& name) const { return stored_file().contains(name); }

std::uint64_t Hdf5Reader::length(const std::string& name) const {
    if (!has(name)) refuse("there is no '" + name + "'");
    return stored_file().at(name).length();
}

void Hdf5Reader::read(const std::string& name, Hdf5Type type, std::uint64_t offset, std::uint64_t count,
                      void* slice) const {
    if (length(name) < offset + count) refuse("'" + name + "' is too short");
    const StoredDataset& from = stored_file().at(name);
    if (from.type != type) refuse("'" + name + "' is of another type");
    if (count > 0) std::memcpy(slice, from.bytes.data() + offset * from.width(), count * from.width());
}

void Hdf5Reader::read_number(const std::string& name, Hdf5Type type, void* value) const {
    if (length(name) != 1) refuse("'" + name + "' is not one number");
    read(name, type, 0, 1, value);
}

std::string Hdf5Reader::text(const std::string& name) const {
    if (!has(name)) refuse("there is no '" + name + "'");
    const StoredDataset& from = stored_file().at(name);
    if (from.type != Hdf5Type::text) refuse("'" + name + "' is no text");
    return {from.bytes.begin(), from.bytes.end()};
}

}  // namespace dmp
