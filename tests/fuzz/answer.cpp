// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as what comes over the border between dmp and the process that reads a stranger's geometry: an answer, or a
// request. They are a value that is written and read as it was, or a std::runtime_error.
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>

#include "geometry/geometry_bytes.hpp"
#include "tests/modules.hpp"

namespace {

template <class Value>
void read_twice(std::string_view bytes, Value (*read)(std::string_view)) {
    const std::string again = dmp::geometry::bytes_of(read(bytes));
    if (dmp::geometry::bytes_of(read(again)) != again) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        if (data[0] == 'G')
            read_twice(bytes, dmp::geometry::geometry_of);
        else if (data[0] == 'I')
            read_twice(bytes, dmp::geometry::error_text_of);
        else if (data[0] == 'Q')
            read_twice(bytes, dmp::geometry::geometry_options_from_bytes);
    } catch (const std::runtime_error&) {
        return 0;
    }
    return 0;
}
