// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "solver/contact/drawn_surfaces.hpp"

namespace dmp::solver {

namespace {

class CurveDrawing {
  public:
    explicit CurveDrawing(const ParticleSpace& space)
        : space_(space), before_(space.contact_points.size(), -1), after_(before_) {
        for (std::size_t k = 0; k < space.contact_pieces.size(); ++k) {
            after_[static_cast<std::size_t>(space.contact_pieces[k].a)] = static_cast<int>(k);
            before_[static_cast<std::size_t>(space.contact_pieces[k].b)] = static_cast<int>(k);
        }
    }

    DrawnSurfaces draw();

  private:
    using OfPoints = DrawnSurfaces::OfPoints;

    [[nodiscard]] const ContactPiece& line(int k) const { return space_.contact_pieces[static_cast<std::size_t>(k)]; }
    [[nodiscard]] const Vec& at(int point) const { return space_.contact_points[static_cast<std::size_t>(point)]; }
    [[nodiscard]] int before(int point) const { return before_[static_cast<std::size_t>(point)]; }
    [[nodiscard]] int after(int point) const { return after_[static_cast<std::size_t>(point)]; }

    /// To the left, of a point between two lines [rad].
    [[nodiscard]] double turn(int point) const {
        const Vec in = at(point) - at(line(before(point)).a), out = at(line(after(point)).b) - at(point);
        return std::atan2(in[0] * out[1] - in[1] * out[0], in.dot(out));
    }
    [[nodiscard]] bool is_inside(int point) const { return before(point) >= 0 && after(point) >= 0; }
    [[nodiscard]] bool is_smooth(int point) const {
        return is_inside(point) && std::abs(turn(point)) > straight_turn && std::abs(turn(point)) < sharp_turn;
    }
    /// So that the curve goes through the drawn points.
    [[nodiscard]] OfPoints control_of(int point) const {
        if (!is_smooth(point)) return {{point, 1.0}};
        return {{point, 1.25}, {line(before(point)).a, -0.125}, {line(after(point)).b, -0.125}};
    }
    [[nodiscard]] OfPoints middle(int a, int b) const {
        OfPoints both;
        for (const int point : {a, b})
            for (const auto& [of, share] : control_of(point)) both.emplace_back(of, 0.5 * share);
        return both;
    }
    int number_of(OfPoints control) {
        std::ranges::sort(control);
        const auto [found, is_new] = number_.try_emplace(control, static_cast<int>(drawn_.controls.size()));
        if (is_new) drawn_.controls.push_back(control);
        return found->second;
    }
    void add(int part, double thickness, const OfPoints& start, const OfPoints& between, const OfPoints& end) {
        drawn_.pieces.push_back({part, thickness, {number_of(start), number_of(end), number_of(between)}});
    }

    const ParticleSpace& space_;
    std::vector<int> before_, after_;  ///< the drawn lines before and after each point; -1: none
    DrawnSurfaces drawn_;
    std::map<OfPoints, int> number_;
};

/// A smooth point has a piece around it, from the middle of the line before to the middle of the line after; between
/// two corners (or straight points) the line is a piece.
DrawnSurfaces CurveDrawing::draw() {
    for (const ContactPiece& piece : space_.contact_pieces) {
        const int a = piece.a, b = piece.b;
        if (!is_smooth(a) && !is_smooth(b))
            add(piece.part, piece.thickness, control_of(a), middle(a, b), control_of(b));
        if (!is_smooth(b)) continue;
        const ContactPiece& next = line(after(b));
        add(piece.part, std::min(piece.thickness, next.thickness), is_smooth(a) ? middle(a, b) : control_of(a),
            control_of(b), is_smooth(next.b) ? middle(b, next.b) : control_of(next.b));
    }
    std::vector<int> pieces_at(drawn_.controls.size(), 0);
    for (const DrawnSurfaces::Piece& piece : drawn_.pieces)
        for (const std::size_t end : {0U, 1U}) ++pieces_at[static_cast<std::size_t>(piece.control[end])];
    for (std::size_t k = 0; k < drawn_.controls.size(); ++k) {
        const int point = drawn_.controls[k].front().first;
        const bool is_point = drawn_.controls[k].size() == 1;
        drawn_.is_sharp.push_back(is_point && is_inside(point) && turn(point) >= sharp_turn);
        drawn_.is_end.push_back(drawn_.is_sharp.back() || pieces_at[k] < 2);
    }
    return drawn_;
}

}  // namespace

DrawnSurfaces draw_curves(const ParticleSpace& space) { return CurveDrawing(space).draw(); }

}  // namespace dmp::solver
