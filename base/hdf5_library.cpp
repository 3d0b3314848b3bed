// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/hdf5_library.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace dmp::hdf5 {

namespace {

/// For H5Ewalk: the system's message wherever it stands, else the innermost description.
herr_t collect_reason(unsigned /*n*/, const H5E_error2_t* error, void* data) {
    auto& found = *static_cast<std::string*>(data);
    const std::string_view text = error->desc != nullptr ? error->desc : "";
    constexpr std::string_view mark = "error message = '";
    const auto at = text.find(mark);
    if (at != std::string_view::npos) {
        const auto message = text.substr(at + mark.size());
        found = message.substr(0, message.find('\''));
        return 1;
    }
    if (found.empty()) found = text;
    return 0;
}

}  // namespace

void prepare() {
    // First of all calls: at the exit, HDF5 would try again to write what it could not write, and fail over it.
    static const herr_t left_at_exit = H5dont_atexit();
    static_cast<void>(left_at_exit);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

std::string reason() {
    std::string found;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, collect_reason, &found);
    H5Eclear2(H5E_DEFAULT);
    return found.empty() ? "HDF5 gives no reason" : found;
}

hid_t memory_type(Hdf5Type type) {
    switch (type) {
        case Hdf5Type::float64:
            return H5T_NATIVE_DOUBLE;
        case Hdf5Type::float32:
            return H5T_NATIVE_FLOAT;
        case Hdf5Type::int64:
            return H5T_NATIVE_INT64;
        case Hdf5Type::int32:
            return H5T_NATIVE_INT32;
        case Hdf5Type::uint16:
            return H5T_NATIVE_UINT16;
        case Hdf5Type::uint8:
            return H5T_NATIVE_UINT8;
        case Hdf5Type::text:
        case Hdf5Type::other:
            break;
    }
    throw std::logic_error(std::string("elements of type ") + name_of(type) + " are no numbers");
}

hid_t file_type(Hdf5Type type) {
    switch (type) {
        case Hdf5Type::float64:
            return H5T_IEEE_F64LE;
        case Hdf5Type::float32:
            return H5T_IEEE_F32LE;
        case Hdf5Type::int64:
            return H5T_STD_I64LE;
        case Hdf5Type::int32:
            return H5T_STD_I32LE;
        case Hdf5Type::uint16:
            return H5T_STD_U16LE;
        case Hdf5Type::uint8:
            return H5T_STD_U8LE;
        case Hdf5Type::text:
        case Hdf5Type::other:
            break;
    }
    throw std::logic_error(std::string("elements of type ") + name_of(type) + " are no numbers");
}

Hdf5Type type_of(hid_t datatype) {
    const H5T_class_t kind = H5Tget_class(datatype);
    if (kind == H5T_STRING && H5Tis_variable_str(datatype) == 0) return Hdf5Type::text;
    for (const Hdf5Type type :
         {Hdf5Type::float64, Hdf5Type::float32, Hdf5Type::int64, Hdf5Type::int32, Hdf5Type::uint16, Hdf5Type::uint8}) {
        const hid_t same = memory_type(type);
        if (kind == H5Tget_class(same) && H5Tget_size(datatype) == H5Tget_size(same) &&
            (kind != H5T_INTEGER || H5Tget_sign(datatype) == H5Tget_sign(same)))
            return type;
    }
    return Hdf5Type::other;
}

const char* name_of(Hdf5Type type) {
    switch (type) {
        case Hdf5Type::float64:
            return "float64";
        case Hdf5Type::float32:
            return "float32";
        case Hdf5Type::int64:
            return "int64";
        case Hdf5Type::int32:
            return "int32";
        case Hdf5Type::uint16:
            return "uint16";
        case Hdf5Type::uint8:
            return "uint8";
        case Hdf5Type::text:
            return "text";
        case Hdf5Type::other:
            break;
    }
    return "a type dmp does not know";
}

Handle text_type(std::size_t bytes) {
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.id(), std::max<std::size_t>(bytes, 1));
    H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
    H5Tset_cset(type.id(), H5T_CSET_UTF8);
    return type;
}

Handle file_access() {
    Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_file_locking(access.id(), false, true);
    return access;
}

}  // namespace dmp::hdf5
