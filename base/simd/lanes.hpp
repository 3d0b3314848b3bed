// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstring>

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace dmp::simd {

/// As many numbers as a vector register of the processor holds, worked on together: particles of one cluster side by
/// side. Results do not depend on how many there are.
template <class Real, std::size_t VectorBytes>
class BasicLanes {
  public:
    static constexpr std::size_t width = VectorBytes / sizeof(Real);

    BasicLanes() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): broadcast reads as a number
    BasicLanes(double value) : raw_(static_cast<Real>(value) - Raw{}) {}

    Real operator[](std::size_t lane) const { return raw_[lane]; }
    void set(std::size_t lane, Real value) { raw_[lane] = value; }

    /// Values from memory, one after another. All of them must be there, also those behind a short cluster.
    static BasicLanes load(const Real* values) {
        BasicLanes lanes;
        std::memcpy(&lanes.raw_, values, sizeof(Raw));
        return lanes;
    }
    /// Writes the first `count` lanes.
    void store(Real* values, std::size_t count) const {
        if (count == width) {
            std::memcpy(values, &raw_, sizeof(Raw));
        } else {
            for (std::size_t k = 0; k < count; ++k) values[k] = raw_[k];
        }
    }

    friend BasicLanes operator+(BasicLanes a, BasicLanes b) { return BasicLanes(a.raw_ + b.raw_); }
    friend BasicLanes operator-(BasicLanes a, BasicLanes b) { return BasicLanes(a.raw_ - b.raw_); }
    friend BasicLanes operator*(BasicLanes a, BasicLanes b) { return BasicLanes(a.raw_ * b.raw_); }
    friend BasicLanes operator/(BasicLanes a, BasicLanes b) { return BasicLanes(a.raw_ / b.raw_); }
    friend BasicLanes operator-(BasicLanes a) { return BasicLanes(-a.raw_); }
    BasicLanes& operator+=(BasicLanes b) { return *this = *this + b; }
    BasicLanes& operator-=(BasicLanes b) { return *this = *this - b; }

    friend BasicLanes max(BasicLanes a, BasicLanes b) { return larger(a.raw_, b.raw_); }
    friend BasicLanes min(BasicLanes a, BasicLanes b) { return BasicLanes(a.raw_ < b.raw_ ? a.raw_ : b.raw_); }
    friend BasicLanes sqrt(BasicLanes a) {
        BasicLanes root;
        for (std::size_t k = 0; k < width; ++k) root.raw_[k] = root_of(a.raw_[k]);
        return root;
    }
    /// a b + c, rounded once.
    friend BasicLanes multiply_add(BasicLanes a, BasicLanes b, BasicLanes c) {
#if defined(__AVX512F__)
        if constexpr (width == 8 && sizeof(Real) == 8) return BasicLanes(_mm512_fmadd_pd(a.raw_, b.raw_, c.raw_));
#endif
#if defined(__FMA__)
        if constexpr (width == 4 && sizeof(Real) == 8) return BasicLanes(_mm256_fmadd_pd(a.raw_, b.raw_, c.raw_));
#endif
        for (std::size_t k = 0; k < width; ++k) c.raw_[k] = multiply_add(a.raw_[k], b.raw_[k], c.raw_[k]);
        return c;
    }
    /// a where x < y, else b.
    friend BasicLanes where_less(BasicLanes x, BasicLanes y, BasicLanes a, BasicLanes b) {
        return BasicLanes(x.raw_ < y.raw_ ? a.raw_ : b.raw_);
    }

    /// Whether a < b in any lane.
    friend bool any_less(BasicLanes a, BasicLanes b) {
        const auto less = a.raw_ < b.raw_;
#if defined(__AVX512DQ__)
        if constexpr (sizeof(Raw) == 64 && sizeof(Real) == 8) return _mm512_movepi64_mask((__m512i)less) != 0;
#endif
#if defined(__AVX__)
        if constexpr (sizeof(Raw) == 32 && sizeof(Real) == 8) return _mm256_movemask_pd((__m256d)less) != 0;
#endif
        bool any = false;
        for (std::size_t k = 0; k < width; ++k) any = any || less[k] != 0;
        return any;
    }

    friend double least(BasicLanes a) {
        double value = a.raw_[0];
        for (std::size_t k = 1; k < width; ++k) value = a.raw_[k] < value ? a.raw_[k] : value;
        return value;
    }

  private:
    using Raw [[gnu::vector_size(VectorBytes)]] = Real;
    explicit BasicLanes(Raw values) : raw_(values) {}

    /// a > b ? a : b; where there is one, in the instruction that GCC does not find.
    static BasicLanes larger(Raw a, Raw b) {
#if defined(__AVX512F__)
        if constexpr (width == 8 && sizeof(Real) == 8) return BasicLanes(_mm512_maskz_max_pd(0xff, a, b));
        if constexpr (width == 16 && sizeof(Real) == 4) return BasicLanes(_mm512_maskz_max_ps(0xffff, a, b));
#endif
#if defined(__AVX__)
        if constexpr (width == 4 && sizeof(Real) == 8) return BasicLanes(_mm256_max_pd(a, b));
        if constexpr (width == 8 && sizeof(Real) == 4) return BasicLanes(_mm256_max_ps(a, b));
#endif
        return BasicLanes(a > b ? a : b);
    }
    static double multiply_add(double a, double b, double c) { return __builtin_fma(a, b, c); }
    static float multiply_add(float a, float b, float c) { return __builtin_fmaf(a, b, c); }
    static double root_of(double value) { return __builtin_sqrt(value); }
    static float root_of(float value) { return __builtin_sqrtf(value); }

    Raw raw_;
};

/// Bytes in a vector register of what this file is compiled for.
#if defined(__AVX512F__)
inline constexpr std::size_t vector_bytes = 64;
#elif defined(__AVX__)
inline constexpr std::size_t vector_bytes = 32;
#else
inline constexpr std::size_t vector_bytes = 16;
#endif

using Lanes = BasicLanes<double, vector_bytes>;

inline double multiply_add(double a, double b, double c) { return __builtin_fma(a, b, c); }
inline double where_less(double x, double y, double a, double b) { return x < y ? a : b; }

}  // namespace dmp::simd
