// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dmp {

/// What a dataset holds. "other": nothing that dmp writes.
enum class Hdf5Type { float64, float32, int64, int32, uint16, uint8, text, other };

template <class T>
concept Hdf5Number = std::same_as<T, double> || std::same_as<T, float> || std::same_as<T, std::int64_t> ||
    std::same_as<T, std::int32_t> || std::same_as<T, std::uint16_t> || std::same_as<T, std::uint8_t>;

/// The type of a dataset whose elements are read and written as T.
template <Hdf5Number T>
constexpr Hdf5Type hdf5_type() {
    if constexpr (std::same_as<T, double>) return Hdf5Type::float64;
    if constexpr (std::same_as<T, float>) return Hdf5Type::float32;
    if constexpr (std::same_as<T, std::int64_t>) return Hdf5Type::int64;
    if constexpr (std::same_as<T, std::int32_t>) return Hdf5Type::int32;
    if constexpr (std::same_as<T, std::uint16_t>) return Hdf5Type::uint16;
    if constexpr (std::same_as<T, std::uint8_t>) return Hdf5Type::uint8;
}

/// How the elements of a dataset lie in the file.
struct Hdf5Storage {
    std::uint64_t chunk = 65536;  ///< elements in a chunk
    int deflate = 0;              ///< 0: as they are; 1 (fast) to 9 (small): shuffled and deflated
};

struct Hdf5FileOptions {
    std::uint64_t user_block = 0;    ///< bytes left free at the file's beginning: 0, or a power of 2 from 512 on
    std::filesystem::path shown_as;  ///< the file's name in errors; empty: its own
};

/// Writes one HDF5 file: numbers in 1-D datasets, single numbers and texts. A name's slashes are groups, which are made
/// as needed. The same calls give the same bytes: no times are stored.
///
/// Every call throws ResourceError when the file cannot be written, and std::logic_error for a name that is not there
/// or there already, elements of another type than the dataset's, and a slice past its end. Not for several threads at
/// once: Debian's HDF5 is not made for that.
class Hdf5Writer {
  public:
    /// Makes the file, in place of one that may be there.
    explicit Hdf5Writer(const std::filesystem::path& file, const Hdf5FileOptions& options = {});
    /// Without close(): removes the file.
    ~Hdf5Writer();
    Hdf5Writer(const Hdf5Writer&) = delete;
    Hdf5Writer& operator=(const Hdf5Writer&) = delete;

    /// A dataset of `length` elements, to be filled in slices.
    template <Hdf5Number T>
    void create(const std::string& name, std::uint64_t length, Hdf5Storage storage = {}) {
        create(name, hdf5_type<T>(), length, storage);
    }
    /// Elements `offset` and on of a dataset. Each element is to be written once.
    template <Hdf5Number T>
    void write(const std::string& name, std::uint64_t offset, std::span<const T> slice) {
        write(name, hdf5_type<T>(), offset, slice.size(), slice.data());
    }

    /// A dataset, all at once.
    template <Hdf5Number T>
    void write_array(const std::string& name, std::span<const T> values, Hdf5Storage storage = {}) {
        create<T>(name, values.size(), storage);
        write<T>(name, 0, values);
    }
    /// One number, a dataset without extent.
    template <Hdf5Number T>
    void write_number(const std::string& name, T value) {
        write_number(name, hdf5_type<T>(), &value);
    }
    /// UTF-8 without zero bytes at its end, a dataset without extent.
    void write_text(const std::string& name, std::string_view text);
    void write_texts(const std::string& name, std::span<const std::string> texts);

    /// A remark on a dataset, such as its unit.
    void set_attribute(const std::string& dataset, const std::string& name, std::string_view text);
    template <Hdf5Number T>
    void set_attribute(const std::string& dataset, const std::string& name, T number) {
        set_attribute(dataset, name, hdf5_type<T>(), &number);
    }

    /// Hands everything to the operating system. Throws std::logic_error when a dataset was not filled.
    void close();

  private:
    void create(const std::string& name, Hdf5Type type, std::uint64_t length, Hdf5Storage storage);
    void write(const std::string& name, Hdf5Type type, std::uint64_t offset, std::uint64_t count, const void* slice);
    void write_number(const std::string& name, Hdf5Type type, const void* value);
    void set_attribute(const std::string& dataset, const std::string& name, Hdf5Type type, const void* number);

    struct State;
    std::unique_ptr<State> state_;
};

/// Reads one HDF5 file. Every call throws InputError, with the file's name, when the file is not what is asked for: no
/// such dataset, another type, too short. Not for several threads at once.
class Hdf5Reader {
  public:
    explicit Hdf5Reader(const std::filesystem::path& file);
    ~Hdf5Reader();
    Hdf5Reader(const Hdf5Reader&) = delete;
    Hdf5Reader& operator=(const Hdf5Reader&) = delete;

    /// The datasets with their groups, "group/name", in alphabetical order.
    [[nodiscard]] const std::vector<std::string>& names() const;
    [[nodiscard]] bool has(const std::string& name) const;
    [[nodiscard]] Hdf5Type type(const std::string& name) const;
    /// Elements of a dataset; 1 for a single number or text.
    [[nodiscard]] std::uint64_t length(const std::string& name) const;

    /// Elements `offset` and on, as many as the slice has.
    template <Hdf5Number T>
    void read(const std::string& name, std::uint64_t offset, std::span<T> slice) const {
        read(name, hdf5_type<T>(), offset, slice.size(), slice.data());
    }
    template <Hdf5Number T>
    [[nodiscard]] std::vector<T> array(const std::string& name) const {
        std::vector<T> values(length(name));
        read<T>(name, 0, values);
        return values;
    }
    template <Hdf5Number T>
    [[nodiscard]] T number(const std::string& name) const {
        T value{};
        read_number(name, hdf5_type<T>(), &value);
        return value;
    }
    [[nodiscard]] std::string text(const std::string& name) const;
    [[nodiscard]] std::vector<std::string> texts(const std::string& name) const;

    [[nodiscard]] std::string text_attribute(const std::string& dataset, const std::string& name) const;
    template <Hdf5Number T>
    [[nodiscard]] T number_attribute(const std::string& dataset, const std::string& name) const {
        T value{};
        read_attribute(dataset, name, hdf5_type<T>(), &value);
        return value;
    }

    /// Throws the InputError for this file; for those who know more about what it should hold.
    [[noreturn]] void refuse(const std::string& problem) const;

  private:
    void read(const std::string& name, Hdf5Type type, std::uint64_t offset, std::uint64_t count, void* slice) const;
    void read_number(const std::string& name, Hdf5Type type, void* value) const;
    void read_attribute(const std::string& dataset, const std::string& name, Hdf5Type type, void* value) const;

    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace dmp
