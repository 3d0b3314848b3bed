// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/toml_node.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <toml++/toml.h>

#include "base/unlisted_value.hpp"
#include "scene/key_depth.hpp"

namespace dmp::scene {

namespace {

/// Access to the document's text by line and column.
class Source {
  public:
    Source(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {
        if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
        line_starts_.push_back(0);
        for (std::size_t i = 0; i < text_.size(); ++i) {
            if (text_[i] == '\n') line_starts_.push_back(i + 1);
        }
    }

    [[nodiscard]] SourceLocation location(const toml::source_position& position) const {
        return {file_, static_cast<int>(position.line), static_cast<int>(position.column)};
    }

    /// The text from a position on; empty if the position is not in the text.
    [[nodiscard]] std::string_view from(const toml::source_position& position) const {
        if (position.line == 0 || position.line > line_starts_.size()) return {};
        std::size_t at = line_starts_[position.line - 1];
        for (auto column = position.column; column > 1 && at < text_.size(); --column) {
            do {
                ++at;
            } while (at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xC0U) == 0x80U);
        }
        return text_.substr(std::min(at, text_.size()));
    }

    [[nodiscard]] std::string between(const toml::source_region& region) const {
        const auto rest = from(region.begin);
        const auto after = from(region.end);
        return std::string(rest.substr(0, rest.size() - std::min(rest.size(), after.size())));
    }

