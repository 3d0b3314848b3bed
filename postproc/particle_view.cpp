// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/particle_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

namespace dmp::postproc {

namespace {

constexpr double least_line_width = 2.2;  // [pixels], so that thin solids remain visible in large domains
constexpr double wall_opacity = 0.4;
constexpr int oversampling = 2;  // rendered larger and averaged: smooth edges with every driver

constexpr double disc_depth = 0.02;  // from a disc's centre to its rim [depth ranges of the picture]

/// A filled disc. The depth increases from its centre, so that where discs overlap the nearest centre is visible and
/// dense particles show no gaps or overlapping rims.
std::string disc_shader() {
    std::array<char, 256> text{};
    std::snprintf(text.data(), text.size(), R"(
//VTK::Color::Impl
float disc_distance2 = dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy);
if (disc_distance2 > 1.0) { discard; }
gl_FragDepth = gl_FragCoord.z + %.3f * disc_distance2;
)",
                  disc_depth);
    return text.data();
}

/// The front of a sphere in parallel projection, lit from the upper left. The radius in pixels is the inverse of the
/// gradient of the offset, which is 1 at the rim.
std::string sphere_shader(double depth_per_pixel) {
    std::array<char, 640> text{};
    std::snprintf(text.data(), text.size(), R"(
//VTK::Color::Impl
vec2 sphere_offset = offsetVCVSOutput.xy;
float sphere_distance2 = dot(sphere_offset, sphere_offset);
float sphere_pixels = 1.0 / max(length(vec2(dFdx(sphere_offset.x), dFdy(sphere_offset.x))), 1e-6);
if (sphere_distance2 > 1.0) { discard; }
float sphere_height = sqrt(1.0 - sphere_distance2);
gl_FragDepth = gl_FragCoord.z - %.9e * sphere_height * sphere_pixels;
ambientColor *= 0.4 + 0.6 * max(0.0, dot(vec3(sphere_offset, sphere_height), vec3(-0.35, 0.45, 0.82)));
)",
                  depth_per_pixel);
    return text.data();
}

/// All points at one height, or at their own z.
vtkSmartPointer<vtkPoints> points_at(const std::vector<float>& position, std::optional<float> height) {
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(static_cast<vtkIdType>(position.size() / 3));
    float* values = coordinates->GetPointer(0);
    std::copy(position.begin(), position.end(), values);
    if (height)
        for (std::size_t i = 2; i < position.size(); i += 3) values[i] = *height;
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetData(coordinates);
    return points;
}

void set_flat(vtkProperty* property, Colour colour) {
    property->LightingOff();
    property->SetAmbient(1);
    property->SetDiffuse(0);
    property->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
}

vtkSmartPointer<vtkUnsignedCharArray> colours_of(const ParticleLayer& layer) {
    auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colours->SetName("colour");
    colours->SetNumberOfComponents(3);
    colours->SetNumberOfTuples(static_cast<vtkIdType>(layer.colour.size()));
    unsigned char* value = colours->GetPointer(0);
    for (const Colour& colour : layer.colour) {
        *value++ = colour.red;
        *value++ = colour.green;
        *value++ = colour.blue;
    }
    return colours;
}

/// Spheres as discs with the shading and the depth of a sphere.
void add_spheres(vtkRenderer* renderer, const ParticleLayer& layer, double depth_per_pixel) {
    vtkNew<vtkFloatArray> radii;
    radii->SetName("radius");
    radii->SetNumberOfTuples(static_cast<vtkIdType>(layer.radii.size()));
    std::copy(layer.radii.begin(), layer.radii.end(), radii->GetPointer(0));
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_at(layer.position, {}));
    data->GetPointData()->SetScalars(colours_of(layer));
    data->GetPointData()->AddArray(radii);
    vtkNew<vtkPointGaussianMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetColorModeToDirectScalars();
    mapper->EmissiveOff();
    mapper->SetScaleArray("radius");
    mapper->SetScaleFactor(1);
    mapper->SetSplatShaderCode(sphere_shader(depth_per_pixel).c_str());
    mapper->SetTriangleScale(1.0F);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    set_flat(actor->GetProperty(), colours::white);
    renderer->AddActor(actor);
}

void add_triangles(vtkRenderer* renderer, const ParticleLayer& layer) {
    vtkNew<vtkTypeInt32Array> corners;
    corners->SetNumberOfValues(static_cast<vtkIdType>(layer.triangles.size()));
    std::copy(layer.triangles.begin(), layer.triangles.end(), corners->GetPointer(0));
    vtkNew<vtkCellArray> triangles;
    triangles->SetData(3, corners);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_at(layer.position, {}));
    data->SetPolys(triangles);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    set_flat(actor->GetProperty(), layer.colour.empty() ? colours::wall : layer.colour.front());
    actor->GetProperty()->SetOpacity(wall_opacity);
    renderer->AddActor(actor);
}

