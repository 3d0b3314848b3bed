// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json_value.hpp"

#include <algorithm>
#include <limits>

#include "base/errors.hpp"
#include "base/safe_file.hpp"

namespace dmp::report {

namespace {

constexpr const char* what_to_do = "Restore the file or run the simulation again.";

}  // namespace

void JsonValue::fail(const std::string& expected) const {
    throw InputError(SourceLocation{file_.string(), 0, 0}, "'" + name_ + "' is not " + expected, what_to_do);
}

JsonValue JsonValue::operator[](const std::string& key) const {
    const std::string name = name_.empty() ? key : name_ + "." + key;
    if (json_ == nullptr) return {nullptr, file_, name};
    if (!json_->is_object()) fail("an object");
    const auto found = json_->find(key);
    return {found == json_->end() ? nullptr : &*found, file_, name};
}

double JsonValue::number() const {
    if (json_ == nullptr || json_->is_null()) return std::numeric_limits<double>::quiet_NaN();
    if (!json_->is_number()) fail("a number");
    return json_->get<double>();
}

std::string JsonValue::text() const {
    if (json_ == nullptr) return "";
    if (!json_->is_string()) fail("a text");
    return json_->get<std::string>();
}

bool JsonValue::truth() const {
    if (json_ == nullptr) return false;
    if (!json_->is_boolean()) fail("true or false");
    return json_->get<bool>();
}

std::vector<JsonValue> JsonValue::elements() const {
    std::vector<JsonValue> result;
    if (json_ == nullptr) return result;
    if (!json_->is_array()) fail("a list");
    for (const Json& element : *json_)
        result.emplace_back(&element, file_, name_ + "[" + std::to_string(result.size()) + "]");
    return result;
}

std::vector<std::string> JsonValue::texts() const {
    std::vector<std::string> all;
    for (const JsonValue& each : elements()) all.push_back(each.text());
    return all;
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::members() const {
    std::vector<std::pair<std::string, JsonValue>> result;
    if (json_ == nullptr) return result;
    if (!json_->is_object()) fail("an object");
    for (const auto& [key, value] : json_->items()) result.emplace_back(key, (*this)[key]);
    return result;
}

JsonValue::Json read_json_object(const std::filesystem::path& file) {
    const std::string text = read_file(file);
    try {
        JsonValue::Json json = JsonValue::Json::parse(text);
        if (!json.is_object())
            throw InputError(SourceLocation{file.string(), 1, 1}, "it does not hold a JSON object", what_to_do);
        return json;
    } catch (const JsonValue::Json::parse_error& error) {
        const std::string before = text.substr(0, error.byte > 0 ? error.byte - 1 : 0);
        const auto line = static_cast<int>(std::ranges::count(before, '\n')) + 1;
        const auto column = static_cast<int>(before.size() - (before.rfind('\n') + 1)) + 1;
        throw InputError(SourceLocation{file.string(), line, column}, "this is not valid JSON", what_to_do);
    } catch (const JsonValue::Json::exception&) {  // such as a number that is too large
        throw InputError(SourceLocation{file.string(), 0, 0}, "this is not valid JSON", what_to_do);
    }
}

}  // namespace dmp::report
