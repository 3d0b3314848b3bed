// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/chains.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

#include "geometry/exact_predicates.hpp"
#include "geometry/segments.hpp"

namespace dmp::geometry {

namespace {

using Position = std::array<double, 3>;

Position position(const Vec& point) { return {point.x(), point.y(), point.z()}; }

/// A piece in one of its two directions.
struct Directed {
    std::size_t piece = 0;
    bool reversed = false;
};

/// Which pieces start or end where, and which are not used yet.
class Junctions {
  public:
    explicit Junctions(const std::vector<CurvePiece>& pieces) : pieces_(pieces), used_(pieces.size(), false) {
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            leaving_[position(pieces[i].front())].push_back({.piece = i, .reversed = false});
            leaving_[position(pieces[i].back())].push_back({.piece = i, .reversed = true});
        }
    }

    [[nodiscard]] bool used(std::size_t piece) const { return used_[piece]; }
    void use(std::size_t piece) { used_[piece] = true; }
    [[nodiscard]] std::size_t degree(const Vec& point) const { return leaving_.at(position(point)).size(); }

    [[nodiscard]] std::optional<Directed> first_unused(const Vec& from) const {
        for (const auto& directed : leaving_.at(position(from))) {
            if (!used_[directed.piece]) return directed;
        }
        return std::nullopt;
    }

    /// Takes pieces from `from` onwards as long as exactly two meet.
    void follow(const Vec& from, std::vector<Directed>& chain) {
        Vec end = from;
        while (degree(end) == 2) {
            const auto next = first_unused(end);
            if (!next) return;
            use(next->piece);
            chain.push_back(*next);
            end = end_of(*next);
        }
    }

    [[nodiscard]] const Vec& end_of(const Directed& d) const {
        return d.reversed ? pieces_[d.piece].front() : pieces_[d.piece].back();
    }

  private:
    const std::vector<CurvePiece>& pieces_;
    std::map<Position, std::vector<Directed>> leaving_;
    std::vector<bool> used_;
};

Polyline joined(const std::vector<Directed>& chain, const std::vector<CurvePiece>& pieces) {
    Polyline line;
    const auto append = [&](const Vec& point) {
        if (line.points.empty() || line.points.back() != point) line.points.push_back(point);
    };
    for (const auto& [piece, reversed] : chain) {
        const auto& points = pieces[piece];
        if (reversed) {
            std::for_each(points.rbegin(), points.rend(), append);
        } else {
            std::for_each(points.begin(), points.end(), append);
        }
    }
    line.closed = line.points.size() > 2 && line.points.front() == line.points.back();
    if (line.closed) line.points.pop_back();
    return line;
}

/// Removes pairs of pieces with the same points, whatever their direction.
void cancel_pairs(std::vector<CurvePiece>& pieces) {
    const auto key = [](const CurvePiece& piece) {
        std::vector<Position> positions;
        for (const auto& point : piece) positions.push_back(position(point));
        std::vector<Position> backwards(positions.rbegin(), positions.rend());
        return std::min(positions, backwards);
    };
    std::map<std::vector<Position>, std::size_t> count;
    for (const auto& piece : pieces) ++count[key(piece)];
    std::erase_if(pieces, [&](const CurvePiece& piece) {
        return std::exchange(count[key(piece)], 0) % 2 == 0;  // of an odd number the first stays
    });
}

double signed_area(const Polyline& loop) {
    double twice = 0;
    const Vec& origin = loop.points.front();
    for_each_segment(loop, [&](const Vec& a, const Vec& b) {
        const Vec u = a - origin;
        const Vec v = b - origin;
        twice += u.x() * v.y() - u.y() * v.x();
    });
    return 0.5 * twice;
}

/// Whether a loop lies in an odd number of the others.
bool is_hole(std::size_t loop, const std::vector<Polyline>& loops) {
    Region others;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        if (i != loop) others.loops.push_back(loops[i]);
    }
    for (const auto& point : loops[loop].points) {
        const Side side = others.side_of(point);
        if (side != Side::on_edge) return side == Side::inside;
    }
    return false;
}

}  // namespace

std::vector<Polyline> maximal_chains(const std::vector<CurvePiece>& pieces) {
    Junctions junctions(pieces);
    std::vector<Polyline> chains;
    for (std::size_t first = 0; first < pieces.size(); ++first) {
        if (junctions.used(first)) continue;
        junctions.use(first);
        std::vector<Directed> chain{{.piece = first, .reversed = false}};
        junctions.follow(pieces[first].back(), chain);
        std::vector<Directed> before;
        junctions.follow(pieces[first].front(), before);
        for (auto& directed : before) directed.reversed = !directed.reversed;
        chain.insert(chain.begin(), before.rbegin(), before.rend());
        chains.push_back(joined(chain, pieces));
    }
    return chains;
}

LoopSearch closed_loops(std::vector<CurvePiece> pieces) {
    cancel_pairs(pieces);
    Junctions junctions(pieces);
    LoopSearch result;
    for (const auto& start : pieces) {
        // Walk until nothing is left; where the path meets itself, the part since then is a loop of its own.
        std::vector<Directed> path;
        std::map<Position, std::size_t> met{{position(start.front()), 0}};
        Vec here = start.front();
        while (const auto next = junctions.first_unused(here)) {
            junctions.use(next->piece);
            path.push_back(*next);
            here = junctions.end_of(*next);
            const auto [again, fresh] = met.try_emplace(position(here), path.size());
            if (fresh) continue;
            const auto cut = path.begin() + static_cast<std::ptrdiff_t>(again->second);
            result.loops.push_back(joined({cut, path.end()}, pieces));
            path.erase(cut, path.end());
            std::erase_if(met, [&](const auto& entry) { return entry.second > path.size(); });
        }
        if (!path.empty()) {
            result.loose_end = here;
            return result;
        }
    }
    for (std::size_t i = 0; i < result.loops.size(); ++i) {
        auto& loop = result.loops[i];
        const bool clockwise = signed_area(loop) < 0;
        if (clockwise != is_hole(i, result.loops)) std::reverse(loop.points.begin() + 1, loop.points.end());
    }
    return result;
}

std::optional<Vec> self_crossing(const Region& region) {
    struct Segment {
        Vec a, b, low, high;
    };
    std::vector<Segment> segments;
    for_each_segment(region, [&](const Vec& a, const Vec& b) {
        segments.push_back({a, b, a.cwiseMin(b), a.cwiseMax(b)});
    });
    std::ranges::sort(segments, {}, [](const Segment& s) { return s.low.x(); });
    for (auto s = segments.begin(); s != segments.end(); ++s) {
        for (auto t = s + 1; t != segments.end() && t->low.x() <= s->high.x(); ++t) {
            const bool apart = t->low.y() > s->high.y() || t->high.y() < s->low.y();
            if (apart || !segments_cross(s->a, s->b, t->a, t->b)) continue;
            const Vec along = s->b - s->a;
            const Vec normal(t->a.y() - t->b.y(), t->b.x() - t->a.x(), 0);
            return Vec(s->a + along * (normal.dot(t->a - s->a) / normal.dot(along)));
        }
    }
    return std::nullopt;
}

}  // namespace dmp::geometry
