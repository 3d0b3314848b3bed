// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/repair_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/length_text.hpp"
#include "geometry/crossing_pieces.hpp"
#include "geometry/number_text.hpp"
#include "geometry/orient_surface.hpp"
#include "geometry/split_edges.hpp"
#include "geometry/surface_edges.hpp"
#include "geometry/surface_pieces.hpp"
#include "geometry/weld_corners.hpp"
#include "geometry/winding_vote.hpp"
#include "geometry/wrap_surface.hpp"

namespace dmp::geometry {

namespace {

/// How far the volume that a wrap holds may be from what the winding number says of the surface.
constexpr double largest_wrap_error = 0.15;
/// The share of a surface's area that may be thrown away in small open pieces.
constexpr double largest_crumbs = 0.01;

class Ladder {
  public:
    Ladder(TriangleSurface surface, const RepairLimits& limits, const std::string& name, const SourceLocation& location)
        : surface_(std::move(surface)), limits_(limits), name_(name), location_(location) {
        report_.spacing = limits.spacing;
        report_.triangles_before = surface_.triangles.size() + surface_.left_out;
        report_.without_area = surface_.left_out;
    }

    RepairedSurface climb() {
        check_numbers();
        weld();
        report_.separated_edges = separate_closed_pieces(surface_);
        initial_ = surface_.triangles;
        orient_outward(surface_);
        throw_pieces();
        fill();
        if (count_edges(surface_).closed()) {
            find_crossings();
            count_turned();
            report_.by = report_.changed() || report_.separated_edges > 0 ? RepairedBy::closing : RepairedBy::nothing;
        } else {
            vote_or_wrap();
        }
        if (!report_.thrown.empty() && report_.by != RepairedBy::wrap) leave_corners_out();
        report_.triangles = surface_.triangles.size();
        report_.pieces = SurfacePieces(surface_).all().size();
        return {std::move(surface_), std::move(report_)};
    }

  private:
    [[noreturn]] void refuse(const std::string& problem, const std::string& what_to_do,
                             const std::vector<int>& triangles) const {
        throw UnusableSurface(location_, name_ + " " + problem, what_to_do, part_of(surface_, triangles));
    }
    [[noreturn]] void refuse_flat(const std::string& at) const {
        refuse("has no volume: its triangles lie back to back" + at, "give it a thickness, or name it as a surface",
               all_triangles());
    }
    /// Those of pieces that are gone.
    void leave_corners_out() {
        TriangleSurface left = part_of(surface_, all_triangles());
        surface_.corners = std::move(left.corners);
        surface_.triangles = std::move(left.triangles);
    }
    [[nodiscard]] std::vector<int> all_triangles() const {
        std::vector<int> all(surface_.triangles.size());
        std::iota(all.begin(), all.end(), 0);
        return all;
    }
    [[nodiscard]] Vec middle_of(int triangle) const {
        const auto& [a, b, c] = surface_.triangles[static_cast<std::size_t>(triangle)];
        return (surface_.corners[static_cast<std::size_t>(a)] + surface_.corners[static_cast<std::size_t>(b)] +
                surface_.corners[static_cast<std::size_t>(c)]) /
               3;
    }

    void check_numbers() const {
        const auto corners = static_cast<int>(surface_.corners.size());
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
            for (const int corner : surface_.triangles[t]) {
                if (corner < 0 || corner >= corners)
                    throw UnusableSurface(location_,
                                          name_ + " has a triangle, number " + std::to_string(t) + ", with corner " +
                                              std::to_string(corner) + " of " + std::to_string(corners),
                                          "export the surface again", {});
                if (!surface_.corners[static_cast<std::size_t>(corner)].allFinite())
                    refuse("has a corner that is not finite, of triangle " + std::to_string(t),
                           "export the surface again", {static_cast<int>(t)});
            }
    }

    void drop() {
        const DroppedTriangles dropped = drop_useless_triangles(surface_);
        report_.without_area += dropped.without_area;
        report_.duplicates += dropped.duplicates;
        report_.inner_walls += dropped.inner_walls;
    }

