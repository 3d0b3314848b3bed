// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace dmp::report {

/// A value of a JSON file, with its name. Reading one of another type throws InputError with the file and the name.
/// What the file does not have is no error: older versions of dmp left less.
class JsonValue {
  public:
    using Json = nlohmann::ordered_json;

    JsonValue(const Json* json, std::filesystem::path file, std::string name = "")
        : json_(json), file_(std::move(file)), name_(std::move(name)) {}

    /// Throws the InputError that it is not as it should be: "'settings[2].error' is not a number".
    [[noreturn]] void fail(const std::string& expected) const;
    /// Missing, too, where this one is.
    [[nodiscard]] JsonValue operator[](const std::string& key) const;
    [[nodiscard]] bool is_there() const { return json_ != nullptr; }
    /// NaN where it is missing or null.
    [[nodiscard]] double number() const;
    /// "" where it is missing.
    [[nodiscard]] std::string text() const;
    /// False where it is missing.
    [[nodiscard]] bool truth() const;
    /// Of a list; none where it is missing.
    [[nodiscard]] std::vector<JsonValue> elements() const;
    /// Of a list of texts; none where it is missing.
    [[nodiscard]] std::vector<std::string> texts() const;
    /// Of an object, in their order; none where it is missing.
    [[nodiscard]] std::vector<std::pair<std::string, JsonValue>> members() const;

  private:
    const Json* json_;  ///< null: missing
    std::filesystem::path file_;
    std::string name_;
};

/// The JSON object in a file. Throws InputError with its line and column where it is none.
[[nodiscard]] JsonValue::Json read_json_object(const std::filesystem::path& file);

}  // namespace dmp::report
