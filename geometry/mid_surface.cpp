// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mid_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "geometry/surface_edges.hpp"
#include "geometry/surface_pieces.hpp"
#include "geometry/triangle_tree.hpp"

namespace dmp::geometry {

namespace {

/// Lines meet the other face at no more than 30 degrees from its normal; faces make up at least half of a sheet's
/// surface, are alike in area within a third, and as far apart as the mean within a fifth on nine tenths of them.
constexpr double steepest = std::numbers::sqrt3 / 2, least_share = 0.5, least_likeness = 0.67, evenness = 0.2,
                 even_share = 0.9;

struct Opposite {
    int triangle = -1;  ///< -1: nothing is opposite
    double distance = 0;
};

class Search {
  public:
    Search(const TriangleSurface& body, double largest) : body_(body), tree_(body), largest_(largest) {}

    SheetSearch result() {
        cast_across();
        const std::vector<std::vector<int>> faces = find_faces();
        double in_faces = 0, all = 0;
        for (std::size_t t = 0; t < area_.size(); ++t) {
            all += area_[t];
            if (opposite_[t].triangle >= 0) in_faces += area_[t];
        }
        if (in_faces < least_share * all) return no_sheet("most of its surface has nothing opposite that is so near");
        std::vector<int> chosen;
        const SurfacePieces pieces(body_);
        std::map<std::size_t, int> sheets_of_piece;
        std::vector<char> taken(faces.size(), 0);
        for (std::size_t f = 0; f < faces.size(); ++f) {
            if (taken[f] != 0) continue;
            const std::size_t other = partner(faces[f]);
            if (other == f || other >= faces.size() || partner(faces[other]) != f)
                return no_sheet("its faces are not two that are opposite each other", &faces[f]);
            const double one = area_of(faces[f]), two = area_of(faces[other]);
            if (std::min(one, two) < least_likeness * std::max(one, two))
                return no_sheet("its two faces are not alike in area", &faces[f]);
            taken[f] = taken[other] = 1;
            const std::vector<int>& larger = one < two ? faces[other] : faces[f];
            if (++sheets_of_piece[pieces.piece_of(larger.front())] > 1)
                return no_sheet("it has more than two faces that are opposite each other", &larger);
            chosen.insert(chosen.end(), larger.begin(), larger.end());
        }
        if (chosen.empty()) return no_sheet("it has no two faces");
        return sheet_beside(chosen);
    }

  private:
    void cast_across() {
        for (const auto& [a, b, c] : body_.triangles) {
            const Vec across = (corner(b) - corner(a)).cross(corner(c) - corner(a));
            area_.push_back(0.5 * across.norm());
            normal_.push_back(across.norm() > 0 ? Vec(across.normalized()) : Vec(Vec::Zero()));
        }
        opposite_.resize(area_.size());
        for (std::size_t t = 0; t < area_.size(); ++t) {
            if (!(area_[t] > 0)) continue;
            opposite_[t] = across_from(middle_of(static_cast<int>(t)), t);
        }
    }

    /// What is opposite to a place of a triangle.
    [[nodiscard]] Opposite across_from(const Vec& position, std::size_t triangle) const {
        const Vec inward = -normal_[triangle];
        const auto hit = tree_.first_hit(position, inward, [&](int other) {
            return normal_[static_cast<std::size_t>(other)].dot(inward) >= steepest;
        });
        return hit && hit->distance <= largest_ ? Opposite{hit->triangle, hit->distance} : Opposite{};
    }

    /// Connected triangles that have something opposite, the largest face first; crumbs at the rim are left out.
    std::vector<std::vector<int>> find_faces() {
        DisjointSets sets(area_.size());
        const std::vector<SurfaceEdge> edges = edges_of(body_);
        for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
            for (const SurfaceEdge& side : sides)
                if (is_face(side.triangle) && is_face(sides.front().triangle))
                    sets.join(static_cast<std::size_t>(side.triangle),
                              static_cast<std::size_t>(sides.front().triangle));
        });
        std::map<std::size_t, std::vector<int>> by_first;
        for (std::size_t t = 0; t < area_.size(); ++t)
            if (is_face(static_cast<int>(t))) by_first[sets.find(t)].push_back(static_cast<int>(t));
        std::vector<std::vector<int>> faces;
        for (auto& [first, triangles] : by_first)
            if (area_of(triangles) > largest_ * largest_) faces.push_back(std::move(triangles));
        face_of_.assign(area_.size(), faces.size());
        for (std::size_t f = 0; f < faces.size(); ++f)
            for (const int t : faces[f]) face_of_[static_cast<std::size_t>(t)] = f;
        return faces;
    }

