// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace dmp::solver {

/// Rows of four numbers, one a lane, turned into four columns of lanes, and back: `L::width` rows at a time, through
/// the shuffles of the vector unit where the lanes fill 32 or 64 bytes.
template <class L>
class Columns {
  public:
    using Four = std::array<L, 4>;

    /// Row `index[k] * stride` doubles behind `base` becomes lane k.
    static Four load(const double* base, std::size_t stride, const std::int32_t* index) {
        const auto row = [&](std::size_t k) { return base + static_cast<std::size_t>(index[k]) * stride; };
        if constexpr (L::width == 4) {
            return from(transposed(read(row(0)), read(row(1)), read(row(2)), read(row(3))));
        } else if constexpr (L::width == 8) {
            return from(
                transposed(both(row(0), row(4)), both(row(1), row(5)), both(row(2), row(6)), both(row(3), row(7))));
        } else {
            Four columns;
            for (std::size_t k = 0; k < L::width; ++k)
                for (std::size_t c = 0; c < 4; ++c) columns[c].set(k, row(k)[c]);
            return columns;
        }
    }

    /// Calls take(k, row) with the four numbers of each lane k.
    template <class Take>
    static void for_each_row(const Four& columns, const Take& take) {
        if constexpr (L::width == 4) {
            const auto rows = transposed(raw(columns[0]), raw(columns[1]), raw(columns[2]), raw(columns[3]));
            for (std::size_t k = 0; k < 4; ++k) take(k, rows[k]);
        } else if constexpr (L::width == 8) {
            const auto rows = transposed(raw(columns[0]), raw(columns[1]), raw(columns[2]), raw(columns[3]));
            for (std::size_t k = 0; k < 4; ++k) take(k, low_half(rows[k]));
            for (std::size_t k = 0; k < 4; ++k) take(k + 4, high_half(rows[k]));
        } else {
            for (std::size_t k = 0; k < L::width; ++k)
                take(k, Quad{columns[0][k], columns[1][k], columns[2][k], columns[3][k]});
        }
    }

    using Quad [[gnu::vector_size(32)]] = double;
    static Quad read(const double* row) {
        Quad quad;
        std::memcpy(&quad, row, sizeof quad);
        return quad;
    }
    static void write(double* row, Quad quad) { std::memcpy(row, &quad, sizeof quad); }

  private:
    using Pair [[gnu::vector_size(64)]] = double;

    static Pair both(const double* low, const double* high) {
        return __builtin_shufflevector(read(low), read(high), 0, 1, 2, 3, 4, 5, 6, 7);
    }
    static Quad low_half(Pair pair) { return __builtin_shufflevector(pair, pair, 0, 1, 2, 3); }
    static Quad high_half(Pair pair) { return __builtin_shufflevector(pair, pair, 4, 5, 6, 7); }

    static std::array<Quad, 4> transposed(Quad a, Quad b, Quad c, Quad d) {
        const Quad ab0 = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab1 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
        const Quad cd0 = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd1 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
        return {__builtin_shufflevector(ab0, cd0, 0, 1, 4, 5), __builtin_shufflevector(ab1, cd1, 0, 1, 4, 5),
                __builtin_shufflevector(ab0, cd0, 2, 3, 6, 7), __builtin_shufflevector(ab1, cd1, 2, 3, 6, 7)};
    }
    /// Each half by itself.
    static std::array<Pair, 4> transposed(Pair a, Pair b, Pair c, Pair d) {
        const Pair ab0 = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14),
                   ab1 = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15),
                   cd0 = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14),
                   cd1 = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
        return {__builtin_shufflevector(ab0, cd0, 0, 1, 8, 9, 4, 5, 12, 13),
                __builtin_shufflevector(ab1, cd1, 0, 1, 8, 9, 4, 5, 12, 13),
                __builtin_shufflevector(ab0, cd0, 2, 3, 10, 11, 6, 7, 14, 15),
                __builtin_shufflevector(ab1, cd1, 2, 3, 10, 11, 6, 7, 14, 15)};
    }

    template <class Raw>
    static Four from(const std::array<Raw, 4>& columns) {
        return {std::bit_cast<L>(columns[0]), std::bit_cast<L>(columns[1]), std::bit_cast<L>(columns[2]),
                std::bit_cast<L>(columns[3])};
    }
    static auto raw(const L& lanes) {
        if constexpr (L::width == 4)
            return std::bit_cast<Quad>(lanes);
        else
            return std::bit_cast<Pair>(lanes);
    }
};

}  // namespace dmp::solver
