// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/length_text.hpp"

#include <cmath>
#include <locale>
#include <sstream>

namespace dmp {

namespace {

/// The coordinates in a unit that suits the largest of them, and its name.
std::string coordinates_text(const Vec& lengths, int dimension, const char* between, const char* end, int digits) {
    const LengthUnit unit = length_unit(lengths.head(dimension).cwiseAbs().maxCoeff());
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(digits);
    for (int axis = 0; axis < dimension; ++axis) text << (axis > 0 ? between : "") << lengths[axis] / unit.metres;
    text << end << ' ' << unit.name;
    return text.str();
}

}  // namespace

LengthUnit length_unit(double size) {
    if (size == 0) return {};
    if (size < 1e-7) return {1e-9, "nm"};
    if (size < 1e-4) return {1e-6, "um"};
    if (size < 1) return {1e-3, "mm"};
    return {};
}

std::string length_text(double length) { return length_text(length, std::abs(length)); }

std::string length_text(double length, double size) {
    const LengthUnit unit = length_unit(size);
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(4);
    text << (std::abs(length) < 1e-6 * size ? 0 : length / unit.metres) << ' ' << unit.name;
    return text.str();
}

std::string position_text(const Vec& position, int dimension) {
    return "(" + coordinates_text(position, dimension, ", ", ")", 5);
}

std::string extent_text(const Box& box, int dimension) {
    return coordinates_text(box.extent(), dimension, " x ", "", 4);
}

}  // namespace dmp
