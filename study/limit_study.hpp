// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/limit_dials.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// A rung of a dial.
struct DialPlace {
    std::size_t dial = 0;
    std::size_t rung = 0;  ///< from 1
};

/// The runs that the limits of a scene may take: its own settings, those repeated with another spacing and step where
/// it has them, and all rungs of its dials, one dial after the other.
class LimitStudy {
  public:
    LimitStudy(std::vector<Dial> dials, std::map<std::string, std::string> repeat);

    static constexpr std::size_t own = 0;  ///< the run with the scene's own settings

    [[nodiscard]] const std::vector<Dial>& dials() const { return dials_; }
    [[nodiscard]] std::optional<std::size_t> repeat() const;
    [[nodiscard]] std::size_t size() const { return places_.size() + first_rung(); }
    /// None of the scene's own settings and their repeat.
    [[nodiscard]] std::optional<DialPlace> place_of(std::size_t run) const;
    /// `rung`: from 1; 0: the run with the scene's own settings.
    [[nodiscard]] std::size_t run_of(std::size_t dial, std::size_t rung) const;
    /// Expected, as multiples of that of the first one.
    [[nodiscard]] std::vector<double> costs() const;
    /// What makes a run of the scene this rung, as --set takes it.
    [[nodiscard]] std::vector<std::string> overrides(const DialPlace& place) const;

    /// The study's file, in `folder`. `scene`: its path; `overrides`: what all runs have in common, as --set takes it.
    [[nodiscard]] std::string text(const std::string& scene, const std::string& title,
                                   const std::vector<std::string>& overrides,
                                   const std::filesystem::path& folder) const;

  private:
    [[nodiscard]] std::size_t first_rung() const { return repeat_.empty() ? 1 : 2; }

    std::vector<Dial> dials_;
    std::map<std::string, std::string> repeat_;
    std::vector<DialPlace> places_;
    std::vector<std::size_t> begins_;  ///< of each dial, the run of its first rung
};

}  // namespace dmp::study
