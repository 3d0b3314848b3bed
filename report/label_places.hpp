// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace dmp::report {

/// A place in a picture [px]; y grows downwards.
struct PicturePoint {
    double x = 0, y = 0;
};

struct PictureBox {
    double left = 0, top = 0, right = 0, bottom = 0;

    [[nodiscard]] PicturePoint centre() const { return {(left + right) / 2, (top + bottom) / 2}; }
};

/// [px^2]
[[nodiscard]] double shared_area(const PictureBox& a, const PictureBox& b);

/// What labels should not lie on.
struct LabelObstacles {
    std::vector<PictureBox> marks;   ///< one for each label, beside which it goes
    std::vector<PicturePoint> line;  ///< corners of a line, which matters less
    PictureBox frame;                ///< what they must not leave
};

/// A place for each label, of a width of its own and a common height [px]: beside its mark where there is room, else
/// somewhat further away, where it overlaps marks, other labels and the line least.
[[nodiscard]] std::vector<PictureBox> label_places(const LabelObstacles& obstacles, const std::vector<double>& widths,
                                                   double height);

}  // namespace dmp::report
