// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "base/errors.hpp"
#include "base/hdf5_file.hpp"
#include "base/hdf5_library.hpp"

namespace dmp {

using hdf5::Handle;

namespace {

struct FoundDataset {
    Handle handle;
    Hdf5Type type = Hdf5Type::other;
    std::uint64_t length = 0;
};

/// For H5Lvisit: takes down the names. Hard links only: those to other files lead out of what was checked.
herr_t collect_name(hid_t /*group*/, const char* name, const H5L_info_t* info, void* data) {
    auto& names = *static_cast<std::vector<std::string>*>(data);
    if (info->type == H5L_TYPE_HARD) names.emplace_back(name);
    return 0;
}

}  // namespace

struct Hdf5Reader::State {
    std::filesystem::path path;
    Handle file;
    std::map<std::string, FoundDataset> datasets;
    std::vector<std::string> names;

    [[noreturn]] void refuse(const std::string& problem) const {
        throw InputError(SourceLocation{path.string(), 0, 0}, problem,
                         "Restore the file from a copy, or make it again.");
    }

    /// Passes on what an HDF5 call returned, or throws.
    template <class Result>
    Result check(Result result) {
        if (result < 0) refuse("cannot be read: " + hdf5::reason());
        return result;
    }

    void open_datasets() {
        std::vector<std::string> links;
        check(H5Lvisit(file.id(), H5_INDEX_NAME, H5_ITER_INC, collect_name, &links));
        for (const std::string& link : links) {
            const Handle object(check(H5Oopen(file.id(), link.c_str(), H5P_DEFAULT)), H5Oclose);
            if (H5Iget_type(object.id()) != H5I_DATASET) continue;
            FoundDataset dataset;
            dataset.handle = Handle(check(H5Dopen2(file.id(), link.c_str(), H5P_DEFAULT)), H5Dclose);
            const Handle space(check(H5Dget_space(dataset.handle.id())), H5Sclose);
            const Handle type(check(H5Dget_type(dataset.handle.id())), H5Tclose);
            dataset.length = static_cast<std::uint64_t>(check(H5Sget_simple_extent_npoints(space.id())));
            // What dmp writes has one dimension or, being one number or text, none.
            dataset.type = H5Sget_simple_extent_ndims(space.id()) <= 1 ? hdf5::type_of(type.id()) : Hdf5Type::other;
            datasets.emplace(link, std::move(dataset));
        }
        for (const auto& [name, dataset] : datasets) names.push_back(name);
    }

    [[nodiscard]] const FoundDataset& find(const std::string& name) const {
        const auto found = datasets.find(name);
        if (found == datasets.end()) refuse("has no dataset '" + name + "'");
        return found->second;
    }

    [[nodiscard]] const FoundDataset& find(const std::string& name, Hdf5Type wanted) const {
        const FoundDataset& dataset = find(name);
        if (dataset.type != wanted)
            refuse("dataset '" + name + "' holds " + hdf5::name_of(dataset.type) + ", not " + hdf5::name_of(wanted));
        return dataset;
    }

    [[nodiscard]] const FoundDataset& find_single(const std::string& name, Hdf5Type wanted) const {
        const FoundDataset& dataset = find(name, wanted);
        if (dataset.length != 1)
            refuse("dataset '" + name + "' holds " + std::to_string(dataset.length) + " elements, not one");
        return dataset;
    }

