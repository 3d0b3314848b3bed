// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>

#include "solver/spheres/sphere_rows.hpp"

namespace dmp::solver {

/// A row's four numbers in a register.
using Quad [[gnu::vector_size(32)]] = double;

inline Quad read(const Row& row) {
    Quad quad;
    std::memcpy(&quad, row.c, sizeof quad);
    return quad;
}
inline void write(Row& row, Quad quad) { std::memcpy(row.c, &quad, sizeof quad); }

/// How far a velocity takes a sphere in a step, in whole quanta of places [m]: the way made, not the place, is rounded,
/// so that it is the same in every image. `magic` is PositionQuantum's. The fourth number is 0.
inline Quad way_of(Quad velocity, double dt, double magic) {
    const Quad step{dt, dt, dt, 0}, rounding{magic, magic, magic, 0};
    return (step * velocity + rounding) - rounding;
}

}  // namespace dmp::solver
