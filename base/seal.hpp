// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace dmp {

/// The first bytes of a sealed file, which the seal takes up [bytes].
inline constexpr std::uint64_t seal_size = 512;

/// What a sealed file is.
struct SealedKind {
    std::string_view name;      ///< "checkpoint": 16 letters at most
    std::uint32_t version = 1;  ///< of what is in it; files of a later version are refused
};

/// Writes the seal into the first seal_size bytes of a file: what it is, how long it is, and checksums (XXH64) of the
/// seal and of everything behind it; see docs/files.md. Throws ResourceError, which calls the file `shown_as`.
void seal(const std::filesystem::path& file, const SealedKind& kind, const std::filesystem::path& shown_as);

/// Reads the whole file and throws InputError when it is not what was sealed as `kind`: missing, no file of dmp, of
/// another kind or a later version, truncated, damaged. The problem goes with "FILE is ...".
void check_seal(const std::filesystem::path& file, const SealedKind& kind);

}  // namespace dmp
