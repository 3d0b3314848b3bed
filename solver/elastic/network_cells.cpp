// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Of the SpringNetwork: its cells.
#include <limits>
#include <sstream>

#include "base/errors.hpp"
#include "solver/elastic/implicit_system.hpp"

namespace dmp::solver {

template <int D>
void SpringNetwork<D>::add_cell_forces(const Vectors& position, const Vectors& velocity, Vectors& force) const {
    for (const LocalCell<D>& cell : cells_) {
        const auto corners = cell.of(position);
        const bool crushed = !(cell.element.gradient(corners).determinant() > LocalCell<D>::least_volume);
        if (crushed && !crushed_at_) crushed_at_ = cell.at_centroid(position_);
        const auto forces = cell.forces(corners, cell.of(velocity));
        for (std::size_t k = 0; k < cell.node.size(); ++k)
            for (int axis = 0; axis < D; ++axis)
                force[cell.node[k]][axis] +=
                    crushed ? std::numeric_limits<double>::quiet_NaN() : forces(axis, static_cast<int>(k));
    }
}

template <int D>
void SpringNetwork<D>::refuse_crushed_cells() const {
    if (!crushed_at_) return;
    std::ostringstream problem;
    problem << "a cell of the elastic solid '" << part_ << "' near (";
    for (int axis = 0; axis < D; ++axis) problem << (axis > 0 ? ", " : "") << (*crushed_at_)[axis];
    problem << ") m is pressed to less than a tenth of its volume or turned inside out";
    throw DivergenceError(problem.str(),
                          "the load there is too large for the solid's youngs_modulus: check both, or refine "
                          "particles.spacing; elastic_law = \"neo_hookean\" resists compression");
}

template class SpringNetwork<2>;
template class SpringNetwork<3>;

}  // namespace dmp::solver
