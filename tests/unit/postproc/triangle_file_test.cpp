// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/triangle_file.hpp"

#include <vector>

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "base/errors.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::triangle_file_tests {
namespace {

TEST(TriangleFile, is_what_vtk_reads_back) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "bad_triangles.vtp";
    const std::vector<Vec> corners{{0, 0, 0}, {0.1, 0, 0}, {0, 1.0 / 3, 0}, {0, 0, -1e-7}};
    const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {0, 3, 1}};
    write_triangles(file, corners, triangles);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkPolyData* read = reader->GetOutput();
    ASSERT_EQ(read->GetNumberOfPoints(), 4);
    ASSERT_EQ(read->GetNumberOfCells(), 2);
    for (int k = 0; k < 4; ++k) {
        const double* position = read->GetPoint(k);
        EXPECT_EQ(Vec(position[0], position[1], position[2]), corners[static_cast<std::size_t>(k)]);
    }
    EXPECT_EQ(read->GetCell(1)->GetPointId(1), 3);
    EXPECT_EQ(read->GetCellData()->GetArray("triangle")->GetTuple1(1), 1);
}

TEST(TriangleFile, that_cannot_be_written_is_an_error) {
    EXPECT_THROW(write_triangles("/nowhere/at/all.vtp", {}, {}), ResourceError);
}

}  // namespace
}  // namespace dmp::tests::triangle_file_tests
