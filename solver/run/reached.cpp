// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/reached.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "solver/run/sound_speed.hpp"

namespace dmp::solver {

namespace {

constexpr double most_of_density = 0.05, least_mach = 0.15, beyond_mach = 1.5, too_slow = 0.1;

std::string text_of(const char* format, double value) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}
std::string with_unit(double value, const std::string& unit) { return text_of("%.3g ", value) + unit; }
std::string percent(double share) { return text_of("%+.1f %%", 100 * share); }

/// "give flow.largest_speed = "0.9 m/s"": the key that leads to this speed of sound, and its value.
std::string give(const std::string& key, double value, const std::string& unit) {
    return "give " + key + " = \"" + with_unit(value, unit) + "\" or more";
}

}  // namespace

Reached::Reached(const Scene& scene, const SoundSpeed& sound) : scene_(scene), sound_(sound) {}

bool Reached::compressed() const {
    // A Mach number above 0.22, as of draft, is the choice of larger changes.
    const double chosen = is_by_hand() ? 0 : *scene_.numerics.mach_number * *scene_.numerics.mach_number;
    const double most = std::max(most_of_density, chosen);
    return density_high_ > 0 && (density_low_ < 1 - most || density_high_ > 1 + most);
}
bool Reached::too_fast() const {
    return speed_ > std::max(least_mach, beyond_mach * *scene_.numerics.mach_number) * sound_.value;
}
bool Reached::slow() const {
    return sound_.origin == SoundSpeed::Origin::largest_speed && speed_ > 0 &&
           speed_ < too_slow * scene_.flow.largest_speed;
}

bool Reached::is_by_hand() const { return sound_.origin == SoundSpeed::Origin::scene; }

Warning Reached::too_low(const std::string& reason, const std::string& what_to_do) const {
    return {"numerics.sound_speed", scene_.numerics.sound_speed.location,
            "is too low, at " + with_unit(sound_.value, "m/s") + ": " + reason, what_to_do};
}

Warning Reached::of_density() const {
    const double largest = std::max(1 - density_low_, density_high_ - 1);
    const double pressure = lightest_density(scene_) * sound_.value * sound_.value * largest;
    return too_low("the density went from " + percent(density_low_ - 1) + " to " + percent(density_high_ - 1) +
                       " of that at rest, under pressures of up to " + with_unit(pressure, "Pa"),
                   is_by_hand() ? give("numerics.sound_speed",
                                       sound_.value * std::sqrt(largest) / *scene_.numerics.mach_number, "m/s")
                                : give("flow.largest_pressure", pressure, "Pa"));
}

Warning Reached::of_mach() const {
    const double mach = speed_ / sound_.value;
    return too_low("the fluid moved at up to " + with_unit(speed_, "m/s") + ", Mach " + text_of("%.2g", mach) +
                       ": pressures of rho u^2 change its density by " + text_of("%.2g %%", 100 * mach * mach) +
                       " (so far it changed by " +
                       text_of("%.2g %%", 100 * std::max(1 - density_low_, density_high_ - 1)) + ")",
                   is_by_hand() ? give("numerics.sound_speed", speed_ / *scene_.numerics.mach_number, "m/s")
                                : give("flow.largest_speed", speed_, "m/s"));
}

Warning Reached::of_slow_flow() const {
    const double planned = scene_.flow.largest_speed;
    return {"flow.largest_speed", scene_.flow.largest_speed.location,
            "is " + with_unit(planned, "m/s") + ", but the fluid moved at up to " + with_unit(speed_, "m/s") + ", " +
                text_of("%.2g %%", 100 * speed_ / planned) + " of it: the speed of sound is higher than it need be",
            "give what was reached; steps limited by sound are then longer in the same proportion"};
}

std::vector<Warning> Reached::add(const FluidExtremes& extremes) {
    const bool was_compressed = compressed(), was_too_fast = too_fast();
    speed_ = std::max(speed_, extremes.largest_speed);
    density_low_ = std::min(density_low_, extremes.density_low);
    density_high_ = std::max(density_high_, extremes.density_high);
    std::vector<Warning> warnings;
    if (compressed() && !was_compressed) warnings.push_back(of_density());
    if (too_fast() && !was_too_fast) warnings.push_back(of_mach());
    return warnings;
}

std::vector<Warning> Reached::warnings(bool complete) const {
    std::vector<Warning> warnings;
    if (compressed()) warnings.push_back(of_density());
    if (too_fast()) warnings.push_back(of_mach());
    if (complete && slow()) warnings.push_back(of_slow_flow());
    return warnings;
}

void Reached::archive(Archive& file) {
    file("reached/speed", speed_);
    file("reached/density_low", density_low_);
    file("reached/density_high", density_high_);
}

}  // namespace dmp::solver
