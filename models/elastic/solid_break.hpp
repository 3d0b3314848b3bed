// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "base/unlisted_value.hpp"
#include "models/elastic/strain.hpp"

namespace dmp::models {

/// What a face between two cells of a solid bears: means of both cells.
template <int D>
struct FaceState {
    Matrix<D> stress;    ///< Cauchy's [Pa]
    Matrix<D> gradient;  ///< F
    int axis = 0;        ///< of the lattice, across which it lies
};

/// A solid tears across its largest principal tension, where that exceeds a limit: the largest principal Cauchy stress
/// [Pa] (Rankine), or the largest principal stretch minus 1 [-]. The faces between cells are in a few directions only;
/// of a face the load is that of the tensor itself, whatever its direction, so that a solid is as strong at any angle
/// to the lattice, but a face breaks only if faces of no other direction lie more across the tension: with the
/// direction d of tension and the current normals n_k ~ F^-T e_k of the D directions, if |n . d| is the largest of all
/// |n_k . d|, or one of them. Which face of a body breaks first is for `rank`, the load times |n . d|, to say.
struct SolidBreak {
    enum class Criterion { stress, strain };
    Criterion criterion = Criterion::stress;
    double limit = 0;  ///< [Pa] or [-]

    struct Load {
        double excess = -1;  ///< relative: load / limit - 1; it breaks if this is positive
        double rank = 0;     ///< (excess + 1) |n . d|
    };

    /// Excess -1 where the tension is not across the face.
    template <int D>
    [[nodiscard]] Load load(const FaceState<D>& face) const {
        const Eigen::SelfAdjointEigenSolver<Matrix<D>> principal(tensor(face));
        const int largest = D - 1;  // ascending
        const Matrix<D> normals = Matrix<D>(face.gradient.inverse().transpose()).colwise().normalized();
        const Eigen::Matrix<double, D, 1> across =
            (normals.transpose() * principal.eigenvectors().col(largest)).cwiseAbs();
        if (across[face.axis] < (1 - 1e-6) * across.maxCoeff()) return {};
        const double load = value(principal.eigenvalues()[largest]) / limit;
        return {load - 1, load * across[face.axis]};
    }

  private:
    template <int D>
    [[nodiscard]] Matrix<D> tensor(const FaceState<D>& face) const {
        switch (criterion) {
            case Criterion::stress:
                return face.stress;
            case Criterion::strain:
                return face.gradient * face.gradient.transpose();
        }
        unlisted_value(criterion);
    }
    [[nodiscard]] double value(double eigenvalue) const {
        switch (criterion) {
            case Criterion::stress:
                return eigenvalue;
            case Criterion::strain:
                return std::sqrt(eigenvalue) - 1;
        }
        unlisted_value(criterion);
    }
};

}  // namespace dmp::models
