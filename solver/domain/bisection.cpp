// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/domain/bisection.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

#include <zoltan.h>

#include "base/errors.hpp"
#include "solver/parallel/communicator.hpp"

namespace dmp::solver {

namespace {

// Callbacks for Zoltan. Points are identified by their index.

/// Zoltan passes our callbacks a non-const pointer to a const pointer.
const WeightedPoints& points_behind(void* data) { return **static_cast<const WeightedPoints**>(data); }

int count_points(void* data, int* error) {
    *error = ZOLTAN_OK;
    return static_cast<int>(points_behind(data).weights.size());
}

void list_points(void* data, int /*global words*/, int /*local words*/, ZOLTAN_ID_PTR global, ZOLTAN_ID_PTR /*local*/,
                 int /*weights a point*/, float* weights, int* error) {
    const WeightedPoints& points = points_behind(data);
    std::copy(points.weights.begin(), points.weights.end(), weights);
    for (std::size_t k = 0; k < points.weights.size(); ++k) global[k] = static_cast<ZOLTAN_ID_TYPE>(k);
    *error = ZOLTAN_OK;
}

int dimension_of(void* data, int* error) {
    *error = ZOLTAN_OK;
    return points_behind(data).dimension;
}

void coordinates_of(void* data, int /*global words*/, int /*local words*/, int /*points*/, ZOLTAN_ID_PTR /*global*/,
                    ZOLTAN_ID_PTR /*local*/, int /*dimension*/, double* coordinates, int* error) {
    const WeightedPoints& points = points_behind(data);
    std::copy(points.coordinates.begin(), points.coordinates.end(), coordinates);
    *error = ZOLTAN_OK;
}

void check(int result, const char* step) {
    if (result == ZOLTAN_OK || result == ZOLTAN_WARN) return;
    throw ResourceError(std::string("Zoltan could not divide space among the ranks (") + step + ")",
                        result == ZOLTAN_MEMERR ? "It ran out of memory: use fewer particles or more machines."
                                                : "Run on one rank, and please report it with the scene.");
}

/// Zoltan represents infinity by the largest double.
double position(double bound) {
    constexpr double most = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
    return bound >= most ? infinity : bound <= -most ? -infinity : bound;
}

}  // namespace

std::vector<Box> bisect(const Ranks& ranks, const WeightedPoints& points) {
    float version = 0;
    check(Zoltan_Initialize(0, nullptr, &version), "starting");
    const std::unique_ptr<Zoltan_Struct, void (*)(Zoltan_Struct*)> zoltan(
        Zoltan_Create(ranks.communicator().handle), [](Zoltan_Struct* held) { Zoltan_Destroy(&held); });
    if (!zoltan) check(ZOLTAN_MEMERR, "starting");

    constexpr std::array<std::pair<const char*, const char*>, 10> settings{{
        {"DEBUG_LEVEL", "0"},  // first, as Zoltan reports the other settings
        {"LB_METHOD", "RCB"},
        {"KEEP_CUTS", "1"},
        {"RCB_RECTILINEAR_BLOCKS", "0"},
        {"AVERAGE_CUTS", "1"},  // halfway between particles, not through one
        {"RETURN_LISTS", "NONE"},
        {"OBJ_WEIGHT_DIM", "1"},
        {"NUM_LID_ENTRIES", "0"},
        {"REMAP", "0"},  // box k belongs to rank k
        {"IMBALANCE_TOL", "1.001"},
    }};
    for (const auto& [name, value] : settings) check(Zoltan_Set_Param(zoltan.get(), name, value), name);
    const WeightedPoints* data = &points;
    check(Zoltan_Set_Num_Obj_Fn(zoltan.get(), count_points, &data), "points");
    check(Zoltan_Set_Obj_List_Fn(zoltan.get(), list_points, &data), "points");
    check(Zoltan_Set_Num_Geom_Fn(zoltan.get(), dimension_of, &data), "points");
    check(Zoltan_Set_Geom_Multi_Fn(zoltan.get(), coordinates_of, &data), "points");

    int changed = 0, global_words = 0, local_words = 0, imports = 0, exports = 0;
    ZOLTAN_ID_PTR import_global = nullptr, import_local = nullptr, export_global = nullptr, export_local = nullptr;
    int *import_ranks = nullptr, *import_parts = nullptr, *export_ranks = nullptr, *export_parts = nullptr;
    check(Zoltan_LB_Partition(zoltan.get(), &changed, &global_words, &local_words, &imports, &import_global,
                              &import_local, &import_ranks, &import_parts, &exports, &export_global, &export_local,
                              &export_ranks, &export_parts),
          "bisecting");

    std::vector<Box> boxes(static_cast<std::size_t>(ranks.size()));
    for (int rank = 0; Box & box : boxes) {
        int dimension = 0;
        double *low = box.low.data(), *high = box.high.data();
        check(Zoltan_RCB_Box(zoltan.get(), rank++, &dimension, low, low + 1, low + 2, high, high + 1, high + 2),
              "boxes");
        for (int axis = 0; axis < 3; ++axis) {
            box.low[axis] = position(box.low[axis]);
            box.high[axis] = position(box.high[axis]);
        }
    }
    return boxes;
}

}  // namespace dmp::solver