    /// As little as closes the surface.
    void weld() {
        report_.equal_corners = weld_corners(surface_, 0);
        const std::optional<Vec> somewhere =
            surface_.triangles.empty() ? std::nullopt : std::optional<Vec>(middle_of(0));
        drop();
        if (surface_.triangles.empty() && report_.inner_walls > 0) refuse_flat(" at " + position_text(*somewhere));
        if (surface_.triangles.empty()) refuse("has no triangle with an area", "export the surface again", {});
        if (const EdgeCounts edges = count_edges(surface_); edges.open == 0 && edges.many_fold == 0) return;
        if (limits_.highest < RepairRung::weld) return;
        report_.weld_distance = limits_.weld_distance * limits_.spacing;
        report_.welded_corners = weld_corners(surface_, report_.weld_distance);
        if (report_.welded_corners > 0) drop();
        report_.t_junctions = split_at_t_junctions(surface_, report_.weld_distance);
        if (surface_.triangles.empty())
            refuse("is so small that all of it becomes one corner", "check its unit, or choose a smaller spacing", {});
    }

    void throw_pieces() {
        const SurfacePieces pieces(surface_);
        const double least = limits_.smallest_piece * limits_.spacing;
        const auto is_small = [&](const SurfacePiece& piece) { return piece.box.extent().norm() < least; };
        Box box = pieces.all().front().box;
        double area = 0, small_open_area = 0;
        for (const SurfacePiece& piece : pieces.all()) {
            box.low = box.low.cwiseMin(piece.box.low);
            box.high = box.high.cwiseMax(piece.box.high);
            area += piece.area;
            if (is_small(piece) && !piece.closed) small_open_area += piece.area;
        }
        if (box.extent().norm() < least)
            refuse("is smaller than a particle: it is " + length_text(box.extent().norm()) + " across, at " +
                       position_text(0.5 * (box.low + box.high)) + ", and the spacing " + length_text(limits_.spacing),
                   "check its unit, or choose a smaller spacing", all_triangles());
        std::vector<char> kept(surface_.triangles.size(), 1);
        for (const SurfacePiece& piece : pieces.all()) {
            // What is in pieces all over may still be one body; a few crumbs are none.
            const bool is_crumb = is_small(piece) && (piece.closed || small_open_area < largest_crumbs * area);
            if (!is_crumb && !piece.has_no_volume()) continue;
            report_.thrown.push_back({piece.triangles.size(), 0.5 * (piece.box.low + piece.box.high),
                                      piece.box.extent().norm(), piece.area, is_crumb});
            for (const int t : piece.triangles) kept[static_cast<std::size_t>(t)] = 0;
        }
        if (report_.thrown.empty()) return;
        if (report_.thrown.size() == pieces.all().size()) {
            const std::string at = " at " + position_text(report_.thrown.front().position);
            if (std::ranges::all_of(report_.thrown, &ThrownPiece::is_small))
                refuse("falls into " + std::to_string(report_.thrown.size()) +
                           " bodies smaller than a particle, the first" + at,
                       "check its unit, or choose a smaller spacing", all_triangles());
            refuse_flat(at);
        }
        const auto erase = [&](std::vector<std::array<int, 3>>& triangles) {
            std::size_t t = 0;
            std::erase_if(triangles, [&](const auto&) { return kept[t++] == 0; });
        };
        erase(surface_.triangles);
        erase(initial_);
        orient_outward(surface_);
    }

    void fill() {
        const double largest = limits_.highest < RepairRung::fill ? 0 : limits_.largest_hole;
        report_.holes = fill_holes(surface_, largest * limits_.spacing);
        if (std::ranges::any_of(report_.holes, [](const SurfaceHole& hole) { return hole.triangles > 0; }))
            orient_outward(surface_);
    }

    void find_crossings() {
        if (!limits_.meets_itself && SurfacePieces(surface_).all().size() == 1) return;
        const auto pairs = turn_crossing_pieces(surface_);
        report_.self_intersections = pairs.size();
        if (!pairs.empty()) report_.first_self_intersection = middle_of(pairs.front().first);
    }

    void count_turned() {
        for (std::size_t t = 0; t < initial_.size(); ++t)
            report_.turned += initial_[t] != surface_.triangles[t] ? 1 : 0;
    }

