// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace dmp::postproc {

struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0;
    bool operator==(const Colour&) const = default;
};

namespace colours {
inline constexpr Colour white{255, 255, 255};
inline constexpr Colour ink{34, 34, 40};       ///< text
inline constexpr Colour frame{120, 120, 128};  ///< axes and outlines
inline constexpr Colour grid{226, 226, 230};
inline constexpr Colour wall{168, 170, 174};
inline constexpr Colour body{92, 96, 108};       ///< rigid bodies, to distinguish them from walls
inline constexpr Colour solid{196, 18, 48};      ///< stands out on the sequential map
inline constexpr Colour dark_solid{40, 12, 36};  ///< stands out on the diverging map
inline constexpr Colour plain_fluid{70, 125, 190};
inline constexpr Colour not_a_number{255, 0, 255};
}  // namespace colours

/// Colours for the values from low to high. Values out of this range get the colour of the nearer end, NaN magenta.
class ColourMap {
  public:
    /// viridis (van der Walt and Smith, 2015): perceptually uniform.
    static ColourMap sequential(double low, double high);
    /// Cool to warm (Moreland, 2009), centred at `middle`, with the same span on both sides: |value - middle| <=
    /// span.
    static ColourMap diverging(double middle, double span);

    [[nodiscard]] Colour operator()(double value) const;
    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }

  private:
    ColourMap(double low, double high, std::vector<Colour> anchors);

    double low_, high_;
    std::vector<Colour> anchors_;  ///< evenly spaced from low to high
};

}  // namespace dmp::postproc
