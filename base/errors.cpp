// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/errors.hpp"

namespace dmp {

std::string SourceLocation::text() const {
    if (!known() || line == 0) return file;
    std::string text = file + ":" + std::to_string(line);
    if (column > 0) text += ":" + std::to_string(column);
    return text;
}

namespace {

std::string whole_message(const SourceLocation& where, const std::string& problem, const std::string& what_to_do) {
    std::string message = where.known() ? where.text() + ": " + problem : problem;
    if (!what_to_do.empty()) message += "\n  " + what_to_do;
    return message;
}

}  // namespace

Error::Error(SourceLocation where, std::string what, std::string what_to_do)
    : std::runtime_error(whole_message(where, what, what_to_do)),
      where_(std::move(where)),
      problem_(std::move(what)),
      what_to_do_(std::move(what_to_do)) {}

}  // namespace dmp
