// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/geometry_bytes.hpp"

#include <concepts>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace dmp::geometry {

namespace {

/// Not bool and no enumeration: not all bytes are one.
template <class T>
concept Number = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;

/// The fewest bytes that one takes: a count, where it is no number.
template <class T>
constexpr std::size_t least_bytes = sizeof(std::uint64_t);
template <Number T>
constexpr std::size_t least_bytes<T> = sizeof(T);
template <>
constexpr std::size_t least_bytes<Vec> = 3 * sizeof(double);
template <class T, std::size_t N>
constexpr std::size_t least_bytes<std::array<T, N>> = N* least_bytes<T>;

/// Appends values to bytes.
class Writer {
  public:
    template <Number T>
    void operator()(const T& value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    std::uint64_t size(std::uint64_t now, std::size_t /*least*/) {
        (*this)(now);
        return now;
    }
    void raw(char* data, std::size_t count) { bytes_.append(data, count); }
    static constexpr bool reads = false;
    std::string finish() { return std::move(bytes_); }

  private:
    std::string bytes_;
};

/// Takes values from bytes.
class Reader {
  public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}

    template <Number T>
    void operator()(T& value) {
        raw(reinterpret_cast<char*>(&value), sizeof value);
    }
    /// How many things follow, each of `least` bytes or more.
    std::uint64_t size(std::uint64_t /*now*/, std::size_t least) {
        std::uint64_t count = 0;
        (*this)(count);
        if (count > bytes_.size() / least) throw std::runtime_error("the bytes of a geometry end early");
        return count;
    }
    void raw(char* data, std::size_t count) {
        if (count > bytes_.size()) throw std::runtime_error("the bytes of a geometry end early");
        std::memcpy(data, bytes_.data(), count);
        bytes_.remove_prefix(count);
    }
    static constexpr bool reads = true;
    void finish() const {
        if (!bytes_.empty()) throw std::runtime_error("the bytes of a geometry go on after its end");
    }

