// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/forcing/driving_models.hpp"

#include "base/nearest_name.hpp"

namespace dmp::solver {

void add_driving_models(std::vector<ModelUse>& models, const Scene& scene) {
    for (const Expression& axis : scene.flow.acceleration)
        if (!axis.is_zero()) models.push_back({"body acceleration", axis.text(), "flow.acceleration"});
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (const Expression& gradient = (*scene.flow.pressure_gradient)[axis]; !gradient.is_zero())
            models.push_back({std::string("pressure gradient along ") + "xyz"[axis],
                              gradient.text() + ", on the fluid and the elastic solids in it",
                              "flow.pressure_gradient"});
    for (const ForceOnPart& force : scene.forces)
        models.push_back({"force on '" + *force.part + "'",
                          *force.amount == ForceAmount::total ? "total, spread evenly over its particles"
                                                              : "on each of its particles",
                          "force '" + *force.name + "' at " + force.name.location.text()});
    for (const MovingShape& shape : scene.moving_shapes)
        models.push_back({"moving " + to_string(*shape.kind),
                          "f = K (1 + cos(pi d / r*)), felt by " + quoted_list(*shape.parts),
                          "moving_shape '" + *shape.name + "' at " + shape.name.location.text()});
}

}  // namespace dmp::solver
