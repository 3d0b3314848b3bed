// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/sph/kernels.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// A smoothing kernel that is chosen at run time, for the loops that all kernels but the default share: they are
/// compiled once in place of once a kernel. The branch is the same for all pairs. `L`, the lanes of the loops, makes it
/// a class of its own for each vector unit.
template <class L, int D>
class AnyKernel {
  public:
    AnyKernel(KernelKind kind, double support)
        : kind_(kind),
          wendland_c2_(support),
          wendland_c4_(support),
          lucy_(support),
          cubic_spline_(support),
          quintic_spline_(support),
          sound_limit(with([](const auto& kernel) { return kernel.sound_limit; })),
          viscous_limit(with([](const auto& kernel) { return kernel.viscous_limit; })) {}

    template <class T>
    [[nodiscard]] T value(const T& r) const {
        return with([&r](const auto& kernel) { return kernel.value(r); });
    }
    template <class T>
    [[nodiscard]] T slope(const T& r) const {
        return with([&r](const auto& kernel) { return kernel.slope(r); });
    }

  private:
    template <class Then>
    auto with(const Then& then) const {
        switch (kind_) {
            case KernelKind::wendland_c2:
                return then(wendland_c2_);
            case KernelKind::wendland_c4:
                return then(wendland_c4_);
            case KernelKind::lucy:
                return then(lucy_);
            case KernelKind::cubic_spline:
                return then(cubic_spline_);
            case KernelKind::quintic_spline:
                return then(quintic_spline_);
        }
        __builtin_unreachable();  // no unlisted_value: its code would be of one vector unit, and shared by all
    }

    KernelKind kind_;
    WendlandC2<D> wendland_c2_;
    WendlandC4<D> wendland_c4_;
    Lucy<D> lucy_;
    CubicSpline<D> cubic_spline_;
    QuinticSpline<D> quintic_spline_;

  public:
    double sound_limit, viscous_limit;  ///< as of the kernels
};

}  // namespace dmp::solver
