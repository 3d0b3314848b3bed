// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

#include "cli/locked_folder.hpp"
#include "cli/uses.hpp"
#include "study/study.hpp"

namespace dmp::cli {

/// What says of which study the runs in a folder are.
inline constexpr const char* sweep_file_name = "sweep.toml";
/// Copies of the study and of its scene, to look at.
inline constexpr const char* study_copy_name = "study.toml";
inline constexpr const char* scene_copy_name = "scene.toml";

/// What is in a folder for a study.
struct SweepContents {
    enum class Kind {
        nothing,  ///< no folder, or an empty one
        foreign,  ///< files, and none of a study
        study     ///< runs of a study
    };
    Kind kind = Kind::nothing;
    std::string name;                                ///< of the study
    std::string identity;                            ///< study::identity_of it; "" where it cannot be read
    std::string version;                             ///< of the dmp that wrote it
    std::map<std::string, std::string> input_files;  ///< hashes of the contents of the scene's files, by name
};

/// Looks only.
[[nodiscard]] SweepContents sweep_contents_of(const std::filesystem::path& folder);

/// The folder of one run of a study.
[[nodiscard]] std::filesystem::path run_folder(const std::filesystem::path& folder, const std::string& run);
/// What that run said last, as long as it has not reached its end.
[[nodiscard]] std::filesystem::path run_output(const std::filesystem::path& folder, const std::string& run);

/// Whether this is the name of a run, NNNN_hhhhhhhh.
[[nodiscard]] bool is_run_name(const std::string& name);

/// A study that is about to write into a folder.
struct NewSweep {
    const study::Study& study;
    std::size_t runs = 0;
    bool resume = false, overwrite = false;
};

/// The folder of a study, locked while this object lives, with the copies of study and scene in it.
class SweepFolder {
  public:
    /// Throws InputError if the folder cannot be made or written to, another process writes there, or it holds what the
    /// command line does not say what to do with. Removes an earlier study where it is to be overwritten, and, without
    /// resume, one none of whose runs has begun.
    SweepFolder(const std::filesystem::path& folder, const NewSweep& sweep, const TypedCommand& typed);

    [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }
    /// What to tell of how the folder was found; "" if nothing.
    [[nodiscard]] const std::string& note() const { return note_; }
    void check() const { folder_.check(); }

  private:
    LockedFolder folder_;
    std::string note_;
};

/// For a job that does runs of a study, beside others: takes no lock. Makes the folder a study's where it is empty.
/// Throws InputError if it holds anything but this study.
void join_sweep_folder(const std::filesystem::path& folder, const NewSweep& sweep, const TypedCommand& typed);

}  // namespace dmp::cli
