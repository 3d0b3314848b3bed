// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/first_guess.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "cli/uses.hpp"
#include "scene/toml_node.hpp"

namespace dmp::cli {

namespace {

/// The first one where no name fits.
constexpr std::array<Liquid, 3> liquids{
    {{"water", "water", 1000, 1e-3}, {"blood", "blood, Newtonian", 1060, 3.5e-3}, {"air", "air", 1.2, 1.8e-5}}};

std::string in_small_letters(std::string name) {
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name;
}

/// As a user writes it: "1 mm" for a thousandth of a metre.
std::string unit_text(double metres) {
    for (const auto& [name, length] : {std::pair{"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}})
        if (metres == length) return fmt::format("1 {}", name);
    return fmt::format("{:.17g} m", metres);
}

}  // namespace

const Liquid& liquid_named(const std::string& name) {
    const std::string lower = in_small_letters(name);
    const auto* found = std::ranges::find_if(
        liquids, [&](const Liquid& liquid) { return lower.find(liquid.name) != std::string::npos; });
    return found == liquids.end() ? liquids.front() : *found;
}

bool sounds_like_a_fluid(const std::string& name) {
    const std::string lower = in_small_letters(name);
    constexpr std::array<const char*, 9> words{"fluid",  "blood", "water", "lumen",  "liquid",
                                               "plasma", "mucus", "air",   "channel"};
    return std::ranges::any_of(words, [&](const char* word) { return lower.find(word) != std::string::npos; });
}

std::string in_millimetres(double length, double size) {
    return std::abs(length) < 1e-9 * size ? "0 mm" : fmt::format("{:.9g} mm", 1e3 * length);
}

double rounded(double value) {
    const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
    return std::max(1.0, std::round(value / unit)) * unit;
}

std::string name_that_is_free(std::string name, const std::vector<std::string>& taken) {
    while (std::ranges::find(taken, name) != taken.end()) name += "_end";
    return name;
}

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "\"" : ", \"") + name + "\"";
    return list;
}

std::string written_selection(const FaceSelection& selection, double size, int dimension) {
    std::string text = fmt::format("\n[[select]]\nname = \"{}\"\nof = \"{}\"\n", selection.name, selection.of);
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (const auto& position = selection.in_plane.at(axis))
            text += fmt::format("{} = \"{}\"\n", "xyz"[axis], in_millimetres(*position, size));
    const auto corner = [&](const Vec& position) {
        std::vector<std::string> list;
        list.reserve(3);
        for (int axis = 0; axis < dimension; ++axis) list.push_back(in_millimetres(position[axis], size));
        return listed(list);
    };
    if (const auto& box = selection.in_box)
        text += fmt::format("from = [{}]\nto = [{}]\n", corner(box->low), corner(box->high));
    if (!selection.except.empty()) text += fmt::format("except = [{}]\n", listed(selection.except));
    return text;
}

std::string written_fluid(const std::string& name, const Liquid& liquid) {
    return fmt::format(
        "\n[[part]]\nname = \"{}\"\nkind = \"fluid\"\ndensity = \"{:g} kg/m^3\"\nviscosity = \"{:g} mPa*s\"\n", name,
        liquid.density, 1e3 * liquid.viscosity);
}

std::string written_wall(const std::string& name) {
    return fmt::format("\n[[part]]\nname = \"{}\"\nkind = \"rigid\"\n", name);
}

std::string written_left_out(const std::string& name, const std::string& why) {
    return written_wall(name) + "enabled = false  # " + why + "\n";
}

std::string SceneDraft::text() const {
    const std::string file = std::filesystem::path(geometry.file).filename().string();
    std::string text = "# A first scene, made by 'dmp new' of " + file + ". It assumes:\n";
    for (const std::string& assumption : assumptions) text += "# - " + assumption + "\n";
    text += fmt::format("schema = 1\ntitle = \"First scene of {}\"\ndimension = {}\n\n[geometry]\nfile = {}\n", fluid,
                        geometry.dimension, toml_quoted(file));
    if (unit_given) text += fmt::format("unit = \"{}\"\n", unit_text(geometry.unit));
    text += fmt::format("\n[particles]\nspacing = \"{}\"\n", in_millimetres(spacing, 0)) + parts + flow;
    return text + fmt::format(
                      "\n[run]\nduration = \"{:.3g} s\"\n\n[output]\nevery = \"{:.3g} s\"\n"
                      "fields = [\"velocity\", \"pressure\"]\n\n"
                      "[[measure]]\nname = \"largest_speed\"\nkind = \"largest_speed\"\n",
                      duration, duration / 20);
}

}  // namespace dmp::cli
