// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "mesher/mesh.hpp"

namespace dmp::mesher {

namespace {

using Json = nlohmann::ordered_json;

Json position(const Vec& point) { return {point[0], point[1], point[2]}; }

Json json_of(const MeshReport::KernelSums& sums) {
    return {{"particles", sums.particles}, {"mean", sums.mean}, {"spread", sums.spread}};
}

Json json_of(const MeshReport::PartLine& line) {
    Json json{{"name", line.name},
              {"kind", line.kind},
              {"particles", line.particles},
              {"drawn", line.target},
              {"filled", line.reached},
              {"unit", line.unit},
              {"volume_error", line.volume_error()},
              {"nearest_in_spacings", line.nearest}};
    if (line.kernel_sum_mean > 0) {
        json["kernel_sum"] = json_of({line.particles, line.kernel_sum_mean, line.kernel_sum_spread});
        json["kernel_sum_inside"] = json_of(line.inside);
        json["kernel_sum_near_walls"] = json_of(line.near_walls);
    }
    Json bars = Json::array();
    for (std::size_t bar = 0; bar < line.nearest_counts.size(); ++bar)
        if (line.nearest_counts[bar] > 0)
            bars.push_back({{"spacings", static_cast<double>(bar) * MeshReport::nearest_bar},
                            {"particles", line.nearest_counts[bar]}});
    json["nearest_histogram"] = {{"bar_width_in_spacings", MeshReport::nearest_bar}, {"bars", bars}};
    return json;
}

Json json_of(const MeshReport::Deviation& deviation) {
    return {{"places", deviation.positions},
            {"mean", deviation.mean},
            {"rms", deviation.rms},
            {"largest", deviation.largest},
            {"where_m", position(deviation.where)}};
}

Json json_of(const MeshReport::SurfaceLine& line) {
    return {{"part", line.part},
            {"unit", "spacings"},
            {"from_drawing", json_of(line.from_geometry)},
            {"from_particles", json_of(line.from_particles)},
            {"farthest", line.farthest}};
}

Json json_of(const MeshReport::LayerLine& line) {
    return {{"part", line.part},
            {"asked", line.asked},
            {"fewest", line.fewest},
            {"mean", line.mean},
            {"where_m", position(line.where)}};
}

Json json_of(const MeshReport::SpringLine& line) {
    Json json{{"part", line.part},
              {"bodies", line.bodies},
              {"bonds", line.bonds},
              {"hinges", line.hinges},
              {"dihedrals", line.dihedrals},
              {"anchored", line.anchored},
              {"nodes_by_number_of_bonds", line.valence},
              {"pieces", line.pieces},
              {"particle_mass_kg", line.particle_mass}};
    if (line.counted > 0) json["nodes_over_drawn_volume"] = line.counted;
    if (line.cells) {
        const auto& [constants, stiffened] = *line.cells;
        json.update({{"form", "solid"},
                     {"edge_stiffness_N_per_m", stiffened * constants.edge_stiffness},
                     {"diagonal_stiffness_N_per_m", stiffened * constants.diagonal_stiffness},
                     {"hinge_stiffness_J", stiffened * constants.hinge_stiffness},
                     {"youngs_modulus_Pa", constants.youngs_modulus()},
                     {"poisson_ratio", constants.poisson_ratio()},
                     {"stiffened", stiffened}});
    } else if (line.elements) {
        const MeshReport::SpringLine::Elements& of = *line.elements;
        json.update({{"form", "cells"},
                     {"cells", of.count},
                     {"cell_nodes", of.nodes},
                     {"cut", of.cut},
                     {"volume_over_drawn", of.volume / of.drawn},
                     {"youngs_modulus_Pa", of.youngs_modulus},
                     {"poisson_ratio", of.poisson_ratio},
                     {"law", of.law}});
        if (line.bar) {
            Json bending;
            for (const auto& [value, over_drawn] : line.bar->bending)
                bending.push_back({{"stiffness_N_m2", value}, {"over_drawn", over_drawn}});
            json["bar"] = {{"length_m", line.bar->length},
                           {"axial_stiffness_N", line.bar->axial.value},
                           {"axial_over_drawn", line.bar->axial.over_drawn},
                           {"bending", bending}};
        }
    } else if (line.network) {
        json.update({{"form", "network"},
                     {"softest_bond_N_per_m", line.network->softest},
                     {"stiffest_bond_N_per_m", line.network->stiffest},
                     {"anisotropy", line.network->anisotropy},
                     {"youngs_modulus_Pa", line.network->youngs_modulus},
                     {"poisson_ratio", NetworkConstants::poisson_ratio}});
    } else if (line.shell) {
        const auto& [constants, asked] = *line.shell;
        json.update({{"form", "shell"},
                     {"bond_stiffness_N_per_m", constants.bond_stiffness},
                     {"dihedral_stiffness_J", constants.dihedral_stiffness},
                     {"bending_stiffness_N_m", constants.bending_stiffness()},
                     {"membrane_stiffness_N_per_m", constants.membrane_stiffness()},
                     {"membrane_stiffness_asked_N_per_m", asked},
                     {"shear_stiffness_N_per_m", constants.shear_stiffness()}});
    } else {
        json.update({{"form", "strip"},
                     {"bond_stiffness_N_per_m", line.bond_stiffness},
                     {"hinge_stiffness_J", line.hinge_stiffness},
                     {"cross_stiffness_N_per_m", line.cross_stiffness},
                     {"bending_stiffness_N_m2", line.bending_stiffness},
                     {"axial_stiffness_N", line.axial_stiffness},
                     {"axial_stiffness_asked_N", line.axial_stiffness_asked},
                     {"shear_stiffness_N", line.shear_stiffness}});
    }
    return json;
}

Json json_of(const MeshReport::JoinLine& line) {
    return {{"name", line.name},
            {"parts", line.parts},
            {"bonds", line.bonds},
            {"left_out_across_gaps", line.across_gaps},
            {"stiffness_N_per_m", line.stiffness},
            {"shortest_m", line.shortest},
            {"longest_m", line.longest}};
}

Json json_of(const MeshReport::SpheresLine& line) {
    return {{"part", line.part},
            {"spheres", line.spheres},
            {"smallest_radius_m", line.smallest},
            {"largest_radius_m", line.largest},
            {"mass_kg", line.mass},
            {"around", line.around},
            {"coverage", line.coverage},
            {"volume_fraction", line.volume_fraction}};
}

template <class Lines>
Json list(const Lines& lines) {
    Json json = Json::array();
    for (const auto& line : lines) json.push_back(json_of(line));
    return json;
}

}  // namespace

std::string MeshReport::json() const {
    Json json{{"dimension", dimension}, {"parts", list(parts)}};
    if (!surfaces.empty()) json["surfaces"] = list(surfaces);
    if (!layers.empty()) json["layers"] = list(layers);
    if (leaks)
        json["leak_test"] = {{"tight", leaks->particles == 0},
                             {"flooded_cells", leaks->cells},
                             {"fluid_particles_reached", leaks->particles},
                             {"where_m", position(leaks->where)}};
    if (at_rest)
        json["at_rest"] = {{"holds", at_rest->holds()},
                           {"steps", at_rest->steps},
                           {"lost", at_rest->lost},
                           {"largest_move_in_spacings", at_rest->largest_move},
                           {"fault", at_rest->fault}};
    if (!springs.empty()) json["elastic"] = list(springs);
    if (!joins.empty()) json["joins"] = list(joins);
    if (!spheres.empty()) json["spheres"] = list(spheres);
    Json seconds = Json::object();
    for (const Stage& stage : cost.stages)
        seconds[stage.name] = {{"clock", stage.seconds}, {"processor", stage.processor_seconds}};
    json["cost"] = {{"candidates", cost.candidates}, {"seconds", seconds}, {"peak_bytes", cost.peak_bytes}};
    json["notes"] = notes;
    json["warnings"] = warnings;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace dmp::mesher
