// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/unlisted_value.hpp"
#include "scene/choices.hpp"

namespace dmp::scene {

/// Whether numerics.scheme = "corrected" takes this kernel. The loops of that scheme are compiled for these only.
constexpr bool has_corrected_scheme(KernelKind kernel) {
    switch (kernel) {
        case KernelKind::wendland_c2:
            return true;
        case KernelKind::wendland_c4:
        case KernelKind::lucy:
        case KernelKind::cubic_spline:
        case KernelKind::quintic_spline:
            return false;  // from a lattice, vortices lost a third of their energy or diverged (docs/scheme.md)
    }
    unlisted_value(kernel);
}

}  // namespace dmp::scene
