// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace dmp::solver {

/// A sum of doubles without rounding. It therefore depends neither on the order of the summands nor on the number of
/// threads and ranks: a fixed-point number of 32-bit digits over the whole range of double. Each digit is stored in
/// 64 bits, so that carries can wait until about a thousand numbers have been added.
class ExactSum {
  public:
    ExactSum() = default;
    explicit ExactSum(std::span<const double> values) {
        for (const double value : values) add(value);
    }

    void add(double value) {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        const auto biased = static_cast<int>(bits >> fraction_bits & exponent_mask);
        if (biased == exponent_mask) {
            ++words_[std::isnan(value) ? not_numbers : value > 0 ? positive_infinities : negative_infinities];
            return;
        }
        const std::uint64_t fraction = bits & (hidden_bit - 1);
        // value = +- mantissa 2^(position - 1074)
        const std::uint64_t mantissa = biased == 0 ? fraction : fraction | hidden_bit;
        const int position = biased == 0 ? 0 : biased - 1;
        const int digit = position / digit_bits, shift = position % digit_bits;
        const auto low = static_cast<std::int64_t>(mantissa << shift & digit_mask);
        const auto high = static_cast<std::int64_t>(mantissa >> (digit_bits - shift));  // below 2^52
        const std::int64_t sign = -static_cast<std::int64_t>(bits >> 63);               // 0 or -1
        words_[digit] += (low ^ sign) - sign;
        words_[digit + 1] += (high ^ sign) - sign;
        if (++waiting_ == most_waiting) carry();
    }

    void add(const ExactSum& other) {
        ExactSum addend = other;
        add_words(addend.carried_words());
    }

    /// The sum, rounded once: to the nearest double, ties to even. Infinite beyond the range of double or if
    /// infinities of one sign were added; NaN if a NaN or infinities of both signs were added.
    [[nodiscard]] double value() const;

    static constexpr int digit_bits = 32;
    /// 2098 bits for doubles and 46 for carries; then the numbers of NaN, +inf and -inf that were added.
    static constexpr std::size_t digits = 67, words = digits + 3;
    using Words = std::array<std::int64_t, words>;

    /// The sum as integers. Up to 2^30 sums can be added entry by entry; the result represents their total.
    [[nodiscard]] const Words& carried_words() {
        carry();
        return words_;
    }
    /// Adds integers returned by carried_words().
    void add_words(const Words& addends) {
        carry();
        for (std::size_t k = 0; k < words; ++k) words_[k] += addends[k];
        carry();
    }

  private:
    static constexpr int fraction_bits = 52, exponent_mask = 0x7ff, least_exponent = -1074;
    static constexpr std::uint64_t hidden_bit = 1ULL << fraction_bits, digit_mask = (1ULL << digit_bits) - 1;
    static constexpr std::size_t not_numbers = digits, positive_infinities = digits + 1,
                                 negative_infinities = digits + 2;
    static constexpr int most_waiting = 1024;  // 2^10 numbers below 2^52 and a digit stay below 2^63

    /// Brings every digit except the last, which holds the sign, into [0, 2^32).
    void carry() {
        for (std::size_t k = 0; k + 1 < digits; ++k) {
            words_[k + 1] += words_[k] >> digit_bits;
            words_[k] &= static_cast<std::int64_t>(digit_mask);
        }
        waiting_ = 0;
    }

    Words words_{};
    int waiting_ = 0;  ///< numbers added since the last carry
};

inline double ExactSum::value() const {
    if (words_[not_numbers] > 0 || (words_[positive_infinities] > 0 && words_[negative_infinities] > 0))
        return std::numeric_limits<double>::quiet_NaN();
    if (words_[positive_infinities] > 0) return std::numeric_limits<double>::infinity();
    if (words_[negative_infinities] > 0) return -std::numeric_limits<double>::infinity();

    ExactSum sum = *this;
    sum.carry();
    const bool negative = sum.words_[digits - 1] < 0;
    if (negative) {
        for (std::size_t k = 0; k < digits; ++k) sum.words_[k] = -sum.words_[k];
        sum.carry();
    }
    std::size_t top = digits - 1;
    while (top > 0 && sum.words_[top] == 0) --top;
    const auto digit = [&sum](std::size_t k) { return static_cast<std::uint64_t>(sum.words_[k]); };

    // The leading 64 bits; the lower ones only distinguish a tie from more than a tie.
    std::uint64_t leading = digit(top);
    if (leading == 0) return 0;
    std::size_t next = top;
    int position = digit_bits * static_cast<int>(top);  // of leading's last bit; 0: the smallest double's
    while (next > 0 && std::countl_zero(leading) >= digit_bits) {
        leading = leading << digit_bits | digit(--next);
        position -= digit_bits;
    }
    if (const int room = std::countl_zero(leading); next > 0 && room > 0) {
        leading = leading << room | digit(next - 1) >> (digit_bits - room);
        position -= room;
        if ((digit(next - 1) & (digit_mask >> room)) != 0) leading |= 1;
        --next;
    }
    bool more = false;
    for (std::size_t k = 0; k < next; ++k) more = more || digit(k) != 0;
    if (more) leading |= 1;

    const int surplus = 64 - std::countl_zero(leading) - (fraction_bits + 1);
    std::uint64_t mantissa = leading;
    if (surplus > 0) {
        const std::uint64_t rest = leading & ((1ULL << surplus) - 1), half = 1ULL << (surplus - 1);
        mantissa = leading >> surplus;
        position += surplus;
        if (rest > half || (rest == half && (mantissa & 1) != 0)) ++mantissa;
    }
    const double magnitude = std::ldexp(static_cast<double>(mantissa), position + least_exponent);
    return negative ? -magnitude : magnitude;
}

}  // namespace dmp::solver
