// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/triangle_file.hpp"

#include <limits>
#include <locale>
#include <sstream>

#include "base/safe_file.hpp"

namespace dmp::postproc {

void write_triangles(const std::filesystem::path& file, std::span<const Vec> corners,
                     std::span<const std::array<int, 3>> triangles) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(std::numeric_limits<double>::max_digits10);
    text << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
         << "<PolyData>\n<Piece NumberOfPoints=\"" << corners.size() << "\" NumberOfPolys=\"" << triangles.size()
         << "\">\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
    for (const Vec& corner : corners) text << corner.x() << ' ' << corner.y() << ' ' << corner.z() << '\n';
    text << "</DataArray>\n</Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
    for (const auto& [a, b, c] : triangles) text << a << ' ' << b << ' ' << c << '\n';
    text << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
    for (std::size_t t = 0; t < triangles.size(); ++t) text << 3 * (t + 1) << '\n';
    text << "</DataArray>\n</Polys>\n<CellData>\n<DataArray type=\"Int64\" Name=\"triangle\" format=\"ascii\">\n";
    for (std::size_t t = 0; t < triangles.size(); ++t) text << t << '\n';
    text << "</DataArray>\n</CellData>\n</Piece>\n</PolyData>\n</VTKFile>\n";
    write_file(file, text.str());
}

}  // namespace dmp::postproc
