// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/particle_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace dmp::bench {

std::string particle_text(const Channel& channel, const ParticleSet& set) {
    const auto axes = [](const Vec& v) { return std::array<double, 3>{v[0], v[1], v[2]}; };
    const nlohmann::ordered_json head{{"particles", set.size()},
                                      {"dimension", set.dimension},
                                      {"spacing", set.spacing},
                                      {"low", axes(set.box.low)},
                                      {"high", axes(set.box.high)},
                                      {"periodic", set.periodic},
                                      {"particle_mass", set.mass.front()},
                                      {"density", Liquid::density},
                                      {"viscosity", Liquid::viscosity},
                                      {"sound_speed", Liquid::sound_speed},
                                      {"speed", Liquid::speed},
                                      {"acceleration", Liquid::acceleration},
                                      {"kernel", to_string(channel.kernel)},
                                      {"support", channel.support * set.spacing}};
    std::string text = head.dump() + "\n";
    for (std::size_t i = 0; i < set.size(); ++i) {
        const Vec& x = set.position[i];
        text += fmt::format("{} {} {} {}\n", set.fixed[i], x[0], x[1], x[2]);
    }
    return text;
}

}  // namespace dmp::bench
