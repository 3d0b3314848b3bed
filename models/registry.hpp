// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "base/enum_names.hpp"

namespace dmp::models {

/// The description of a law for scenes, messages and the reference. Each law of a registry has one, called `facts`.
struct LawFacts {
    std::string_view key;       ///< its name in a scene
    std::string_view citation;  ///< equation and paper
    std::string_view meaning;   ///< one clause for the reference page
};

/// The laws from which a scene chooses one, each a type. To add a law, write a file with the law and its facts, and
/// add a row here. Names, schema, dispatch, `dmp explain` and the reference page follow from the row; a law that
/// lacks something they need does not compile.
template <class... Laws>
struct Registry {
    static constexpr std::size_t size = sizeof...(Laws);
    static constexpr std::array<LawFacts, size> facts{Laws::facts...};

    template <class Law>
    static constexpr bool has = (std::is_same_v<Law, Laws> || ...);

    template <class Law>
    static constexpr std::size_t number_of() {
        static_assert((std::is_same_v<Law, Laws> + ... + 0) == 1, "not a law of this registry, or twice in it");
        std::size_t number = 0;
        (void)((std::is_same_v<Law, Laws> || (++number, false)) || ...);
        return number;
    }

    template <std::size_t number>
    using Law = std::tuple_element_t<number, std::tuple<Laws...>>;
};

/// One law of a registry, as a value. `Choice::of<Law>()` is the choice of that law.
template <class Laws>
class Choice {
  public:
    using Registry = Laws;

    constexpr Choice() = default;  ///< the first law
    /// By its number in the registry.
    constexpr explicit Choice(std::size_t number) : number_(static_cast<std::uint8_t>(number)) {}
    template <class Law>
    static constexpr Choice of() {
        return Choice(Laws::template number_of<Law>());
    }

    template <class Law>
    [[nodiscard]] constexpr bool is() const {
        return number_ == Laws::template number_of<Law>();
    }
    [[nodiscard]] constexpr std::size_t number() const { return number_; }
    [[nodiscard]] constexpr const LawFacts& facts() const { return Laws::facts.at(number_); }
    friend constexpr bool operator==(Choice, Choice) = default;

    /// Returns visit.template operator()<Law>() for the chosen law; visit is compiled for every law.
    template <class Visit>
    constexpr decltype(auto) visit(Visit&& visit) const {
        return visit_from<0>(visit);
    }

    std::uint8_t number_ = 0;  // public, so that a choice can be a template argument

  private:
    template <std::size_t first, class Visit>
    constexpr decltype(auto) visit_from(Visit& visit) const {
        if constexpr (first + 1 < Laws::size)
            if (number_ != first) return visit_from<first + 1>(visit);
        return visit.template operator()<typename Laws::template Law<first>>();
    }
};

/// The law's name in a scene.
template <class Laws>
std::string to_string(Choice<Laws> choice) {
    return std::string(choice.facts().key);
}

/// The names of all laws of a registry, in its order.
template <class Laws>
inline constexpr auto law_names = [] {
    std::array<std::string_view, Laws::size> names;
    for (std::size_t k = 0; k < Laws::size; ++k) names[k] = Laws::facts[k].key;
    return names;
}();

}  // namespace dmp::models

namespace dmp {

/// Choices of laws have names, as enumerations do.
template <class Laws>
inline constexpr auto enum_names<models::Choice<Laws>> = models::law_names<Laws>;

}  // namespace dmp
