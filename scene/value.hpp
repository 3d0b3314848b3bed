// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "base/errors.hpp"

namespace dmp::scene {

/// A value of a scene with its location in the file. Defaults have no location.
template <class T>
struct Value {
    T value{};
    SourceLocation location;

    Value() = default;
    Value(T v) : value(std::move(v)) {}  // NOLINT(google-explicit-constructor): defaults read as plain values
    Value(T v, SourceLocation p) : value(std::move(v)), location(std::move(p)) {}

    operator const T&() const { return value; }  // NOLINT(google-explicit-constructor): reads as the value itself
    [[nodiscard]] const T& operator*() const { return value; }
    [[nodiscard]] const T* operator->() const { return &value; }
    [[nodiscard]] bool given() const { return location.known(); }
};

}  // namespace dmp::scene
