// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// No slip at the surfaces of elastic solids: flux between elastic layers and past flexible sheets of any thickness.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::elastic_walls_tests {
namespace {

constexpr double gradient = 24, height = 0.01, viscosity = 0.02;

/// Plane Poiseuille flow, 1 m deep [m^3/s].
double poiseuille(double width) { return gradient * std::pow(width, 3) / (12 * viscosity); }

/// The flux at the end of a run over the exact one, less 1.
double error_of(const RunSummary& run, double exact) { return run.measures.rows.back().at(0) / exact - 1; }

void between_layers(const std::string& setting, std::vector<std::string> overrides, double bound) {
    const RunSummary run = run_case("verification/elastic_walls", overrides, 5);
    Record record("elastic_walls", setting, run);
    record.percent("flux", error_of(run, poiseuille(height)), bound);
}

TEST(ElasticWalls, HaveNoSlipAtTheirSurface) {
    const std::string springs = "part.layers.model=springs", implicit = "numerics.viscosity_stepping=implicit";
    between_layers("cells, 10 across", {"particles.spacing=1 mm"}, 0.011);
    between_layers("cells, 20 across", {}, 0.003);
    between_layers("cells, 20 across, implicit viscosity", {implicit}, 0.003);
    between_layers("springs, 10 across", {springs, "particles.spacing=1 mm"}, 0.011);
    between_layers("springs, 20 across", {springs}, 0.003);
}

/// A sheet of thickness h with the same bending stiffness.
void past_sheet(const std::string& setting, double thickness, double bound) {
    const std::string modulus = std::to_string(1e5 * std::pow(0.5e-3 / thickness, 3)) + " Pa";
    const RunSummary run = run_case(
        "verification/elastic_walls/sheet.toml",
        {"part.sheet.thickness=" + std::to_string(1e3 * thickness) + " mm", "part.sheet.youngs_modulus=" + modulus}, 5);
    Record record("elastic_walls", setting, run);
    record.percent("flux", error_of(run, 2 * poiseuille((height - thickness) / 2)), bound);
}

TEST(FlexibleSheets, HaveNoSlipWhereTheirMaterialEnds) {
    past_sheet("sheet of a tenth of a spacing", 0.05e-3, 0.005);
    past_sheet("sheet of half a spacing", 0.25e-3, 0.005);
    past_sheet("sheet of one spacing", 0.5e-3, 0.016);
    past_sheet("sheet of two spacings", 1e-3, 0.015);
}

}  // namespace
}  // namespace dmp::tests::elastic_walls_tests
