// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/start.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "bench/uses.hpp"
#include "scene/read_scene.hpp"

namespace dmp::bench {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t seed = 1;
constexpr double fewest = 8;  ///< particles along an axis

/// Fluid particles along x, y and z.
std::array<int, 3> counts(const Channel& channel) {
    const auto wanted = static_cast<double>(channel.particles);
    const auto whole = [](double count) { return static_cast<int>(std::lround(std::max(count, fewest))); };
    if (channel.dimension == 2) {
        const int across = whole(std::sqrt(wanted / 4));
        return {whole(wanted / across), across, 1};
    }
    const int across = whole(std::cbrt(wanted));
    const int along = whole(std::sqrt(wanted / across));
    return {along, across, along};
}

/// Walls as thick as the kernel reaches.
int wall_layers(const Channel& channel) { return static_cast<int>(std::ceil(channel.support - 1e-9)); }

/// Species that are spread along the channel.
std::string species_text(int count) {
    std::string text;
    for (int k = 1; k <= count; ++k)
        text += fmt::format(R"toml(
[[species]]
name = "species_{}"
diffusivity = "1e-9 m^2/s"
concentration = "1 kg/m^3 + {} kg/m^3 * sin(x / 1 mm)^2"
)toml",
                            k, k);
    return text;
}

/// A folder for one file, gone when it has been read.
class ShortLivedFolder {
  public:
    ShortLivedFolder() {
        std::string name = (fs::temp_directory_path() / "dmp_bench_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr)
            throw ResourceError("cannot make a folder in " + fs::temp_directory_path().string(),
                                "Make room there, or set TMPDIR to a folder that can be written to.");
        path_ = name;
    }
    ~ShortLivedFolder() {
        std::error_code none;
        fs::remove_all(path_, none);
    }
    ShortLivedFolder(const ShortLivedFolder&) = delete;
    ShortLivedFolder& operator=(const ShortLivedFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

/// The liquid, its walls and its drive; what is open in numerics and contact is added.
std::string scene_text(const Channel& channel, const std::string& numerics) {
    // Half a bell of this width gives the liquid its speed.
    constexpr double push_seconds = 60e-6;
    const double push = Liquid::speed / (push_seconds * 0.5 * std::sqrt(std::numbers::pi));
    const bool solid_space = channel.dimension == 3;
    // Nothing is written or measured in a run of a second or less.
    return fmt::format(
        R"toml(schema = 1
title = "Channel"
dimension = {}

[geometry]
file = "none.geo"

[particles]
spacing = "{} m"

[[part]]
name = "blood"
kind = "fluid"
density = "{} kg/m^3"
viscosity = "{} Pa*s"

[[part]]
name = "wall"
kind = "rigid"
layers = {}

[flow]
acceleration = ["{} m/s^2 + {} m/s^2 * exp(-(t / {} s)^2)", 0{}]
periodic = ["x"{}]
largest_speed = "{} m/s"

[run]
duration = "1 s"

[output]
every = "1 s"
measure_every = "1 s"

[numerics]
scheme = "{}"
sound_speed = "{} m/s"
{}{})toml",
        channel.dimension, Liquid::spacing, Liquid::density, Liquid::viscosity, wall_layers(channel),
        Liquid::acceleration, push, push_seconds, solid_space ? ", 0" : "", solid_space ? ", \"z\"" : "", Liquid::speed,
        to_string(channel.scheme), Liquid::sound_speed, numerics, species_text(channel.species));
}

Scene read_text(const std::string& text, const std::vector<std::string>& overrides) {
    const ShortLivedFolder folder;
    const fs::path file = folder.path() / "channel.toml";
    std::ofstream(file) << text;
    return read_scene(file.string(), overrides);
}

}  // namespace

double noise(std::uint64_t from_seed, std::uint64_t id, std::uint64_t axis) {
    // SplitMix64's mixing of bits (Steele, Lea & Flood 2014).
    std::uint64_t bits = (from_seed * 0x100000001b3U + id) * 4 + axis + 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    bits ^= bits >> 31U;
    return 2 * (static_cast<double>(bits >> 11U) * 0x1p-53) - 1;
}

ParticleSet make_particles(const Channel& channel) {
    const auto [along, across, deep] = counts(channel);
    const int layers = wall_layers(channel);
    constexpr double dx = Liquid::spacing;
    const bool solid_space = channel.dimension == 3;

    ParticleSet set;
    set.dimension = channel.dimension;
    set.spacing = dx;
    set.box = {Vec(0, -layers * dx, 0), Vec(along * dx, (across + layers) * dx, solid_space ? deep * dx : 0)};
    set.periodic = {true, false, solid_space};
    set.parts = {{"blood", PartKind::fluid}, {"wall", PartKind::rigid}};

    const auto count = static_cast<std::size_t>(along) * (across + 2 * layers) * deep;
    const double volume = solid_space ? dx * dx * dx : dx * dx;
    set.volume.assign(count, volume);
    set.mass.assign(count, Liquid::density * volume);
    set.body.assign(count, -1);
    set.seated.assign(count, 0);
    set.position.reserve(count);
    set.part.reserve(count);
    set.fixed.reserve(count);
    set.wall_normal.reserve(count);
    set.wall_distance.reserve(count);
    for (int z = 0; z < deep; ++z)
        for (int y = -layers; y < across + layers; ++y)
            for (int x = 0; x < along; ++x) {
                const bool below = y < 0, above = y >= across, wall = below || above;
                Vec position(x + 0.5, y + 0.5, solid_space ? z + 0.5 : 0);
                if (channel.disordered && !wall)
                    for (int axis = 0; axis < channel.dimension; ++axis)
                        position[axis] += largest_displacement * noise(seed, set.position.size(), axis);
                set.position.emplace_back(dx * position);
                set.part.push_back(wall ? 1 : 0);
                set.fixed.push_back(wall ? 1 : 0);
                set.wall_normal.emplace_back(0, below ? 1 : above ? -1 : 0, 0);
                set.wall_distance.push_back(wall ? dx * (below ? -y - 0.5 : y - across + 0.5) : 0);
            }
    return set;
}

void use_defaults_of_scenes(Channel& channel, FluidScheme scheme) {
    channel.scheme = scheme;
    const Scene scene = read_text(scene_text(channel, ""), {});
    channel.kernel = *scene.numerics.kernel;
    channel.support = *scene.numerics.support;
    channel.walls = *scene.numerics.walls;
    channel.density_diffusion = *scene.numerics.density_diffusion;
    channel.shifting = *scene.numerics.shifting;
    channel.contact_range = *scene.contact.range;
}

std::string scene_text(const Channel& channel) {
    return scene_text(channel, fmt::format(R"toml(kernel = "{}"
support = {}
walls = "{}"
density_diffusion = {}
shifting = {}
viscosity_stepping = "{}"

[contact]
range = {}
)toml",
                                           to_string(channel.kernel), channel.support, to_string(channel.walls),
                                           channel.density_diffusion, channel.shifting,
                                           to_string(channel.implicit_viscosity ? ViscosityStepping::implicitly
                                                                                : ViscosityStepping::explicitly),
                                           channel.contact_range));
}

Scene make_scene(const Channel& channel) {
    try {
        return read_text(scene_text(channel), channel.overrides);
    } catch (const InputError& error) {  // its place is in a file that is gone
        throw InputError("dmp does not take this start: " + error.problem(), error.what_to_do());
    }
}

}  // namespace dmp::bench
