// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/simd/vector.hpp"
#include "models/uses.hpp"

namespace dmp::models {

/// An absent term: adding it leaves the other terms unchanged, at no cost.
struct NoTerm {
    template <class T, int D>
    friend const Vector<T, D>& operator+(const Vector<T, D>& others, const NoTerm& /*none*/) {
        return others;
    }
};

/// No viscous force, for sweeps whose viscous forces are computed elsewhere.
struct NoViscosity {
    static constexpr bool needs_gradient = false;

    template <class P>
    static NoTerm law(const P& /*pair*/) {
        return {};
    }
};

}  // namespace dmp::models
