// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/solid_fields.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "solver/output/fluid_fields.hpp"

namespace dmp::solver {

namespace {

class SolidFields {
  public:
    SolidFields(FrameGroup& group, const std::vector<float>& volume, const SolidState& state)
        : group_(group), volume_(volume), state_(state), springs_(state.springs) {
        for (std::size_t k = 0; k < group.id.size(); ++k) index_of_[group.id[k]] = k;
    }

    void add_bonds() {
        for_each_bond([this](const SpringBody& body, const Bond& bond) {
            for (const int end : {bond.a, bond.b})
                group_.bond_ends.push_back(static_cast<std::int32_t>(index_of_.at(body.ids()[end])));
        });
    }

    void add(SolidField field) {
        switch (field) {
            case SolidField::velocity:
                return;  // the store knows it
            case SolidField::displacement:
                return add_nodes("displacement", "m", 3, [&](std::size_t body, std::size_t node) {
                    return springs_.bodies()[body]->displacement(node);
                });
            case SolidField::mean_displacement:
                return add_nodes("mean_displacement", "m", 3, [&](std::size_t body, std::size_t node) {
                    return state_.mean_displacement->of(springs_, body, node);
                });
            case SolidField::stress:
                return add_nodes("stress", "Pa", 6,
                                 [&](std::size_t body, std::size_t node) { return stress(body, node); });
            case SolidField::von_mises:
                return add_nodes("von_mises", "Pa", 1, [&](std::size_t body, std::size_t node) {
                    return std::array{von_mises(stress(body, node))};
                });
            case SolidField::surface_stress:
                return add_nodes("surface_stress", "Pa", 1, [&](std::size_t body, std::size_t node) {
                    const auto corners = springs_.bodies()[body]->surface_stresses(node);
                    if (corners.empty()) return std::array{von_mises(stress(body, node))};
                    double largest = 0;
                    for (const auto& corner : corners) largest = std::max(largest, von_mises(corner));
                    return std::array{largest};
                });
            case SolidField::principal_stretches:
                return add_nodes("principal_stretches", "1", 2,
                                 [&](std::size_t body, std::size_t node) { return stretches(body, node); });
            case SolidField::traction: {
                const auto tractions = state_.traction->on(springs_);
                return add_nodes("traction", "Pa", 3, [&](std::size_t body, std::size_t node) {
                    return tractions[body][node].value_or(Vec(Vec::Zero()));
                });
            }
            case SolidField::strain:
                return add_bond_field("strain", "1",
                                      [](const Bond& bond, double stretch) { return stretch / bond.rest_length; });
            case SolidField::force:
                return add_bond_field("force", "N",
                                      [](const Bond& bond, double stretch) { return 2 * bond.stiffness * stretch; });
        }
    }

  private:
    /// But for those to a wall's particle, which is shown with the walls.
    template <class Visit>
    void for_each_bond(const Visit& visit) const {
        for (const auto& body : springs_.bodies())
            for (const SpringBody::OwnBond& bond : body->bonds())
                if (!body->of_wall(bond.a) && !body->of_wall(bond.b)) visit(*body, bond);
    }

    std::array<double, 6> stress(std::size_t body, std::size_t node) {
        if (virial_.empty())
            for (const auto& each : springs_.bodies()) virial_.push_back(each->virial());
        std::array<double, 6> stress = virial_[body][node];
        const SpringBody& of = *springs_.bodies()[body];
        for (double& component : stress) component /= -volume_[index_of_.at(of.ids()[node])] * of.volume_ratio(node);
        return stress;
    }

    /// The least and the largest.
    std::array<double, 2> stretches(std::size_t body, std::size_t node) {
        const SpringBody& of = *springs_.bodies()[body];
        if (const auto strains = of.strains(node))  // Green's: E = (l^2 - 1) / 2
            return {std::sqrt(1 + 2 * (*strains)[0]), std::sqrt(1 + 2 * (*strains)[1])};
        if (of_bonds_.empty())
            for (const auto& each : springs_.bodies()) of_bonds_.push_back(stretches_of_bonds(*each));
        return of_bonds_[body][node];
    }
    static std::vector<std::array<double, 2>> stretches_of_bonds(const SpringBody& body) {
        constexpr double none = 0;
        std::vector<std::array<double, 2>> of_node(body.nodes(), {none, none});
        for (const SpringBody::OwnBond& bond : body.bonds()) {
            const double stretch = 1 + body.stretch(bond) / bond.rest_length;
            for (const int end : {bond.a, bond.b}) {
                auto& [least, largest] = of_node[static_cast<std::size_t>(end)];
                least = least == none ? stretch : std::min(least, stretch);
                largest = std::max(largest, stretch);
            }
        }
        for (auto& [least, largest] : of_node)
            if (largest == none) least = largest = 1;
        return of_node;
    }

    template <class ValuesOf>
    void add_nodes(const char* name, const char* unit, int components, const ValuesOf& values_of) {
        FrameField out{name, unit, components, {}};
        const auto width = static_cast<std::size_t>(components);
        out.values.resize(width * group_.id.size());
        for (std::size_t body = 0; body < springs_.bodies().size(); ++body) {
            const auto& ids = springs_.bodies()[body]->ids();
            for (std::size_t node = 0; node < ids.size(); ++node) {
                if (springs_.bodies()[body]->of_wall(node)) continue;
                const auto values = values_of(body, node);
                for (std::size_t c = 0; c < width; ++c)
                    out.values[width * index_of_.at(ids[node]) + c] = static_cast<float>(values[c]);
            }
        }
        group_.fields.push_back(std::move(out));
    }

    template <class ValueOf>
    void add_bond_field(const char* name, const char* unit, const ValueOf& value_of) {
        FrameField out{name, unit, 1, {}};
        for_each_bond([&](const SpringBody& body, const SpringBody::OwnBond& bond) {
            out.values.push_back(static_cast<float>(value_of(bond, body.stretch(bond))));
        });
        group_.bond_fields.push_back(std::move(out));
    }

    FrameGroup& group_;
    const std::vector<float>& volume_;
    SolidState state_;
    const SpringBodies& springs_;
    std::unordered_map<std::int64_t, std::size_t> index_of_;
    std::vector<std::vector<std::array<double, 6>>> virial_;    ///< by body and node, when it was needed
    std::vector<std::vector<std::array<double, 2>>> of_bonds_;  ///< stretches, the same
};

}  // namespace

void add_solid_fields(FrameGroup& group, const std::vector<SolidField>& wanted, const std::vector<float>& volume,
                      const SolidState& state) {
    SolidFields fields(group, volume, state);
    fields.add_bonds();
    for (const SolidField field : wanted) fields.add(field);
}

}  // namespace dmp::solver
