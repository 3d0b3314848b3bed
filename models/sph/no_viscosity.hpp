// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/simd/vector.hpp"
#include "models/uses.hpp"

namespace dmp::models {

/// A term that is not there: what it is added to stays as it is, at no cost.
struct NoTerm {
    template <class T, int D>
    friend const Vector<T, D>& operator+(const Vector<T, D>& others, const NoTerm& /*none*/) {
        return others;
    }
};

/// No viscous force: of a sweep whose viscous forces are worked out elsewhere.
struct NoViscosity {
    template <class P>
    static NoTerm law(const P& /*pair*/) {
        return {};
    }
};

}  // namespace dmp::models