/// Discs at a height above the last layer. A particle in front of or behind the plane z = 0 is lowered as much as a
/// disc is at that distance from its centre: at every point of the plane, the nearest particle in 3-D is visible.
void add_discs(vtkRenderer* renderer, const ParticleLayer& layer, std::optional<float> height, double depth) {
    vtkNew<vtkPolyData> data;
    const auto points = points_at(layer.position, height);
    if (height && layer.radius > 0)
        for (std::size_t i = 0; 3 * i < layer.position.size(); ++i) {
            const double away = std::min(std::abs(layer.position[3 * i + 2]) / layer.radius, 1.0);
            if (away == 0) continue;
            double* position = points->GetPoint(static_cast<vtkIdType>(i));
            points->SetPoint(static_cast<vtkIdType>(i), position[0], position[1],
                             *height - disc_depth * depth * away * away);
        }
    data->SetPoints(points);
    data->GetPointData()->SetScalars(colours_of(layer));
    vtkNew<vtkPointGaussianMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetColorModeToDirectScalars();
    mapper->EmissiveOff();
    mapper->SetScaleFactor(layer.radius);
    mapper->SetSplatShaderCode(disc_shader().c_str());
    mapper->SetTriangleScale(1.0F);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    set_flat(actor->GetProperty(), colours::white);
    renderer->AddActor(actor);
}

void add_lines(vtkRenderer* renderer, const ParticleLayer& layer, std::optional<float> height,
               double pixels_per_metre) {
    vtkNew<vtkTypeInt32Array> ends;
    ends->SetNumberOfValues(static_cast<vtkIdType>(layer.lines.size()));
    std::copy(layer.lines.begin(), layer.lines.end(), ends->GetPointer(0));
    vtkNew<vtkCellArray> lines;
    lines->SetData(2, ends);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_at(layer.position, height));
    data->SetLines(lines);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    set_flat(actor->GetProperty(), layer.line_colour);
    actor->GetProperty()->SetLineWidth(
        static_cast<float>(std::max(layer.line_width * pixels_per_metre, least_line_width * oversampling)));
    renderer->AddActor(actor);
}

/// The smallest and the largest z of all layers, including the radius of spheres.
std::pair<double, double> depth_of(const std::vector<ParticleLayer>& layers) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const ParticleLayer& layer : layers)
        for (std::size_t i = 0; 3 * i < layer.position.size(); ++i) {
            const double z = layer.position[3 * i + 2], radius = layer.radii.empty() ? 0 : layer.radii[i];
            if (!std::isfinite(z)) continue;
            low = std::min(low, z - radius);
            high = std::max(high, z + radius);
        }
    return low > high ? std::pair(0.0, 0.0) : std::pair(low, high);
}

/// Averages squares of pixels; VTK numbers rows from the bottom.
Image shrink(const unsigned char* pixels, int width, int height) {
    Image image{width, height,
                std::vector<std::uint32_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
    const std::size_t stride = 3 * static_cast<std::size_t>(width) * oversampling;
    std::size_t out = 0;
    for (int row = height - 1; row >= 0; --row)
        for (int column = 0; column < width; ++column, ++out)
            for (std::size_t channel = 0; channel < 3; ++channel) {
                unsigned sum = 0;
                for (int k = 0; k < oversampling * oversampling; ++k)
                    sum += pixels[static_cast<std::size_t>(row * oversampling + k / oversampling) * stride +
                                  3 * static_cast<std::size_t>(column * oversampling + k % oversampling) + channel];
                image.pixels[out] = image.pixels[out] << 8 | (sum + 2) / (oversampling * oversampling);
            }
    return image;
}

}  // namespace

struct ParticleView::Window {
    vtkNew<vtkRenderWindow> window;
};

ParticleView::ParticleView() : window_(std::make_unique<Window>()) {
    window_->window->SetOffScreenRendering(1);
    window_->window->SetMultiSamples(0);
}

ParticleView::~ParticleView() = default;

Image ParticleView::draw(const std::vector<ParticleLayer>& layers, const Box& area, int width, int height) {
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    const double step = area.extent().y();  // between layers; any length of the right magnitude
    const double pixels_per_metre = oversampling * height / area.extent().y();
    const bool in_space = std::ranges::any_of(layers, [](const ParticleLayer& layer) { return !layer.radii.empty(); });
    double bottom = 0, z = 0;
    if (in_space) std::tie(bottom, z) = depth_of(layers);
    const double top = in_space ? z : 2 * step * static_cast<double>(layers.size()), depth = top - bottom + 1.5 * step;
    const auto next_height = [&] {
        const double before = std::exchange(z, z + step);
        return in_space ? std::nullopt : std::optional(static_cast<float>(before));
    };
    for (const ParticleLayer& layer : layers) {
        const auto height_of_discs = next_height();
        if (!layer.radii.empty())
            add_spheres(renderer, layer, 1 / (pixels_per_metre * depth));
        else if (!layer.triangles.empty())
            add_triangles(renderer, layer);
        else if (!layer.position.empty())
            add_discs(renderer, layer, height_of_discs, depth);
        const auto height_of_lines = next_height();
        if (!layer.lines.empty()) add_lines(renderer, layer, height_of_lines, pixels_per_metre);
    }
    const Vec centre = (area.low + area.high) / 2;
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(area.extent().y() / 2);
    camera->SetFocalPoint(centre.x(), centre.y(), bottom);
    camera->SetPosition(centre.x(), centre.y(), top + step);
    camera->SetClippingRange(step / 2, step / 2 + depth);

    vtkRenderWindow* window = window_->window;
    window->AddRenderer(renderer);
    window->SetSize(oversampling * width, oversampling * height);
    window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetPixelData(0, 0, oversampling * width - 1, oversampling * height - 1, 0, pixels);
    renderer->ReleaseGraphicsResources(window);
    window->RemoveRenderer(renderer);
    if (pixels->GetNumberOfValues() != 3 * vtkIdType{oversampling} * width * oversampling * height) return {};
    return shrink(pixels->GetPointer(0), width, height);
}

}  // namespace dmp::postproc
