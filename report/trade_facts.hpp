// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dmp::report {

/// What a trade has found, and its picture (trade_picture.hpp), in its folder.
inline constexpr const char* trade_file_name = "trade.json";
inline constexpr const char* trade_picture_name = "trade.svg";

/// The errors that a trade's page finds a setting for.
inline constexpr std::array<double, 3> trade_tolerances{0.01, 0.05, 0.1};

/// What a trade has found of its settings, as trade.json has it.
struct TradeFacts {
    struct Setting {
        std::string run;
        std::vector<std::string> set;  ///< what --set takes for it
        double spacing = 0;            ///< of the particles [m]; 0: the scene has none
        std::size_t level = 0;         ///< of `levels`
        bool is_repeat = false, is_reference_given = false;
        std::string failure;  ///< "": it has not failed
        bool has_ended = false;
        double cost = 0;          ///< processor time [s]; NaN: not known
        double error = 0;         ///< relative, not below 0; NaN: not known
        std::string error_is_of;  ///< the column of measures that it is of

        /// Whether it may be advised.
        [[nodiscard]] bool is_candidate() const { return !is_repeat && !is_reference_given; }
    };
    struct Measure {
        std::string name;
        double scatter = 0;  ///< relative; NaN: not known
    };
    std::string scene;                    ///< its path, as given to dmp
    std::string name;                     ///< of the scene
    std::vector<std::string> set_in_all;  ///< what --set takes, of all settings
    double simulated = 0, duration = 0;   ///< of the runs of the trade, and of the scene [s]; NaN: not known
    std::vector<Measure> measures;
    std::vector<std::string> levels;  ///< at one spacing: "draft"; the least accurate one first
    std::vector<Setting> settings;
    std::vector<std::size_t> front;        ///< settings that no other beats in cost and error, cheapest first
    std::optional<std::size_t> reference;  ///< the setting that all are compared with

    [[nodiscard]] const std::string& level_of(const Setting& setting) const { return levels[setting.level]; }
    [[nodiscard]] bool is_on_front(std::size_t setting) const;
    /// [m]; 0: the scene has no spacing. All are shown in the unit that suits it.
    [[nodiscard]] double largest_spacing() const;
    /// The cheapest setting with at most this error.
    [[nodiscard]] std::optional<std::size_t> cheapest_within(double error) const;
    /// The one that may be advised with the smallest error; none where no error is known.
    [[nodiscard]] std::optional<std::size_t> best() const;
};

/// Throws InputError, which names the file and the place, where it cannot be read or is damaged.
[[nodiscard]] TradeFacts read_trade_facts(const std::filesystem::path& file);

/// Two digits, and all before the point where that is short: "0.14", "150".
[[nodiscard]] std::string two_digits(double value);

/// A relative error: "3.2 %"; "not known" for what is no number.
[[nodiscard]] std::string error_text(double error);

}  // namespace dmp::report
