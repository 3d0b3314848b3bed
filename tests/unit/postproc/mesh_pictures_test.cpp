// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/mesh_pictures.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "postproc/virtual_display.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::mesh_pictures_tests {
namespace {

using ::testing::ElementsAre;

/// A cube or square of fluid, 12 spacings wide, walls on its floor, and a chain of bonds.
MeshView small_mesh(int dimension) {
    MeshView view;
    view.title = "A small mesh";
    view.dimension = dimension;
    view.spacing = 1e-3;
    for (int z = 0; z < (dimension == 3 ? 12 : 1); ++z)
        for (int y = -2; y < 12; ++y)
            for (int x = 0; x < 12; ++x) {
                view.position.emplace_back(1e-3 * x, 1e-3 * y, 1e-3 * z);
                view.kind.push_back(y < 0 ? MeshView::Kind::wall : MeshView::Kind::fluid);
                view.kernel_sum.push_back(1 + 0.01F * static_cast<float>(x - 6));
                view.surface_error.push_back(y == 0 ? 0.1F * static_cast<float>(x - 6)
                                                    : std::numeric_limits<float>::quiet_NaN());
            }
    view.valence.assign(view.position.size(), 0);
    return view;
}

TEST(MeshPictures, AreDrawnOfWhatThereIs) {
    if (const VirtualDisplay display; !display.usable()) GTEST_SKIP() << display.problem();
    for (const int dimension : {2, 3}) {
        const TemporaryFolder folder;
        MeshView view = small_mesh(dimension);
        Pictures pictures = write_mesh_pictures(folder.path(), view, 600);
        EXPECT_EQ(pictures.warning, "");
        EXPECT_THAT(pictures.files, ElementsAre("slices.png", "surface_error.png"));
        const auto first = static_cast<std::int32_t>(view.position.size());
        for (int k = 0; k < 6; ++k) {
            view.position.emplace_back(2e-3 + 1e-3 * k, 5.5e-3, 0);
            view.kind.push_back(MeshView::Kind::solid);
            view.kernel_sum.push_back(1);
            view.surface_error.push_back(std::numeric_limits<float>::quiet_NaN());
            view.valence.push_back(k == 0 || k == 5 ? 1 : 2);
            if (k > 0) view.bond_ends.insert(view.bond_ends.end(), {first + k - 1, first + k});
        }
        pictures = write_mesh_pictures(folder.path(), view, 600);
        EXPECT_EQ(pictures.warning, "");
        EXPECT_THAT(pictures.files, ElementsAre("slices.png", "surface_error.png", "valence.png"));
        for (const std::string& file : pictures.files)
            EXPECT_GT(std::filesystem::file_size(folder.path() / file), 2000U) << file;
    }
}

}  // namespace
}  // namespace dmp::tests::mesh_pictures_tests
