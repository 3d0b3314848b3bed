// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tests/modules.hpp"

namespace dmp::tests {

/// What a program left when it ended.
struct Outcome {
    int code = -1;  ///< exit code; 128 + the signal's number when a signal ended it
    std::string output, errors;
};

/// A folder of its own for a test, gone with this object.
class CaseFolder {
  public:
    CaseFolder();
    ~CaseFolder();
    CaseFolder(const CaseFolder&) = delete;
    CaseFolder& operator=(const CaseFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Copies the files of cases/NAME here.
    void copy_case(const std::string& name) const;
    [[nodiscard]] std::string read(const std::string& file) const;
    void write(const std::string& file, const std::string& text) const;
    /// Replaces the first `from` in a file; throws std::logic_error when the file has none.
    void replace(const std::string& file, const std::string& from, const std::string& to) const;

  private:
    std::filesystem::path path_;
};

/// How to start dmp, besides its arguments.
struct Surroundings {
    std::vector<std::string> environment{};  ///< "NAME=VALUE", on top of this process'
    long largest_file = 0;                   ///< limit of a file's size [bytes]; 0: none
    long most_memory = 0;                    ///< limit of its addresses [bytes]; 0: none
    std::string interrupt_at{};  ///< send a signal when this file is there, relative to the folder; "": never
    std::function<bool()> interrupt_when{};  ///< send it as soon as this holds, asked all the time; none: never
    int signal = SIGINT;                     ///< the one to send
    int ranks = 0;                           ///< under mpirun, which then gets the signal; 0: without
    bool for_clusters = false;               ///< the dmp that is built without gmsh, CGAL and VTK
};

/// Runs the dmp that was built, in `folder`, with stdin closed, and waits for its end.
Outcome run_dmp(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                const Surroundings& surroundings = {});

}  // namespace dmp::tests
