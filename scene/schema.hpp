// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <concepts>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "scene/scene.hpp"
#include "scene/toml_node.hpp"
#include "scene/value_types.hpp"

namespace dmp::scene {

/// A default that may depend on the quality level, written as on the command line (texts without quotes).
struct ByQuality {
    std::string draft, standard, fine;

    ByQuality(const char* all) : ByQuality(all, all, all) {}  // NOLINT(google-explicit-constructor): rows read plainly
    ByQuality(const char* at_draft, const char* at_standard, const char* at_fine)
        : draft(at_draft), standard(at_standard), fine(at_fine) {}

    [[nodiscard]] bool differ() const { return draft != standard || fine != standard; }
    [[nodiscard]] const std::string& at(Quality quality) const;
    bool operator==(const ByQuality&) const = default;
};

/// A default that depends on numerics.scheme.
struct ByScheme {
    ByQuality corrected, plain;
};

/// Default of a key: the key is required, or may be left out without a value (not_given), or has a default value, which
/// the resolved scene has or, of keys that are younger than scenes that must keep their hash, leaves out (unwritten).
struct Default {
    enum class Presence { required, not_given, value, unwritten };
    Presence presence = Presence::value;
    ByScheme values{"", ""};

    [[nodiscard]] bool depends_on_quality(FluidScheme scheme) const { return of(scheme).differ(); }
    [[nodiscard]] bool depends_on_scheme() const { return values.corrected != values.plain; }
    [[nodiscard]] const ByQuality& of(FluidScheme scheme) const;
    [[nodiscard]] const std::string& at(Quality quality, FluidScheme scheme) const { return of(scheme).at(quality); }

    Default(Presence how) : presence(how) {}                      // NOLINT(google-explicit-constructor)
    Default(const char* text) : values{text, text} {}             // NOLINT(google-explicit-constructor)
    Default(const ByQuality& levels) : values{levels, levels} {}  // NOLINT(google-explicit-constructor)
    Default(Presence how, const char* text) : presence(how), values{text, text} {}
    Default(ByScheme schemes) : values(std::move(schemes)) {}  // NOLINT(google-explicit-constructor)
};
inline constexpr auto required = Default::Presence::required;
inline constexpr auto not_given = Default::Presence::not_given;
/// A default value that the resolved scene leaves out.
inline Default unwritten(const char* text) { return {Default::Presence::unwritten, text}; }

/// Kinds of parts or measures that have a key; empty: all.
using Kinds = std::vector<std::string>;

/// Description of a key for the user.
struct KeyFacts {
    std::string path;  ///< "particles.spacing"; "part.*.density" for a key of parts
    std::string type;  ///< with unit and range
    Default fallback = required;
    Kinds kinds;
    std::string meaning;

    [[nodiscard]] std::string section() const;  ///< "particles", "part.*", "" for the top of the file
    [[nodiscard]] std::string name() const;     ///< "spacing"
    [[nodiscard]] bool is_for(const std::string& kind) const;
};

namespace detail {

template <class T>
void assign(Value<T>& member, T value, const SourceLocation& location) {
    member = {std::move(value), location};
}
template <class T>
void assign(T& member, T value, const SourceLocation& /*not stored by a plain member*/) {
    member = std::move(value);
}

template <class T>
bool is_nothing(const T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::same_as<T, std::string>) return value == T{};
    // The first value of an enumeration, or the first law of a registry.
    if constexpr (std::is_enum_v<T> || requires { typename T::Registry; }) return value == T{};
    if constexpr (std::same_as<T, Expression>) return value.is_zero();
    if constexpr (std::same_as<T, Vec>) return value == Vec::Zero();
    if constexpr (std::same_as<T, std::array<Expression, 3>>)
        return std::ranges::all_of(value, &Expression::is_zero);
    else if constexpr (requires { value.empty(); })
        return value.empty();
    return false;
}

template <class Member>
bool is_given(const Member& member) {
    if constexpr (requires { member.given(); }) return member.given();
    return false;
}

}  // namespace detail

