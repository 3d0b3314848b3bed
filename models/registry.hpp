// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace dmp::models {

/// The description of a law for scenes, messages and the reference. Each law of a registry has one, called `facts`.
struct LawFacts {
    std::string_view key;       ///< its name in a scene
    std::string_view citation;  ///< equation and paper
    std::string_view meaning;   ///< one clause for the reference page
};

/// The laws from which a scene chooses one, each a type. To add a law, write a file with the law and its facts, and add
/// its name to the list (models/dem/contact_law_list.hpp, models/sph/fluid_law_list.hpp) and its file to the header
/// that has all of them. Names, schema, dispatch, `dmp explain` and the reference page follow; a law that lacks
/// something they need does not compile. A list has the laws' names only: who stores a choice, as scenes do, is not
/// compiled again when a law changes.
template <class... Laws>
struct Registry {
    static constexpr std::size_t size = sizeof...(Laws);
    /// In the laws' order; compiled in models/law_facts.cpp.
    static const std::array<LawFacts, size>& facts();

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
    [[nodiscard]] const LawFacts& facts() const { return Laws::facts().at(number_); }
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

}  // namespace dmp::models
