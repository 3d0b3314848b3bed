// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Runs that go wrong on purpose must be found out soon, and say what went wrong.
#include <cmath>
#include <filesystem>
#include <optional>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "geometry/geometry.hpp"
#include "mesher/mesh.hpp"
#include "scene/read_scene.hpp"
#include "solver/simulation.hpp"

namespace dmp {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

struct Case {
    Scene scene;
    ParticleSet particles;
};

Case vein_valve(std::vector<std::string> overrides) {
    overrides.insert(overrides.begin(), {"particles.spacing=\"0.5 mm\"", "output.measure_every=\"1 s\"",
                                         "output.fields=[\"velocity\", \"density\"]"});
    Case made;
    made.scene = read_scene(DMP_SOURCE_DIR "/cases/vein_valve", overrides);
    DrawingOptions drawing;
    drawing.file = (std::filesystem::path(made.scene.directory) / made.scene.geometry.file.value).string();
    drawing.unit = made.scene.geometry.unit;
    drawing.chord_error = 1e-3 * made.scene.particles.spacing;
    for (const auto& [name, value] : made.scene.geometry.parameters) drawing.parameters[name] = value;
    made.particles = mesh(read_drawing(drawing), made.scene).particles;
    return made;
}

/// Keeps the step of the first frame with a bad particle in it and that of the last frame.
class FirstBad : public FrameSink {
  public:
    FirstBad(double sound_speed, double rest_density, double margin)
        : sound_speed_(sound_speed), rest_density_(rest_density), margin_(margin) {}
    void write(const Frame& frame) override {
        last = frame.step;
        if (first) return;
        for (const FrameGroup& group : frame.groups) {
            if (group.name == "walls") continue;
            for (std::size_t i = 0; i < group.size(); ++i) {
                if (is_bad(frame, group, i)) {
                    first = frame.step;
                    return;
                }
            }
        }
    }
    std::optional<long> first;
    long last = 0;

  private:
    [[nodiscard]] bool is_bad(const Frame&, const FrameGroup& group, std::size_t i) const;
    double sound_speed_, rest_density_, margin_;
};

}  // namespace
}  // namespace dmp