  private:
    std::string_view text_;
    std::string file_;
    std::vector<std::size_t> line_starts_;
};

WrittenText written_text(const std::string& value, const toml::source_position& begin, const Source& source) {
    WrittenText text{value, source.location(begin), {}};
    const auto raw = source.from(begin);
    for (const std::string_view quote : {"\"\"\"", "'''", "\"", "'"}) {
        if (!raw.starts_with(quote)) continue;
        auto inside = raw.substr(quote.size());
        SourceLocation first = text.location;
        if (quote.size() == 3 && inside.starts_with("\n")) {  // TOML drops a newline after the opening quotes
            inside.remove_prefix(1);
            ++first.line;
            first.column = 1;
        } else {
            first.column += static_cast<int>(quote.size());
        }
        // With an escape in the source, columns are unknown: only the location of the value is.
        if (inside.starts_with(value)) text.first_character = first;
        break;
    }
    return text;
}

TomlNode convert(const toml::node& value, const Source& source) {
    TomlNode node;
    node.location = source.location(value.source().begin);
    if (const auto* table = value.as_table()) {
        node.kind = TomlNode::Kind::table;
        for (const auto& [key, entry] : *table) {
            TomlNode child = convert(entry, source);
            child.key = std::string(key.str());
            child.key_location = source.location(key.source().begin);
            node.children.push_back(std::move(child));
        }
        std::stable_sort(node.children.begin(), node.children.end(), [](const TomlNode& a, const TomlNode& b) {
            return std::pair(a.key_location.line, a.key_location.column) <
                   std::pair(b.key_location.line, b.key_location.column);
        });
        return node;
    }
    if (const auto* array = value.as_array()) {
        node.kind = TomlNode::Kind::array;
        for (const auto& entry : *array) node.children.push_back(convert(entry, source));
        return node;
    }
    if (const auto* text = value.as_string()) {
        node.kind = TomlNode::Kind::text;
        node.text = written_text(text->get(), value.source().begin, source);
        return node;
    }
    node.written = source.between(value.source());
    if (const auto* integer = value.as_integer()) {
        node.kind = TomlNode::Kind::integer;
        node.integer = integer->get();
        node.number = static_cast<double>(integer->get());
    } else if (const auto* number = value.as_floating_point()) {
        node.kind = TomlNode::Kind::number;
        node.number = number->get();
    } else if (const auto* boolean = value.as_boolean()) {
        node.kind = TomlNode::Kind::boolean;
        node.boolean = boolean->get();
    } else {
        node.kind = TomlNode::Kind::date;
    }
    return node;
}

void put_everywhere(TomlNode& node, const SourceLocation& location) {
    node.location = node.key_location = location;
    node.text.location = location;
    node.text.first_character = {};
    for (auto& child : node.children) put_everywhere(child, location);
}

}  // namespace

const TomlNode* TomlNode::child(std::string_view name) const {
    if (!is_table()) return nullptr;
    const auto found = std::find_if(children.begin(), children.end(), [&](const auto& c) { return c.key == name; });
    return found == children.end() ? nullptr : &*found;
}

TomlNode* TomlNode::child(std::string_view name) {
    return const_cast<TomlNode*>(std::as_const(*this).child(name));  // NOLINT: the object itself is not const here
}

const TomlNode* TomlNode::find(std::string_view path) const {
    const TomlNode* node = this;
    while (node != nullptr && !path.empty()) {
        const auto dot = path.find('.');
        node = node->child(path.substr(0, dot));
        path = dot == std::string_view::npos ? std::string_view{} : path.substr(dot + 1);
    }
    return node;
}

const SourceLocation* TomlNode::location_of(std::string_view path) const {
    const TomlNode* node = find(path);
    return node == nullptr ? nullptr : &node->location;
}

std::string TomlNode::shown() const {
    switch (kind) {
        case Kind::table:
            return "a table";
        case Kind::array:
            return "a list";
        case Kind::text:
            return toml_quoted(text.text);
        case Kind::integer:
        case Kind::number:
        case Kind::boolean:
        case Kind::date:
            return written;
    }
    unlisted_value(kind);
}

TomlNode parse_toml(std::string_view text, const std::string& file) {
    check_key_depth(text, file);
    const Source source(text, file);
    try {
        return convert(toml::parse(text), source);
    } catch (const toml::parse_error& error) {
        const std::string_view fault = error.description();
        const bool repeated = fault.find("redefine") != std::string_view::npos;
        throw InputError(
            source.location(error.source().begin), "this is not valid TOML: " + std::string(fault),
            repeated ? "write each key and table once; only [[part]] and [[measure]], in double brackets, "
                       "may occur several times"
                     : "correct the line; quantities and names must be in quotes, such as spacing = \"0.1 mm\"");
    }
}

TomlNode parse_toml_value(std::string_view text, const SourceLocation& location) {
    std::optional<TomlNode> value;
    try {
        const std::string document = "value = " + std::string(text);
        check_key_depth(document, location.file);
        const Source source(document, location.file);
        TomlNode root = convert(toml::parse(document), source);
        if (root.children.size() == 1 && root.children[0].key == "value") value = std::move(root.children[0]);
    } catch (const toml::parse_error&) {
        value.reset();  // not a TOML value: text
    }
    if (!value) {
        value.emplace();
        value->kind = TomlNode::Kind::text;
        value->text.text = text;
    }
    value->key.clear();
    put_everywhere(*value, location);
    return std::move(*value);
}

std::string toml_text(const TomlNode& node) {
    std::string items;
    for (const TomlNode& child : node.children) {
        items += items.empty() ? "" : ", ";
        if (node.is_table()) items += toml_quoted(child.key) + " = ";
        items += toml_text(child);
    }
    switch (node.kind) {
        case TomlNode::Kind::table:
            return "{" + items + "}";
        case TomlNode::Kind::array:
            return "[" + items + "]";
        case TomlNode::Kind::text:
            return toml_quoted(node.text.text);
        case TomlNode::Kind::integer:
        case TomlNode::Kind::number:
        case TomlNode::Kind::boolean:
        case TomlNode::Kind::date:
            return node.written;
    }
    unlisted_value(node.kind);
}

std::string toml_quoted(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            quoted += '\\';
            quoted += c;
        } else if (c == '\n') {
            quoted += "\\n";
        } else if (c == '\t') {
            quoted += "\\t";
        } else if (byte < 0x20 || byte == 0x7F) {
            constexpr std::string_view hex = "0123456789ABCDEF";
            quoted += "\\u00";
            quoted += hex[byte / 16];
            quoted += hex[byte % 16];
        } else {
            quoted += c;
        }
    }
    return quoted + "\"";
}

}  // namespace dmp::scene
