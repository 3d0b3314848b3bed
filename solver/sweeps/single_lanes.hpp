// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/sweeps/lanes.hpp"

namespace dmp {

/// What goes between lanes in single precision and two registers of lanes in double precision. Written for each vector
/// unit, because GCC 12 takes generic vectors of different widths apart: up to four times slower sweeps. (Its
/// intrinsics without a mask it warns of, wrongly; hence masks that hide nothing.)

#if defined(__AVX512DQ__)
inline SingleLanes in_single(Lanes low, Lanes high) {
    const __m256 singles = _mm512_maskz_cvtpd_ps(0xff, low.raw()), others = _mm512_maskz_cvtpd_ps(0xff, high.raw());
    return SingleLanes(_mm512_maskz_insertf32x8(0xffff, _mm512_castps256_ps512(singles), others, 1));
}
inline Lanes low_in_double(SingleLanes lanes) {
    return Lanes(_mm512_maskz_cvtps_pd(0xff, _mm512_maskz_extractf32x8_ps(0xff, lanes.raw(), 0)));
}
inline Lanes high_in_double(SingleLanes lanes) {
    return Lanes(_mm512_maskz_cvtps_pd(0xff, _mm512_maskz_extractf32x8_ps(0xff, lanes.raw(), 1)));
}
/// The first value in the lower half of the lanes, the second in the upper half.
inline SingleLanes in_halves(const float* low, const float* high, SingleLanes /*for its name*/) {
    return SingleLanes(_mm512_mask_broadcastss_ps(_mm512_set1_ps(*low), 0xff00, _mm_load_ss(high)));
}
/// Values from memory, as many as half the lanes, in both halves.
inline SingleLanes in_both_halves(const float* values, SingleLanes /*for its name*/) {
    return SingleLanes(_mm512_maskz_broadcast_f32x8(0xffff, _mm256_loadu_ps(values)));
}
#elif defined(__AVX__)
inline SingleLanes in_single(Lanes low, Lanes high) {
    return SingleLanes(_mm256_set_m128(_mm256_cvtpd_ps(high.raw()), _mm256_cvtpd_ps(low.raw())));
}
inline Lanes low_in_double(SingleLanes lanes) { return Lanes(_mm256_cvtps_pd(_mm256_castps256_ps128(lanes.raw()))); }
inline Lanes high_in_double(SingleLanes lanes) { return Lanes(_mm256_cvtps_pd(_mm256_extractf128_ps(lanes.raw(), 1))); }
#else
inline SingleLanes in_single(Lanes low, Lanes high) {
    SingleLanes lanes;
    for (std::size_t k = 0; k < SingleLanes::width; ++k)
        lanes.set(k, static_cast<float>(k < Lanes::width ? low[k] : high[k - Lanes::width]));
    return lanes;
}
inline Lanes low_in_double(SingleLanes lanes) {
    Lanes half;
    for (std::size_t k = 0; k < Lanes::width; ++k) half.set(k, lanes[k]);
    return half;
}
inline Lanes high_in_double(SingleLanes lanes) {
    Lanes half;
    for (std::size_t k = 0; k < Lanes::width; ++k) half.set(k, lanes[Lanes::width + k]);
    return half;
}
#endif

/// While it lives, results too small for single precision are 0. They would be rounded to 0 when they are summed, but
/// on the way processors take a hundred cycles for each.
template <class L>
class UnderflowToZero {
  public:
#if defined(__SSE__)
    UnderflowToZero() { _mm_setcsr(before_ | flush_to_zero | denormals_are_zero); }
    ~UnderflowToZero() { _mm_setcsr(before_); }
    UnderflowToZero(const UnderflowToZero&) = delete;
    UnderflowToZero& operator=(const UnderflowToZero&) = delete;

  private:
    static constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
    unsigned before_ = _mm_getcsr();
#endif
};

}  // namespace dmp