    /// Sheets have no side that they must face: they are taken as they were drawn if that is clearer.
    WindingVote turn_sheets(const std::vector<int>& sheets) {
        const WindingVote vote = vote_on(surface_);
        if (sheets.empty()) return vote;
        TriangleSurface in_cad_model = surface_;
        for (const int t : sheets)
            if (static_cast<std::size_t>(t) < initial_.size())
                in_cad_model.triangles[static_cast<std::size_t>(t)] = initial_[static_cast<std::size_t>(t)];
        const WindingVote other = vote_on(in_cad_model);
        if (other.volume <= vote.volume) return vote;
        surface_ = std::move(in_cad_model);
        return other;
    }

    void vote_or_wrap() {
        const std::vector<int> sheets = turn_open_pieces(surface_);
        if (limits_.highest < RepairRung::vote) refuse_open(sheets);
        const WindingVote vote = turn_sheets(sheets);
        count_turned();
        if (sheets.empty() && vote.doubt <= limits_.largest_doubt) {
            report_.by = RepairedBy::vote;
            report_.doubt = vote.doubt;
            surface_.has_holes = true;
            return;
        }
        if (limits_.highest >= RepairRung::wrap && vote.volume > 0) {
            report_.wrap_alpha = limits_.wrap_alpha * limits_.spacing;
            report_.wrap_offset = limits_.wrap_offset * limits_.spacing;
            TriangleSurface wrapped = wrap_surface(surface_, report_.wrap_alpha, report_.wrap_offset);
            const double within = wrapped.enclosed_volume() - report_.wrap_offset * wrapped.area();
            if (std::abs(within - vote.volume) <= largest_wrap_error * vote.volume) {
                surface_ = std::move(wrapped);
                report_.by = RepairedBy::wrap;
                return;
            }
        }
        refuse_open(sheets);
    }

    [[noreturn]] void refuse_open(const std::vector<int>& sheets) const {
        std::vector<int> bad = triangles_at_faults(surface_);
        bad.insert(bad.end(), sheets.begin(), sheets.end());
        std::string first;
        const std::vector<SurfaceEdge> edges = edges_of(surface_);
        for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
            if (sides.size() == 2 && sides[0].forward != sides[1].forward) return;
            if (first.empty())
                first = position_text(surface_.corners[static_cast<std::size_t>(sides[0].low)]) + " to " +
                        position_text(surface_.corners[static_cast<std::size_t>(sides[0].high)]);
        });
        std::ranges::sort(bad);
        bad.erase(std::unique(bad.begin(), bad.end()), bad.end());
        const EdgeCounts counts = count_edges(surface_);
        const bool tried_all = limits_.highest == RepairRung::wrap;
        std::string problem = "is not closed and " +
                              std::string(tried_all ? "cannot be repaired: " : "not to be repaired any further: ") +
                              std::to_string(counts.open) + " edges with one triangle, " +
                              std::to_string(counts.many_fold) + " with more than two, " +
                              std::to_string(counts.unlike) + " whose triangles face different sides, the first from " +
                              first;
        if (!sheets.empty()) problem += "; triangles of sheets, which have no inside: " + std::to_string(sheets.size());
        const auto largest = std::ranges::max_element(report_.holes, {}, &SurfaceHole::perimeter);
        if (largest != report_.holes.end())
            problem += "; the largest hole is " + number_text(largest->perimeter / limits_.spacing) +
                       " spacings around, at " + position_text(largest->position);
        refuse(problem,
               tried_all ? "close it in the program that drew it; holes that are filled have at most " +
                               number_text(limits_.largest_hole) + " spacings around (geometry.largest_hole)"
                         : std::string("close it in the program that drew it, or let geometry.repair go further") +
                               (limits_.highest >= RepairRung::fill ? ", or raise geometry.largest_hole" : ""),
               bad);
    }

    TriangleSurface surface_;
    const RepairLimits& limits_;
    const std::string& name_;
    const SourceLocation& location_;
    RepairReport report_;
    std::vector<std::array<int, 3>> initial_;  ///< triangles before they were turned; those that fill holes come behind
};

}  // namespace

RepairedSurface repair_surface(TriangleSurface surface, const RepairLimits& limits, const std::string& name,
                               const SourceLocation& location) {
    for (const double limit : {limits.spacing, limits.weld_distance, limits.wrap_alpha, limits.wrap_offset})
        if (!(limit > 0)) throw std::invalid_argument("repair_surface: limits must be positive");
    return Ladder(std::move(surface), limits, name, location).climb();
}

}  // namespace dmp::geometry