  private:
    std::string_view bytes_;
};

// One pass for both directions. A writer changes nothing.

template <class Archive, Number T>
void pass(Archive& archive, T& value) {
    archive(value);
}

template <class Archive>
void pass(Archive& archive, bool& value) {
    std::uint8_t byte = value ? 1 : 0;
    archive(byte);
    if (byte > 1) throw std::runtime_error("the bytes of a geometry have a truth value of another kind");
    value = byte == 1;
}

template <class Archive>
void pass(Archive& archive, UnitSource& source) {
    auto number = static_cast<std::int32_t>(source);
    archive(number);
    if (number < 0 || number > static_cast<std::int32_t>(UnitSource::assumed))
        throw std::runtime_error("the bytes of a geometry have a unit from nowhere");
    source = static_cast<UnitSource>(number);
}

template <class Archive>
void pass(Archive& archive, Trust& trust) {
    auto number = static_cast<std::int32_t>(trust);
    archive(number);
    if (number < 0 || number > static_cast<std::int32_t>(Trust::full))
        throw std::runtime_error("the bytes of a geometry have a trust that there is not");
    trust = static_cast<Trust>(number);
}

template <class Archive>
void pass(Archive& archive, std::string& text) {
    text.resize(archive.size(text.size(), 1));
    archive.raw(text.data(), text.size());
}

template <class Archive>
void pass(Archive& archive, Vec& vector) {
    for (double& component : vector) archive(component);
}

template <class Archive>
void pass(Archive& archive, Box& box) {
    pass(archive, box.low);
    pass(archive, box.high);
}

template <class Archive, class T, std::size_t N>
void pass(Archive& archive, std::array<T, N>& values) {
    for (T& value : values) pass(archive, value);
}

template <class Archive, class T>
void pass(Archive& archive, std::vector<T>& values);
template <class Archive, class T>
void pass(Archive& archive, std::optional<T>& value);
template <class Archive, class T>
void pass(Archive& archive, std::map<std::string, T>& values);

template <class Archive>
void pass(Archive& archive, SourceLocation& location) {
    pass(archive, location.file);
    pass(archive, location.line);
    pass(archive, location.column);
}

template <class Archive>
void pass(Archive& archive, Polyline& line) {
    pass(archive, line.points);
    pass(archive, line.closed);
}

template <class Archive>
void pass(Archive& archive, Region& region) {
    pass(archive, region.name);
    pass(archive, region.loops);
}

template <class Archive>
void pass(Archive& archive, CurveSet& set) {
    pass(archive, set.name);
    pass(archive, set.pieces);
}

template <class Archive>
void pass(Archive& archive, TriangleSurface& surface) {
    pass(archive, surface.corners);
    pass(archive, surface.triangles);
    pass(archive, surface.left_out);
}

template <class Archive>
void pass(Archive& archive, Solid& solid) {
    pass(archive, solid.name);
    pass(archive, solid.surface);
}

template <class Archive>
void pass(Archive& archive, SurfaceSet& set) {
    pass(archive, set.name);
    pass(archive, set.surface);
    pass(archive, set.why_open);
}

template <class Archive, class T>
void pass(Archive& archive, std::vector<T>& values) {
    values.resize(archive.size(values.size(), least_bytes<T>));
    for (T& value : values) pass(archive, value);
}

template <class Archive, class T>
void pass(Archive& archive, std::optional<T>& value) {
    bool given = value.has_value();
    pass(archive, given);
    if (!given) return;
    if (!value) value.emplace();
    pass(archive, *value);
}

template <class Archive, class T>
void pass(Archive& archive, std::map<std::string, T>& values) {
    const std::uint64_t count = archive.size(values.size(), least_bytes<std::string>);
    if constexpr (Archive::reads) {
        for (std::uint64_t k = 0; k < count; ++k) {
            std::string key;
            pass(archive, key);
            pass(archive, values[key]);
        }
    } else {
        for (auto& [key, value] : values) {
            std::string copy = key;
            pass(archive, copy);
            pass(archive, value);
        }
    }
}

template <class Archive>
void pass(Archive& archive, Geometry& geometry) {
    pass(archive, geometry.file);
    pass(archive, geometry.dimension);
    pass(archive, geometry.box);
    pass(archive, geometry.regions);
    pass(archive, geometry.curves);
    pass(archive, geometry.solids);
    pass(archive, geometry.surfaces);
    pass(archive, geometry.points);
    pass(archive, geometry.unit);
    pass(archive, geometry.unit_source);
    pass(archive, geometry.warnings);
}

template <class Archive>
void pass(Archive& archive, GeometryOptions& options) {
    pass(archive, options.file);
    pass(archive, options.trust);
    pass(archive, options.unit);
    pass(archive, options.parameters);
    pass(archive, options.parameter_locations);
    pass(archive, options.chord_error);
    pass(archive, options.location);
}

template <class Archive>
void pass(Archive& archive, ErrorText& error) {
    pass(archive, error.location);
    pass(archive, error.problem);
    pass(archive, error.what_to_do);
}

template <class T>
std::string written(T value) {
    Writer writer;
    pass(writer, value);
    return writer.finish();
}

template <class T>
T read(std::string_view bytes) {
    Reader reader(bytes);
    T value;
    pass(reader, value);
    reader.finish();
    return value;
}

void check(const std::vector<Vec>& points) {
    for (const Vec& point : points)
        if (!point.allFinite()) throw std::runtime_error("the bytes of a geometry have a point that is not finite");
}

void check(const std::vector<Polyline>& lines) {
    for (const Polyline& line : lines) check(line.points);
}

void check(const TriangleSurface& surface) {
    check(surface.corners);
    const auto corners = static_cast<int>(surface.corners.size());
    for (const auto& triangle : surface.triangles)
        for (const int corner : triangle)
            if (corner < 0 || corner >= corners)
                throw std::runtime_error("the bytes of a geometry have a triangle with a corner that it has not");
}

/// What the rest of the program relies on.
Geometry checked(Geometry geometry) {
    if (geometry.dimension != 2 && geometry.dimension != 3)
        throw std::runtime_error("the bytes of a geometry have another number of dimensions than 2 and 3");
    for (const Region& region : geometry.regions) check(region.loops);
    for (const CurveSet& set : geometry.curves) check(set.pieces);
    for (const auto& [name, places] : geometry.points) check(places);
    for (const Solid& solid : geometry.solids) check(solid.surface);
    for (const SurfaceSet& set : geometry.surfaces) check(set.surface);
    return geometry;
}

}  // namespace

std::string bytes_of(const Geometry& geometry) { return written(geometry); }
std::string bytes_of(const GeometryOptions& options) { return written(options); }
std::string bytes_of(const ErrorText& error) { return written(error); }

Geometry geometry_of(std::string_view bytes) { return checked(read<Geometry>(bytes)); }
GeometryOptions geometry_options_from_bytes(std::string_view bytes) { return read<GeometryOptions>(bytes); }
ErrorText error_text_of(std::string_view bytes) { return read<ErrorText>(bytes); }

}  // namespace dmp::geometry
