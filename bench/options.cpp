// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/options.hpp"

#include <map>
#include <optional>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"

namespace dmp::bench {

namespace {

struct Case {
    int dimension;
    bool disordered;
};
const std::map<std::string, Case> cases{
    {"channel2d", {2, false}}, {"channel3d", {3, false}}, {"disordered2d", {2, true}}, {"disordered3d", {3, true}}};

template <class Named>
std::vector<std::string> names_of(const std::map<std::string, Named>& named) {
    std::vector<std::string> names;
    names.reserve(named.size());
    for (const auto& entry : named) names.push_back(entry.first);
    return names;
}

/// "Did you mean 'x'?", or all there is.
std::string hint(const std::string& given, const std::vector<std::string>& known) {
    const std::string nearest = nearest_name(given, known);
    return nearest.empty() ? "Choose one of " + quoted_list(known) + "." : "Did you mean '" + nearest + "'?";
}

template <class Named>
Named chosen(const std::string& option, const std::string& given, const std::map<std::string, Named>& named) {
    const auto found = named.find(given);
    if (found == named.end()) throw InputError(option + " does not know '" + given + "'", hint(given, names_of(named)));
    return found->second;
}

class Parser {
  public:
    explicit Parser(const std::string& program) : app_("", program) {
        app_.description(
            "Measures how fast dmp's engine steps through a start made in code, beside the plain half-list loop as a\n"
            "yardstick, in turns in the same run.");
        app_.set_help_flag("-h,--help", "Print this help and end");
        app_.get_formatter()->column_width(30);
        app_.add_option("--case", options_.name, "channel2d, channel3d, disordered2d or disordered3d")
            ->type_name("NAME")
            ->required();
        number("--particles", particles_, "Fluid particles, about; default: 100000");
        app_.add_option("--support", support_, "Radius of the kernel's support in spacings, 2 to 6; default: 2.5")
            ->type_name("X")
            ->check(CLI::Range(2.0, 6.0).description(""));
        app_.add_option("--kernel", kernel_, "lucy or wendland_c2; default: wendland_c2")->type_name("NAME");
        app_.add_option("--walls", walls_, "plain or extrapolated; default: plain")->type_name("NAME");
        app_.add_option(
                "--defaults", defaults_,
                "What scenes have by default with numerics.scheme = corrected or plain; default: the plain scheme "
                "without shifting, diffusion, contact and extrapolated walls")
            ->type_name("SCHEME");
        app_.add_flag("--implicit-viscosity", options_.channel.implicit_viscosity,
                      "Solve for the viscous forces instead of taking them from the last velocities");
        app_.add_option("--vector-unit", vector_unit_, "The engine's: avx2 or avx512; default: the widest")
            ->type_name("NAME");
        app_.add_option("--set", options_.channel.overrides, "A key of the scene: --set numerics.shifting=4")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        number("--species", options_.channel.species, "Species that diffuse in the liquid; default: none");
        number("--threads", options_.threads, "The engine's threads; default: 1");
        number("--steps", options_.steps, "Steps, and sweeps of the yardstick, in one repeat; default: 100");
        number("--repeat", options_.repeat, "Repeats, of which the median counts; default: 5");
        app_.add_flag("--json", options_.json, "Print JSON instead of text");
        app_.add_flag("--yardstick-only", options_.yardstick_only, "Leave the engine out");
        app_.add_option("--particles-to", options_.particles_to, "Write the particles into a file, measure nothing")
            ->type_name("FILE");
    }

    Options read(std::span<const char* const> argv) {
        const std::string ask_help = "'" + app_.get_name() + " --help' shows how it goes.";
        try {
            app_.parse(static_cast<int>(argv.size()), argv.data());
        } catch (const CLI::CallForHelp&) {
            options_.help = app_.help();
            return options_;
        } catch (const CLI::ExtrasError&) {
            const std::string given = app_.remaining().front();
            throw InputError("'" + app_.get_name() + "' has no option '" + given + "'",
                             hint(given, known_options()) + " " + ask_help);
        } catch (const CLI::ParseError& error) {
            throw InputError(error.what(), ask_help);
        }
        const Case start = chosen("--case", options_.name, cases);
        Channel& channel = options_.channel;
        if (defaults_) {
            const std::map<std::string, FluidScheme> schemes{{"corrected", FluidScheme::corrected},
                                                             {"plain", FluidScheme::plain}};
            use_defaults_of_scenes(channel, chosen("--defaults", *defaults_, schemes));
        }
        channel.dimension = start.dimension;
        channel.disordered = start.disordered;
        if (particles_) channel.particles = static_cast<std::size_t>(*particles_);
        if (support_) channel.support = *support_;
        if (kernel_) {
            const std::map<std::string, KernelKind> kernels{{"lucy", KernelKind::lucy},
                                                            {"wendland_c2", KernelKind::wendland_c2}};
            channel.kernel = chosen("--kernel", *kernel_, kernels);
        }
        if (vector_unit_) {
            std::map<std::string, VectorUnit> units;
            for (const VectorUnit unit : available_vector_units()) units.emplace(to_string(unit), unit);
            options_.vector_unit = chosen("--vector-unit", *vector_unit_, units);
        }
        if (walls_) {
            const std::map<std::string, WallModel> models{{"plain", WallModel::plain},
                                                          {"extrapolated", WallModel::extrapolated}};
            channel.walls = chosen("--walls", *walls_, models);
        }
        return options_;
    }

  private:
    template <class Number>
    void number(const std::string& name, Number& value, const std::string& help) {
        constexpr int most = 100'000'000;
        app_.add_option(name, value, help)->type_name("N")->check(CLI::Range(1, most).description(""));
    }

    [[nodiscard]] std::vector<std::string> known_options() const {
        std::vector<std::string> known;
        for (const CLI::Option* option : app_.get_options())
            for (const auto& name : option->get_lnames()) known.push_back("--" + name);
        return known;
    }

    Options options_;
    std::optional<int> particles_;
    std::optional<double> support_;
    std::optional<std::string> defaults_, kernel_, walls_, vector_unit_;
    CLI::App app_;
};

}  // namespace

Options read_options(std::span<const char* const> argv) {
    const std::string program = argv.empty() ? "dmp_bench" : argv.front();
    return Parser(program.substr(program.rfind('/') + 1)).read(argv);
}

}  // namespace dmp::bench
