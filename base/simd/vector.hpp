// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dmp::simd {

/// D numbers of type T (double or Lanes) that add and scale like a vector.
template <class T, int D>
struct Vector {
    T c[D];

    T& operator[](int axis) { return c[axis]; }
    const T& operator[](int axis) const { return c[axis]; }

    Vector& operator+=(const Vector& b) {
        for (int a = 0; a < D; ++a) c[a] = c[a] + b.c[a];
        return *this;
    }
    Vector& operator-=(const Vector& b) {
        for (int a = 0; a < D; ++a) c[a] = c[a] - b.c[a];
        return *this;
    }
    static Vector zero() {
        Vector v;
        for (int a = 0; a < D; ++a) {
            if constexpr (requires { T::zero(); }) {
                v.c[a] = T::zero();
            } else {
                v.c[a] = T(0.0);
            }
        }
        return v;
    }
};

/// The wider of two scalars: Lanes if either is.
template <class A, class B>
using Wider = decltype(A(0.0) * B(0.0));

template <class A, class B, int D>
auto operator+(const Vector<A, D>& a, const Vector<B, D>& b) {
    Vector<Wider<A, B>, D> sum;
    for (int k = 0; k < D; ++k) sum.c[k] = a.c[k] + b.c[k];
    return sum;
}
template <class A, class B, int D>
auto operator-(const Vector<A, D>& a, const Vector<B, D>& b) {
    Vector<Wider<A, B>, D> difference;
    for (int k = 0; k < D; ++k) difference.c[k] = a.c[k] - b.c[k];
    return difference;
}
template <class A, class B, int D>
auto operator*(const A& s, const Vector<B, D>& v) {
    Vector<Wider<A, B>, D> scaled;
    for (int k = 0; k < D; ++k) scaled.c[k] = s * v.c[k];
    return scaled;
}
template <class A, class B, int D>
auto dot(const Vector<A, D>& a, const Vector<B, D>& b) {
    Wider<A, B> sum = a.c[0] * b.c[0];
    for (int k = 1; k < D; ++k) sum = sum + a.c[k] * b.c[k];
    return sum;
}
template <class T>
Vector<T, 3> cross(const Vector<T, 3>& a, const Vector<T, 3>& b) {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

}  // namespace dmp::simd
