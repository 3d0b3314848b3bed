// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <stdexcept>

#include <unistd.h>

#include "base/hdf5_file.hpp"
#include "base/hdf5_library.hpp"
#include "base/safe_file.hpp"

namespace dmp {

using hdf5::Handle;

namespace {

struct NewDataset {
    Handle handle;
    Hdf5Type type;
    std::uint64_t length = 0;
    std::uint64_t written = 0;
};

/// Groups above a dataset are made with it, and nothing says when.
Handle link_properties() {
    Handle properties(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(properties.id(), 1);
    return properties;
}

Handle dataset_properties() {
    Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(properties.id(), false);
    return properties;
}

}  // namespace

struct Hdf5Writer::State {
    std::filesystem::path path, shown;
    Handle file;
    std::map<std::string, NewDataset> datasets;

    State(const std::filesystem::path& file_path, const Hdf5FileOptions& options)
        : path(file_path), shown(options.shown_as.empty() ? file_path : options.shown_as) {}
    ~State() {
        if (file.id() < 0) return;
        ::unlink(path.c_str());
        if (H5Fflush(file.id(), H5F_SCOPE_GLOBAL) < 0) abandon();
        H5Eclear2(H5E_DEFAULT);
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    /// HDF5 1.10 keeps numbers of freed memory for what could not be written to the end when it was closed, and follows
    /// them later. So that is left open, without its bytes on the disk.
    void abandon() {
        void* descriptor = nullptr;
        if (H5Fget_vfd_handle(file.id(), H5P_DEFAULT, &descriptor) >= 0) {
            [[maybe_unused]] const int given_back = ::ftruncate(*static_cast<int*>(descriptor), 0);
        }
        for (auto& [name, dataset] : datasets) dataset.handle.release();
        file.release();
    }

    /// Passes on what an HDF5 call returned, or throws.
    template <class Result>
    Result check(Result result) {
        if (result < 0) throw_write_error(shown, hdf5::reason());
        return result;
    }

    NewDataset& add(const std::string& name, Hdf5Type type, hid_t datatype, const Handle& space,
                    const Handle& properties) {
        if (datasets.contains(name)) throw std::logic_error("dataset '" + name + "' is there already");
        Handle handle(check(H5Dcreate2(file.id(), name.c_str(), datatype, space.id(), link_properties().id(),
                                       properties.id(), H5P_DEFAULT)),
                      H5Dclose);
        const auto length = static_cast<std::uint64_t>(check(H5Sget_simple_extent_npoints(space.id())));
        return datasets.emplace(name, NewDataset{std::move(handle), type, length}).first->second;
    }

    /// A dataset of texts or of one number, at once.
    void add_whole(const std::string& name, Hdf5Type type, hid_t file_type, hid_t memory_type, const Handle& space,
                   const void* values) {
        NewDataset& dataset = add(name, type, file_type, space, dataset_properties());
        if (dataset.length > 0)
            check(H5Dwrite(dataset.handle.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
        dataset.written = dataset.length;
    }

    NewDataset& find(const std::string& name) {
        const auto found = datasets.find(name);
        if (found == datasets.end()) throw std::logic_error("there is no dataset '" + name + "'");
        return found->second;
    }

    void add_attribute(const std::string& dataset, const std::string& name, hid_t file_type, hid_t memory_type,
                       const void* value) {
        const Handle space(check(H5Screate(H5S_SCALAR)), H5Sclose);
        const Handle attribute(
            check(H5Acreate2(find(dataset).handle.id(), name.c_str(), file_type, space.id(), H5P_DEFAULT, H5P_DEFAULT)),
            H5Aclose);
        check(H5Awrite(attribute.id(), memory_type, value));
    }
};

Hdf5Writer::Hdf5Writer(const std::filesystem::path& file, const Hdf5FileOptions& options)
    : state_(std::make_unique<State>(file, options)) {
    hdf5::prepare();
    const Handle creation(state_->check(H5Pcreate(H5P_FILE_CREATE)), H5Pclose);
    state_->check(H5Pset_userblock(creation.id(), options.user_block));
    state_->check(H5Pset_obj_track_times(creation.id(), false));
    state_->file = Handle(
        state_->check(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation.id(), hdf5::file_access().id())), H5Fclose);
}

Hdf5Writer::~Hdf5Writer() = default;

void Hdf5Writer::create(const std::string& name, Hdf5Type type, std::uint64_t length, Hdf5Storage storage) {
    const hsize_t size = length;
    const Handle space(state_->check(H5Screate_simple(1, &size, nullptr)), H5Sclose);
    const Handle properties = dataset_properties();
    if (length > 0) {
        const hsize_t chunk = std::min(storage.chunk, length);
        state_->check(H5Pset_chunk(properties.id(), 1, &chunk));
        if (storage.deflate > 0) {
            state_->check(H5Pset_shuffle(properties.id()));
            state_->check(H5Pset_deflate(properties.id(), static_cast<unsigned>(storage.deflate)));
        }
    }
    state_->add(name, type, hdf5::file_type(type), space, properties);
}

void Hdf5Writer::write(const std::string& name, Hdf5Type type, std::uint64_t offset, std::uint64_t count,
                       const void* slice) {
    NewDataset& dataset = state_->find(name);
    if (dataset.type != type)
        throw std::logic_error("dataset '" + name + "' holds " + hdf5::name_of(dataset.type) + ", not " +
                               hdf5::name_of(type));
    if (offset > dataset.length || count > dataset.length - offset)
        throw std::logic_error("dataset '" + name + "' ends before its slice");
    if (count == 0) return;
    const hsize_t start = offset, size = count;
    const Handle there(state_->check(H5Dget_space(dataset.handle.id())), H5Sclose);
    const Handle here(state_->check(H5Screate_simple(1, &size, nullptr)), H5Sclose);
    state_->check(H5Sselect_hyperslab(there.id(), H5S_SELECT_SET, &start, nullptr, &size, nullptr));
    state_->check(H5Dwrite(dataset.handle.id(), hdf5::memory_type(type), here.id(), there.id(), H5P_DEFAULT, slice));
    dataset.written += count;
}

void Hdf5Writer::write_number(const std::string& name, Hdf5Type type, const void* value) {
    const Handle space(state_->check(H5Screate(H5S_SCALAR)), H5Sclose);
    state_->add_whole(name, type, hdf5::file_type(type), hdf5::memory_type(type), space, value);
}

void Hdf5Writer::write_text(const std::string& name, std::string_view text) {
    const Handle space(state_->check(H5Screate(H5S_SCALAR)), H5Sclose);
    const Handle type = hdf5::text_type(text.size());
    const std::string ended(text);  // a text of size 0 is written as one zero
    state_->add_whole(name, Hdf5Type::text, type.id(), type.id(), space, ended.c_str());
}

void Hdf5Writer::write_texts(const std::string& name, std::span<const std::string> texts) {
    std::size_t longest = 1;
    for (const std::string& text : texts) longest = std::max(longest, text.size());
    std::string table;
    for (const std::string& text : texts) table += text + std::string(longest - text.size(), '\0');
    const hsize_t size = texts.size();
    const Handle space(state_->check(H5Screate_simple(1, &size, nullptr)), H5Sclose);
    const Handle type = hdf5::text_type(longest);
    state_->add_whole(name, Hdf5Type::text, type.id(), type.id(), space, table.data());
}

void Hdf5Writer::set_attribute(const std::string& dataset, const std::string& name, std::string_view text) {
    const Handle type = hdf5::text_type(text.size());
    const std::string ended(text);
    state_->add_attribute(dataset, name, type.id(), type.id(), ended.c_str());
}

void Hdf5Writer::set_attribute(const std::string& dataset, const std::string& name, Hdf5Type type, const void* number) {
    state_->add_attribute(dataset, name, hdf5::file_type(type), hdf5::memory_type(type), number);
}

void Hdf5Writer::close() {
    for (const auto& [name, dataset] : state_->datasets)
        if (dataset.written != dataset.length)
            throw std::logic_error("dataset '" + name + "' has " + std::to_string(dataset.length) + " elements, and " +
                                   std::to_string(dataset.written) + " were written");
    state_->check(H5Fflush(state_->file.id(), H5F_SCOPE_GLOBAL));
    for (auto& [name, dataset] : state_->datasets) state_->check(dataset.handle.close());
    state_->check(state_->file.close());
}

}  // namespace dmp