    /// A single text or number that hangs on a dataset.
    Handle attribute(const std::string& dataset, const std::string& name, Hdf5Type wanted) {
        Handle handle(H5Aopen(find(dataset).handle.id(), name.c_str(), H5P_DEFAULT), H5Aclose);
        if (handle.id() < 0) refuse("dataset '" + dataset + "' has no attribute '" + name + "'");
        const Handle type(check(H5Aget_type(handle.id())), H5Tclose);
        const Handle space(check(H5Aget_space(handle.id())), H5Sclose);
        if (hdf5::type_of(type.id()) != wanted || H5Sget_simple_extent_npoints(space.id()) != 1)
            refuse("attribute '" + name + "' of dataset '" + dataset + "' is not one " + hdf5::name_of(wanted));
        return handle;
    }
};

namespace {

/// Without the zeros that fill a text up.
std::string without_padding(std::string text) {
    text.resize(text.find_last_not_of('\0') + 1);
    return text;
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file) : state_(std::make_unique<State>()) {
    hdf5::prepare();
    state_->path = file;
    state_->file = Handle(state_->check(H5Fopen(file.c_str(), H5F_ACC_RDONLY, hdf5::file_access().id())), H5Fclose);
    state_->open_datasets();
}

Hdf5Reader::~Hdf5Reader() = default;

const std::vector<std::string>& Hdf5Reader::names() const { return state_->names; }

bool Hdf5Reader::has(const std::string& name) const { return state_->datasets.contains(name); }

Hdf5Type Hdf5Reader::type(const std::string& name) const { return state_->find(name).type; }

std::uint64_t Hdf5Reader::length(const std::string& name) const { return state_->find(name).length; }

void Hdf5Reader::read(const std::string& name, Hdf5Type type, std::uint64_t offset, std::uint64_t count,
                      void* slice) const {
    const FoundDataset& dataset = state_->find(name, type);
    if (offset > dataset.length || count > dataset.length - offset)
        state_->refuse("dataset '" + name + "' has " + std::to_string(dataset.length) + " elements, fewer than the " +
                       std::to_string(count) + " from number " + std::to_string(offset) + " on");
    if (count == 0) return;
    const hsize_t start = offset, size = count;
    const Handle there(state_->check(H5Dget_space(dataset.handle.id())), H5Sclose);
    const Handle here(state_->check(H5Screate_simple(1, &size, nullptr)), H5Sclose);
    state_->check(H5Sselect_hyperslab(there.id(), H5S_SELECT_SET, &start, nullptr, &size, nullptr));
    state_->check(H5Dread(dataset.handle.id(), hdf5::memory_type(type), here.id(), there.id(), H5P_DEFAULT, slice));
}

void Hdf5Reader::read_number(const std::string& name, Hdf5Type type, void* value) const {
    const FoundDataset& dataset = state_->find_single(name, type);
    state_->check(H5Dread(dataset.handle.id(), hdf5::memory_type(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, value));
}

std::string Hdf5Reader::text(const std::string& name) const {
    (void)state_->find_single(name, Hdf5Type::text);
    return texts(name).front();
}

std::vector<std::string> Hdf5Reader::texts(const std::string& name) const {
    const FoundDataset& dataset = state_->find(name, Hdf5Type::text);
    const Handle stored(state_->check(H5Dget_type(dataset.handle.id())), H5Tclose);
    const std::size_t size = H5Tget_size(stored.id());
    std::string table(size * dataset.length, '\0');
    if (!table.empty())
        state_->check(H5Dread(dataset.handle.id(), stored.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, table.data()));
    std::vector<std::string> texts;
    for (std::size_t n = 0; n < dataset.length; ++n) texts.push_back(without_padding(table.substr(n * size, size)));
    return texts;
}

std::string Hdf5Reader::text_attribute(const std::string& dataset, const std::string& name) const {
    const Handle attribute = state_->attribute(dataset, name, Hdf5Type::text);
    const Handle stored(state_->check(H5Aget_type(attribute.id())), H5Tclose);
    std::string text(H5Tget_size(stored.id()), '\0');
    state_->check(H5Aread(attribute.id(), stored.id(), text.data()));
    return without_padding(text);
}

void Hdf5Reader::read_attribute(const std::string& dataset, const std::string& name, Hdf5Type type, void* value) const {
    const Handle attribute = state_->attribute(dataset, name, type);
    state_->check(H5Aread(attribute.id(), hdf5::memory_type(type), value));
}

void Hdf5Reader::refuse(const std::string& problem) const { state_->refuse(problem); }

}  // namespace dmp
