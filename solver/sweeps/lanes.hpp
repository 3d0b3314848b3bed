// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace dmp {

/// Eight doubles that are worked on together: the particles of one cluster side by side. The compiler maps them to
/// whatever vector unit the target has, so results do not depend on its width.
struct Lanes {
    static constexpr std::size_t width = 8;
    using Raw = double __attribute__((vector_size(width * sizeof(double))));
    Raw raw;

    Lanes() = default;
    Lanes(double value) : raw(value - Raw{}) {}  // NOLINT(google-explicit-constructor): broadcast reads as a number
    explicit Lanes(Raw values) : raw(values) {}

    /// values[index[k]] for each lane k.
    static Lanes gather(const double* values, const int* index) {
        Lanes lanes;
        for (std::size_t k = 0; k < width; ++k) lanes.raw[k] = values[index[k]];
        return lanes;
    }
    /// Writes the first `count` lanes to values[index[k]].
    void scatter(double* values, const int* index, std::size_t count) const {
        for (std::size_t k = 0; k < count; ++k) values[index[k]] = raw[k];
    }

    friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.raw + b.raw); }
    friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.raw - b.raw); }
    friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.raw * b.raw); }
    friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.raw / b.raw); }
    friend Lanes operator-(Lanes a) { return Lanes(-a.raw); }
    Lanes& operator+=(Lanes b) { return *this = *this + b; }
    Lanes& operator-=(Lanes b) { return *this = *this - b; }

    friend Lanes max(Lanes a, Lanes b) { return Lanes(a.raw > b.raw ? a.raw : b.raw); }
    friend Lanes min(Lanes a, Lanes b) { return Lanes(a.raw < b.raw ? a.raw : b.raw); }
    friend Lanes sqrt(Lanes a) {
        Lanes root;
        for (std::size_t k = 0; k < width; ++k) root.raw[k] = __builtin_sqrt(a.raw[k]);
        return root;
    }
    /// a where x < y, else b.
    friend Lanes where_less(Lanes x, Lanes y, Lanes a, Lanes b) { return Lanes(x.raw < y.raw ? a.raw : b.raw); }
};

inline double where_less(double x, double y, double a, double b) { return x < y ? a : b; }

}  // namespace dmp
