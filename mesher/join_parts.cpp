// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/join_parts.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>

#include "base/length_text.hpp"
#include "mesher/bonded_solids.hpp"
#include "mesher/uses.hpp"
#include "particles/cell_grid.hpp"

namespace dmp::mesher {

namespace {

/// Of a bond's half; a particle of the row between two bodies is within 0.71 of it, one beside two that touch is not.
constexpr double is_between = 0.8;
/// Longest bond where the scene says none: along edges and diagonals of a lattice [spacings].
constexpr double usual_reach = 1.5;

/// All particles of a set, by where they are.
class Positions {
  public:
    Positions(const ParticleSet& set, double reach) : set_(set) {
        Coordinates points;
        for (int axis = 0; axis < 3; ++axis)
            for (const Vec& position : set.position) points[axis].push_back(position[axis]);
        grid_ = CellGrid(points, set.size(), set.dimension, reach);
    }

    /// Calls visit(j, distance) for the particles within a distance of a place.
    template <class Visit>
    void for_each_near(const Vec& position, double distance, const Visit& visit) const {
        grid_.for_each_near({position.x(), position.y(), position.z()}, distance, [&](int j) {
            const double apart = (set_.position[static_cast<std::size_t>(j)] - position).norm();
            if (apart < distance) visit(static_cast<std::size_t>(j), apart);
        });
    }

  private:
    const ParticleSet& set_;
    CellGrid grid_;
};

std::pair<int, int> in_order(std::size_t a, std::size_t b) {
    return {static_cast<int>(std::min(a, b)), static_cast<int>(std::max(a, b))};
}

/// Of the bonds within a part [N/m]; infinity for walls, which are stiffer than any.
double mean_stiffness(const ParticleSet& set, int part) {
    double sum = 0;
    std::size_t count = 0;
    for (const Bond& bond : set.bonds) {
        if (set.part[bond.a] != part || set.part[bond.b] != part) continue;
        sum += bond.stiffness;
        ++count;
    }
    return count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::infinity();
}

/// Half a bond of each part, one behind the other: 1/k = (1/k_a + 1/k_b) / 2.
double stiffness_in_series(double a, double b) { return 2 / (1 / a + 1 / b); }

class Joining {
  public:
    Joining(ParticleSet& set, const Join& join, int number, double reach)
        : set_(set),
          join_(join),
          number_(number),
          reach_(reach),
          part_{set.part_named((*join.parts)[0]), set.part_named((*join.parts)[1])},
          positions_(set, reach) {
        for (const Bond& bond : set.bonds) bonded_.insert(in_order(bond.a, bond.b));
    }

    MeshReport::JoinLine make() {
        MeshReport::JoinLine line;
        line.name = join_.name;
        line.parts = *join_.parts;
        line.stiffness = join_.stiffness > 0
                             ? *join_.stiffness
                             : stiffness_in_series(mean_stiffness(set_, part_[0]), mean_stiffness(set_, part_[1]));
        line.shortest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < set_.size(); ++i) {
            if (set_.part[i] != part_[0]) continue;
            for (const auto& [j, length] : partners(i)) {
                if (crosses_a_gap(i, j, length)) {
                    ++line.across_gaps;
                    continue;
                }
                set_.bonds.push_back({static_cast<int>(i), static_cast<int>(j), length, line.stiffness, number_});
                bonded_.insert(in_order(i, j));
                ++line.bonds;
                line.shortest = std::min(line.shortest, length);
                line.longest = std::max(line.longest, length);
            }
        }
        if (line.bonds == 0) refuse(line);
        return line;
    }

  private:
    /// What a particle is to be bonded to, by number, with their distances.
    [[nodiscard]] std::vector<std::pair<std::size_t, double>> partners(std::size_t i) const {
        std::vector<std::pair<std::size_t, double>> found;
        positions_.for_each_near(set_.position[i], (1 + 1e-9) * reach_, [&](std::size_t j, double distance) {
            if (set_.part[j] != part_[1] || (part_[0] == part_[1] && j <= i)) return;
            if ((is_held(i) && is_held(j)) || bonded_.contains(in_order(i, j))) return;
            found.emplace_back(j, distance);
        });
        std::ranges::sort(found);
        return found;
    }
    [[nodiscard]] bool is_held(std::size_t i) const { return set_.fixed[i] != 0; }

    [[nodiscard]] bool crosses_a_gap(std::size_t i, std::size_t j, double length) const {
        bool found = false;
        const Vec middle = 0.5 * (set_.position[i] + set_.position[j]);
        positions_.for_each_near(middle, is_between * 0.5 * length, [&](std::size_t k, double) {
            found = found || (set_.part[k] != part_[0] && set_.part[k] != part_[1]);
        });
        return found;
    }

    /// Says how far apart the two are.
    [[noreturn]] void refuse(const MeshReport::JoinLine& line) const {
        const std::string parts = "'" + line.parts[0] + "' and '" + line.parts[1] + "'";
        std::ostringstream problem;
        problem << "join '" << line.name << "' makes no bond: ";
        if (line.across_gaps > 0)
            throw InputError(join_.parts.location,
                             problem.str() + "all " + std::to_string(line.across_gaps) + " pairs of " + parts +
                                 " within reach have a particle of another part between them",
                             "draw the two so that they touch");
        const double farthest = set_.box.extent().norm();
        double nearest = std::numeric_limits<double>::infinity();
        for (double reach = 2 * reach_; reach < 4 * farthest && !(nearest < reach); reach *= 2) nearest = gap(reach);
        if (!(nearest < std::numeric_limits<double>::infinity()))
            throw InputError(
                join_.parts.location,
                problem.str() + "there are no two particles of " + parts + " that are not held or bonded already",
                "leave the join out");
        problem << "no two particles of " << parts << " that are free or not bonded yet are within "
                << length_text(reach_) << " of each other; the nearest are " << length_text(nearest) << " apart";
        throw InputError(join_.within.given() ? join_.within.location : join_.parts.location, problem.str(),
                         "draw the two so that they touch, or write a larger within");
    }
    /// The smallest distance of two that could be bonded, if it is less than `reach` [m].
    [[nodiscard]] double gap(double reach) const {
        const Positions positions(set_, reach);
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < set_.size(); ++i) {
            if (set_.part[i] != part_[0]) continue;
            positions.for_each_near(set_.position[i], std::min(reach, nearest), [&](std::size_t j, double distance) {
                if (set_.part[j] != part_[1] || j == i || (is_held(i) && is_held(j))) return;
                if (!bonded_.contains(in_order(i, j))) nearest = std::min(nearest, distance);
            });
        }
        return nearest;
    }

    ParticleSet& set_;
    const Join& join_;
    int number_;
    double reach_;
    std::array<int, 2> part_;
    Positions positions_;
    std::set<std::pair<int, int>> bonded_;
};

}  // namespace

void join_parts(MeshResult& result, const Scene& scene) {
    const auto joins = scene.joins_of_enabled();
    if (joins.empty()) return;
    for (int number = 0; number < static_cast<int>(joins.size()); ++number) {
        const Join& join = *joins[static_cast<std::size_t>(number)];
        const double reach = join.within.given() ? *join.within : usual_reach * scene.particles.spacing;
        result.report.joins.push_back(Joining(result.particles, join, number, reach).make());
    }
    number_bodies(result.particles);
}

}  // namespace dmp::mesher
