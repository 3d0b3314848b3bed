// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/output_folder.hpp"
#include "cli/terminal.hpp"
#include "cli/uses.hpp"
#include "models/dem/escape_model.hpp"
#include "scene/quantity.hpp"

namespace dmp::cli {

namespace {

double number_of(const std::string& option, const std::string& text, const std::string& example) {
    try {
        return Expected(example).read({text, {}, {}}, option);
    } catch (const InputError& error) {
        throw InputError(error.problem(), error.what_to_do());
    }
}

double positive_of(const std::string& option, const std::string& text, const std::string& example) {
    const double value = number_of(option, text, example);
    if (!(value > 0))
        throw InputError(option + ": found \"" + text + "\", expected more than 0",
                         "give for example \"" + example + "\"");
    return value;
}

EscapeModel model_of(const EscapeCommand& command) {
    EscapeModel model;
    model.form = command.printed ? EscapeModel::Form::printed : EscapeModel::Form::corrected;
    model.carrier_radius = positive_of("--carrier-radius", command.carrier_radius, "50 um");
    model.particle_radius = positive_of("--particle-radius", command.particle_radius, "2.5 um");
    model.particle_mass = positive_of("--particle-mass", command.particle_mass, "84.4 pg");
    model.pull_off_force = positive_of("--pull-off-force", command.pull_off_force, "258 nN");
    model.equilibrium_distance = positive_of("--equilibrium-distance", command.equilibrium_distance, "0.4 nm");
    model.cutoff = positive_of("--cutoff", command.cutoff, "1 nm");
    const double carrier = positive_of("--carrier-youngs-modulus", command.carrier_youngs_modulus, "63 GPa");
    const double particle = positive_of("--particle-youngs-modulus", command.particle_youngs_modulus, "2.15 GPa");
    const auto poisson = [](const char* option, double value) {
        if (!(value > -1 && value <= 0.5))
            throw InputError(fmt::format("{}: found {}, expected more than -1 and at most 0.5", option, value),
                             "give Poisson's ratio of the material");
        return value;
    };
    const double carrier_ratio = poisson("--carrier-poisson-ratio", command.carrier_poisson_ratio);
    const double particle_ratio = poisson("--particle-poisson-ratio", command.particle_poisson_ratio);
    model.normal_stiffness = command.thesis_stiffness
                                 ? EscapeModel::thesis_stiffness(particle, particle_ratio)
                                 : EscapeModel::hertz_stiffness(carrier, carrier_ratio, particle, particle_ratio);
    return model;
}

std::string rows(EscapeModel model, const EscapeCommand& command) {
    std::string text;
    for (const double friction : command.friction) {
        if (!(friction > 0))
            throw InputError(fmt::format("--friction: found {}, expected more than 0", friction),
                             "the model has friction in its denominator: give a small one, 0.001");
        model.friction = friction;
        for (const std::string& speed : command.speeds)
            for (const std::string& angle : command.angles) {
                const double v = positive_of("--speed", speed, "5 m/s"),
                             theta = positive_of("--angle", angle, "45 deg");
                if (theta > 0.5 * std::numbers::pi + 1e-12)
                    throw InputError("--angle: found \"" + angle + "\", expected at most 90 deg",
                                     "give the angle between the carrier's path and the wall");
                const auto found = model.escape(v * std::sin(theta));
                const double degrees = 180 / std::numbers::pi;
                text += fmt::format("{:g},{:g},{:g},{:.3f},{:.3f},{:.4f},{:.4f},{:.4f},{:.4f}\n", friction, v,
                                    theta * degrees, found.south_angle * degrees, found.north_latitude * degrees,
                                    found.south, found.north, found.north_zone, found.fraction());
            }
    }
    return text;
}

}  // namespace

int execute(const EscapeCommand& command) {
    const EscapeModel model = model_of(command);
    if (!command.out.empty()) check_output_file(command.out);
    const std::string table =
        "friction,speed [m/s],angle [deg],south_angle [deg],north_latitude "
        "[deg],eta_south,eta_north,eta_north_zone,eta\n" +
        rows(model, command);
    if (command.out.empty()) {
        print(table);
        return exit_done;
    }
    const std::filesystem::path file = command.out;
    write_file(file, table);
    print(
        fmt::format("Escape model of Ariane, Sommerfeld & Alexiadis 2018, {}: {}\n"
                    "  overlap at rest {:.4g} m, work to lift {:.4g} J, first escape at v sin(theta) = {:.4g} m/s\n",
                    command.printed ? "as printed" : "corrected", file.string(), model.rest_overlap(),
                    model.work_to_lift(), model.first_escape()));
    return exit_done;
}

}  // namespace dmp::cli