    /// The face that most of a face's area is opposite to.
    [[nodiscard]] std::size_t partner(const std::vector<int>& face) const {
        std::map<std::size_t, double> area;
        for (const int t : face) {
            const auto at = static_cast<std::size_t>(t);
            area[face_of_[static_cast<std::size_t>(opposite_[at].triangle)]] += area_[at];
        }
        return std::ranges::max_element(area, {}, [](const auto& entry) { return entry.second; })->first;
    }

    [[nodiscard]] SheetSearch sheet_beside(const std::vector<int>& chosen) const {
        MidSurface sheet;
        double sum = 0, area = 0;
        for (const int t : chosen) {
            const auto at = static_cast<std::size_t>(t);
            sum += area_[at] * opposite_[at].distance;
            area += area_[at];
        }
        sheet.thickness = sum / area;
        sheet.least = sheet.most = sheet.thickness;
        double even = 0;
        SheetSearch uneven{{}, "its thickness is not nearly the same everywhere", Vec::Zero(), sheet.thickness};
        for (const int t : chosen) {
            const auto at = static_cast<std::size_t>(t);
            for (const int k : body_.triangles[at]) {  // next to the corners
                const Vec position = 0.9 * corner(k) + 0.1 * middle_of(t);
                const Opposite here = across_from(position, at);
                const double thickness = here.triangle < 0 ? sheet.thickness : here.distance;  // cut at the rim
                sheet.least = std::min(sheet.least, thickness);
                sheet.most = std::max(sheet.most, thickness);
                const double off = std::abs(thickness - sheet.thickness);
                if (off <= evenness * sheet.thickness) even += area_[at] / 3;
                if (off <= std::abs(uneven.thickness - sheet.thickness)) continue;
                uneven.where = position;
                uneven.thickness = thickness;
            }
        }
        if (even < even_share * area) return uneven;
        sheet.surface = part_of(body_, chosen);
        std::vector<Vec> normal(sheet.surface.corners.size(), Vec::Zero());
        for (const auto& triangle : sheet.surface.triangles) {
            const auto at = [&](std::size_t k) -> const Vec& {
                return sheet.surface.corners[static_cast<std::size_t>(triangle.at(k))];
            };
            const Vec across = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
            for (std::size_t k = 0; k < 3; ++k) {  // weighted with the angle: however faces are cut in triangles
                const Vec one = at((k + 1) % 3) - at(k), other = at((k + 2) % 3) - at(k);
                normal[static_cast<std::size_t>(triangle.at(k))] +=
                    std::atan2(one.cross(other).norm(), one.dot(other)) * across;
            }
        }
        for (std::size_t k = 0; k < normal.size(); ++k)
            sheet.surface.corners[k] -= 0.5 * sheet.thickness * normal[k].normalized();
        return {std::move(sheet), {}, Vec::Zero(), 0};
    }

    /// The place is the thinnest one, of a face if given.
    SheetSearch no_sheet(const std::string& problem, const std::vector<int>* face = nullptr) const {
        SheetSearch search{{}, problem, Vec::Zero(), 0};
        const auto look = [&](int t) {
            const Opposite& here = opposite_[static_cast<std::size_t>(t)];
            if (here.triangle < 0 || (search.thickness > 0 && here.distance >= search.thickness)) return;
            search.where = middle_of(t);
            search.thickness = here.distance;
        };
        if (face != nullptr)
            std::ranges::for_each(*face, look);
        else
            for (int t = 0; t < static_cast<int>(area_.size()); ++t) look(t);
        return search;
    }

    [[nodiscard]] bool is_face(int t) const { return opposite_[static_cast<std::size_t>(t)].triangle >= 0; }
    [[nodiscard]] const Vec& corner(int k) const { return body_.corners[static_cast<std::size_t>(k)]; }
    [[nodiscard]] Vec middle_of(int t) const {
        const auto& [a, b, c] = body_.triangles[static_cast<std::size_t>(t)];
        return (corner(a) + corner(b) + corner(c)) / 3;
    }
    [[nodiscard]] double area_of(const std::vector<int>& triangles) const {
        double area = 0;
        for (const int t : triangles) area += area_[static_cast<std::size_t>(t)];
        return area;
    }

    const TriangleSurface& body_;
    TriangleTree tree_;
    double largest_;
    std::vector<double> area_;
    std::vector<Vec> normal_;
    std::vector<Opposite> opposite_;
    std::vector<std::size_t> face_of_;  ///< by triangle; the number of faces for those of none
};

}  // namespace

SheetSearch mid_surface(const TriangleSurface& body, double largest_thickness) {
    return Search(body, largest_thickness).result();
}

}  // namespace dmp::geometry
