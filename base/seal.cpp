// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/seal.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include "base/errors.hpp"
#include "base/safe_file.hpp"

namespace dmp {

namespace fs = std::filesystem;

namespace {

using Bytes = std::array<unsigned char, seal_size>;

// Not a letter, then dmp, then line ends of two kinds: a file mangled as text shows at once.
constexpr std::string_view magic =
    "\x89"
    "dmp\r\n\x1a\n";
// Where things stand in the seal; numbers are little-endian. What is not named is 0.
constexpr std::size_t name_at = 8, name_size = 16, version_at = 24, file_size_at = 32, contents_hash_at = 40;
constexpr std::size_t seal_hash_at = seal_size - 8;

void put(Bytes& bytes, std::size_t at, std::uint64_t value) {
    for (std::size_t k = 0; k < 8; ++k, value >>= 8) bytes.at(at + k) = static_cast<unsigned char>(value);
}

std::uint64_t get(const Bytes& bytes, std::size_t at) {
    std::uint64_t value = 0;
    for (std::size_t k = 8; k-- > 0;) value = (value << 8) | bytes.at(at + k);
    return value;
}

std::uint64_t hash_of_seal(const Bytes& bytes) { return XXH64(bytes.data(), seal_hash_at, 0); }

std::system_error system_error() { return {errno, std::generic_category()}; }

/// An open file; throws std::system_error.
class OpenFile {
  public:
    OpenFile(const fs::path& file, int flags) : descriptor_(::open(file.c_str(), flags | O_CLOEXEC)) {
        if (descriptor_ < 0) throw system_error();
    }
    ~OpenFile() { ::close(descriptor_); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[nodiscard]] std::uint64_t size() const {
        struct stat about {};
        if (::fstat(descriptor_, &about) != 0) throw system_error();
        return static_cast<std::uint64_t>(about.st_size);
    }
    /// As many bytes as there are, up to the span's size.
    [[nodiscard]] std::size_t read(std::uint64_t at, std::span<unsigned char> bytes) const {
        std::size_t done = 0;
        while (done < bytes.size()) {
            const ssize_t count =
                ::pread(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(at + done));
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) throw system_error();
            if (count == 0) break;
            done += static_cast<std::size_t>(count);
        }
        return done;
    }
    void write(std::uint64_t at, std::span<const unsigned char> bytes) const {
        std::size_t done = 0;
        while (done < bytes.size()) {
            const ssize_t count =
                ::pwrite(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(at + done));
            if (count < 0 && errno == EINTR) continue;
            if (count < 0) throw system_error();
            done += static_cast<std::size_t>(count);
        }
    }

  private:
    int descriptor_;
};

/// XXH64 with seed 0 of everything behind the seal.
std::uint64_t hash_of_contents(const OpenFile& file) {
    const std::unique_ptr<XXH64_state_t, decltype(&XXH64_freeState)> state(XXH64_createState(), XXH64_freeState);
    if (!state) throw std::bad_alloc();
    XXH64_reset(state.get(), 0);
    std::vector<unsigned char> buffer(std::size_t{1} << 20);
    std::uint64_t at = seal_size;
    while (const std::size_t count = file.read(at, buffer)) {
        XXH64_update(state.get(), buffer.data(), count);
        at += count;
    }
    return XXH64_digest(state.get());
}

std::string sizes_text(std::uint64_t found, std::uint64_t whole) {
    return std::to_string(found) + " of " + std::to_string(whole) + " bytes";
}

/// What is wrong with the file, or "".
std::string problem_with(const OpenFile& file, const SealedKind& kind) {
    const std::uint64_t size = file.size();
    Bytes bytes{};
    const std::size_t found = file.read(0, bytes);
    if (found == 0) return "empty";
    if (std::memcmp(bytes.data(), magic.data(), std::min(found, magic.size())) != 0)
        return "not a dmp " + std::string(kind.name) + ": it begins otherwise";
    if (found < seal_size) return "truncated: " + std::to_string(size) + " bytes, less than its seal";
    if (get(bytes, seal_hash_at) != hash_of_seal(bytes)) return "damaged: the checksum of its seal differs";

    std::string name(reinterpret_cast<const char*>(bytes.data()) + name_at, name_size);
    name.resize(std::min(name.find('\0'), name.size()));
    if (name != kind.name) return "not a dmp " + std::string(kind.name) + " but a dmp " + name;
    const std::uint64_t version = get(bytes, version_at);
    if (version > kind.version)
        return "of a newer format: " + std::to_string(version) + ", and this dmp knows up to " +
               std::to_string(kind.version);
    const std::uint64_t whole = get(bytes, file_size_at);
    if (size < whole) return "truncated: " + sizes_text(size, whole);
    if (size > whole) return "damaged: " + sizes_text(size, whole) + ", more than were written";
    if (get(bytes, contents_hash_at) != hash_of_contents(file)) return "damaged: its checksum differs";
    return "";
}

}  // namespace

void seal(const fs::path& file, const SealedKind& kind, const fs::path& shown_as) {
    if (kind.name.size() > name_size) throw std::logic_error("the name of a sealed file is too long");
    try {
        const OpenFile open(file, O_RDWR);
        Bytes bytes{};
        std::memcpy(bytes.data(), magic.data(), magic.size());
        std::memcpy(bytes.data() + name_at, kind.name.data(), kind.name.size());
        put(bytes, version_at, kind.version);
        put(bytes, file_size_at, open.size());
        put(bytes, contents_hash_at, hash_of_contents(open));
        put(bytes, seal_hash_at, hash_of_seal(bytes));
        open.write(0, bytes);
    } catch (const std::system_error& error) {
        throw_write_error(shown_as, error.code().message());
    }
}

void check_seal(const fs::path& file, const SealedKind& kind) {
    std::string problem;
    try {
        problem = problem_with(OpenFile(file, O_RDONLY), kind);
    } catch (const std::system_error& error) {
        problem = "not readable: " + error.code().message();
    }
    if (!problem.empty())
        throw InputError(SourceLocation{file.string(), 0, 0}, problem,
                         "Use another file, or restore this one from a copy.");
}

}  // namespace dmp
