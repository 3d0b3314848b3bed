// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace dmp {

/// A place in a text the user wrote. Line and column count from 1; 0 means "no such place".
struct SourceLocation {
    std::string file;
    int line = 0;
    int column = 0;

    [[nodiscard]] bool known() const { return !file.empty(); }
    /// "scene.toml:12:5", "scene.toml" when there is no line, "" when nothing is known.
    [[nodiscard]] std::string text() const;
};

/// Every error of dmp says what is wrong, where, and what to do about it.
class Error : public std::runtime_error {
  public:
    Error(SourceLocation where, std::string what, std::string what_to_do);

    [[nodiscard]] const SourceLocation& where() const { return where_; }
    [[nodiscard]] const std::string& problem() const { return problem_; }
    [[nodiscard]] const std::string& what_to_do() const { return what_to_do_; }

  private:
    SourceLocation where_;
    std::string problem_;
    std::string what_to_do_;
};

/// The user's input is wrong: scene, geometry, command line (exit code 2).
class InputError : public Error {
  public:
    using Error::Error;
    InputError(std::string what, std::string what_to_do) : Error({}, std::move(what), std::move(what_to_do)) {}
};

/// The simulation left the region where its equations hold (exit code 3).
class DivergenceError : public Error {
  public:
    DivergenceError(std::string what, std::string what_to_do) : Error({}, std::move(what), std::move(what_to_do)) {}
};

/// The machine ran out of something: disk, memory, files (exit code 4).
class ResourceError : public Error {
  public:
    ResourceError(std::string what, std::string what_to_do) : Error({}, std::move(what), std::move(what_to_do)) {}
};

}  // namespace dmp
