// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/particle_view.hpp"

#include <algorithm>

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

namespace dmp {

namespace {

constexpr double least_line_width = 2.2;  // [pixels], so that thin solids stay visible on large domains
constexpr int oversampling = 2;           // drawn larger and averaged: smooth edges on every driver

/// A filled disc. The depth grows from its centre, so that where discs overlap the nearest centre wins
/// and a dense set shows no scales and no gaps.
constexpr const char* disc_shader = R"(
//VTK::Color::Impl
float disc_distance2 = dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy);
if (disc_distance2 > 1.0) { discard; }
gl_FragDepth = gl_FragCoord.z + 0.02 * disc_distance2;
)";

vtkSmartPointer<vtkPoints> points_at_height(const std::vector<float>& position, float height) {
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(static_cast<vtkIdType>(position.size() / 3));
    float* values = coordinates->GetPointer(0);
    std::copy(position.begin(), position.end(), values);
    for (std::size_t i = 2; i < position.size(); i += 3) values[i] = height;
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

void add_discs(vtkRenderer* renderer, const ParticleLayer& layer, float height) {
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetName("colour");
    colours->SetNumberOfComponents(3);
    colours->SetNumberOfTuples(static_cast<vtkIdType>(layer.colour.size()));
    unsigned char* value = colours->GetPointer(0);
    for (const Colour& colour : layer.colour) {
        *value++ = colour.red;
        *value++ = colour.green;
        *value++ = colour.blue;
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_at_height(layer.position, height));
    data->GetPointData()->SetScalars(colours);
    vtkNew<vtkPointGaussianMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetColorModeToDirectScalars();
    mapper->EmissiveOff();
    mapper->SetScaleFactor(layer.radius);
    mapper->SetSplatShaderCode(disc_shader);
    mapper->SetTriangleScale(1.0F);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    set_flat(actor->GetProperty(), colours::white);
    renderer->AddActor(actor);
}

void add_lines(vtkRenderer* renderer, const ParticleLayer& layer, float height, double pixels_per_metre) {
    vtkNew<vtkTypeInt32Array> ends;
    ends->SetNumberOfValues(static_cast<vtkIdType>(layer.lines.size()));
    std::copy(layer.lines.begin(), layer.lines.end(), ends->GetPointer(0));
    vtkNew<vtkCellArray> lines;
    lines->SetData(2, ends);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_at_height(layer.position, height));
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

/// Averages squares of pixels; VTK counts rows from below.
Image shrink(const unsigned char* pixels, int width, int height) {
    Image image{width, height,
                std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
    const std::size_t stride = 3 * static_cast<std::size_t>(width) * oversampling;
    std::size_t out = 0;
    for (int row = height - 1; row >= 0; --row)
        for (int column = 0; column < width; ++column)
            for (std::size_t channel = 0; channel < 3; ++channel) {
                unsigned sum = 0;
                for (int k = 0; k < oversampling * oversampling; ++k)
                    sum += pixels[static_cast<std::size_t>(row * oversampling + k / oversampling) * stride +
                                  3 * static_cast<std::size_t>(column * oversampling + k % oversampling) + channel];
                image.rgb[out++] = static_cast<std::uint8_t>((sum + 2) / (oversampling * oversampling));
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
    const double step = area.extent().y();  // between layers: any length will do, this one has the right magnitude
    const double pixels_per_metre = oversampling * height / area.extent().y();
    double z = 0;
    for (const ParticleLayer& layer : layers) {
        if (!layer.position.empty()) add_discs(renderer, layer, static_cast<float>(z));
        z += step;
        if (!layer.lines.empty()) add_lines(renderer, layer, static_cast<float>(z), pixels_per_metre);
        z += step;
    }
    const Vec centre = (area.low + area.high) / 2;
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(area.extent().y() / 2);
    camera->SetFocalPoint(centre.x(), centre.y(), 0);
    camera->SetPosition(centre.x(), centre.y(), z + step);
    camera->SetClippingRange(step / 2, z + 2 * step);

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

}  // namespace dmp