/// One row of the schema: a key and the member of `Owner` that stores its value.
template <class Owner>
struct Key {
    KeyFacts facts;
    /// Stores the node's value in the owner. The string is the key's path, for messages.
    std::function<void(Owner&, const TomlNode&, const std::string&)> read;
    /// The member as TOML; empty for a key that was left out and has no default.
    std::function<std::string(const Owner&)> write;

    template <class Member, class T>
    Key(std::string name, Member Owner::*member, ValueType<T> type, const Default& fallback, std::string meaning)
        : Key(std::move(name), {}, member, std::move(type), fallback, std::move(meaning)) {}

    template <class Member, class T>
    Key(std::string name, Kinds kinds, Member Owner::*member, ValueType<T> type, const Default& fallback,
        std::string meaning)
        : Key(
              std::move(name), std::move(kinds), member, [type](const Owner&) -> const ValueType<T>& { return type; },
              type.description, fallback, std::move(meaning)) {}

    /// For a type that depends on a key read earlier: `type_for` returns the type for the owner read so far.
    template <class Member, class TypeFor>
    Key(std::string name, Kinds kinds, Member Owner::*member, TypeFor type_for, std::string type,
        const Default& fallback, std::string meaning)
        : facts{std::move(name), std::move(type), fallback, std::move(kinds), std::move(meaning)},
          read([member, type_for](Owner& owner, const TomlNode& node, const std::string& path) {
              detail::assign(owner.*member, type_for(owner).read(node, path), node.location);
          }),
          write([member, type_for, presence = fallback.presence](const Owner& owner) {
              const auto& type_now = type_for(owner);
              using T = std::decay_t<decltype(type_now.read(TomlNode{}, ""))>;
              const T& value = owner.*member;
              const bool is_nothing = presence == not_given && detail::is_nothing(value);
              const bool left_out =
                  !detail::is_given(owner.*member) && (is_nothing || presence == Default::Presence::unwritten);
              return left_out ? std::string{} : type_now.write(value);
          }) {}

    Key(KeyFacts f, decltype(read) r, decltype(write) w)
        : facts(std::move(f)), read(std::move(r)), write(std::move(w)) {}
};

/// All keys of a scene file, in the order of the reference. Reading, defaults, checks of single values, explanations
/// and the resolved scene are derived from it.
struct Schema {
    std::vector<Key<Scene>> scene;
    std::vector<Key<Selection>> select;
    std::vector<Key<Part>> part;
    std::vector<Key<Join>> join;
    std::vector<Key<Species>> species;
    std::vector<Key<ContactPair>> contact_pair;
    std::vector<Key<ForceOnPart>> force;
    std::vector<Key<MovingShape>> moving_shape;
    std::vector<Key<ResidenceRegion>> region;
    std::vector<Key<Measure>> measure;
    std::vector<Key<Reference>> reference;
    std::vector<Key<Solidify>> solidify;
    std::vector<Key<Breaking>> breaking;

    /// All keys in order; a key that differs between kinds of parts or measures appears once for each.
    [[nodiscard]] std::vector<KeyFacts> facts() const;
};

const Schema& schema();

/// Names of the arrays of tables: "part" for [[part]], ...
const std::vector<std::string>& item_lists();

/// Name of an item's kind; "" for items without kinds.
template <class Item>
std::string kind_of(const Item& item) {
    if constexpr (requires { item.kind; }) return to_string(*item.kind);
    return {};
}

/// "part.leaflets.density" and "part.density" -> "part.*.density"; "geometry.parameters.width" ->
/// "geometry.parameters".
std::string key_pattern(const std::string& path);

/// The key of the schema most similar to `pattern` (from key_pattern); empty if none is similar.
std::string nearest_key(const std::string& pattern);

/// "'spacing' in [particles]", "'density' in [[part]]", "'title' at the top".
std::string shown_key(const std::string& pattern);

/// "did you mean ...?", or the keys of the section if none is similar.
std::string advice_for_unknown_key(const std::string& pattern);

/// scene_reference() restricted to the wanted keys.
std::string scene_reference(const std::function<bool(const KeyFacts&)>& wanted);

}  // namespace dmp::scene
