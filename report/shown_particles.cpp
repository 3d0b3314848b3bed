// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/shown_particles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "report/even_choice.hpp"
#include "report/html.hpp"
#include "report/left_out.hpp"
#include "report/particle_plan.hpp"

namespace dmp::report {

namespace {

constexpr double most_particles_read = 20e6;  // of all frames together: about a minute

/// How the names of the fields that are shown begin.
constexpr std::array<std::string_view, 6> shown_fields{"velocity",      "pressure",       "von_mises",
                                                       "concentration", "residence_time", "displacement"};

bool is_shown(const FrameField& field) {
    return (field.components == 1 || field.components == 3) &&
           std::ranges::any_of(shown_fields, [&](std::string_view name) { return field.name.starts_with(name); });
}

std::string shown_name(const FrameField& field) { return field.name == "velocity" ? "speed" : field.name; }

/// Of some particles: the value, or the magnitude of a vector.
std::vector<float> values_of(const FrameField& field, const std::vector<std::size_t>& particles) {
    std::vector<float> values;
    values.reserve(particles.size());
    for (const std::size_t i : particles) {
        const float* v = &field.values[static_cast<std::size_t>(field.components) * i];
        values.push_back(field.components == 1 ? v[0] : std::hypot(v[0], v[1], v[2]));
    }
    return values;
}

ShownGroup empty_group(const FrameGroup& group, std::size_t every) {
    ShownGroup shown{group.name, every, {}, group.triangles, {}};
    for (const FrameField& field : group.fields)
        if (is_shown(field)) shown.fields.push_back({shown_name(field), field.unit});
    return shown;
}

GroupAtTime taken(const FrameGroup& group, const std::vector<std::size_t>& particles, const ShownGroup& shown) {
    GroupAtTime at;
    at.position.reserve(3 * particles.size());
    for (const std::size_t i : particles)
        at.position.insert(at.position.end(), &group.position[3 * i], &group.position[3 * i] + 3);
    for (const FrameField& field : group.fields)
        if (field.name == "radius" && group.name == "spheres") at.radius = values_of(field, particles);
    for (const ShownField& field : shown.fields) {
        const auto found = std::ranges::find_if(
            group.fields, [&](const FrameField& candidate) { return shown_name(candidate) == field.name; });
        at.values.push_back(found != group.fields.end()
                                ? values_of(*found, particles)
                                : std::vector<float>(particles.size(), std::numeric_limits<float>::quiet_NaN()));
    }
    return at;
}

bool is_flat(const FrameGroup& group) {
    for (std::size_t i = 0; i < group.size(); ++i)
        if (group.position[3 * i + 2] != group.position[2]) return false;
    return true;
}

/// Reads the frames of a run one after the other.
class Reading {
  public:
    Reading(const FrameSource& source, std::size_t bytes) : source_(source), bytes_(bytes) {
        shown_.frames_of_run = source.times().size();
    }

    ShownParticles result() {
        std::optional<Frame> sample;
        for (std::size_t k = 0; k < shown_.frames_of_run && !sample; ++k) sample = read(k);
        if (!sample) {
            note_damaged();
            return std::move(shown_);
        }
        damaged_.clear();
        shown_.spacing = sample->spacing;
        read_walls();
        plan(*sample);
        if (walls_) add_walls();
        for (const std::size_t k : evenly_spaced(plan_.frames, shown_.frames_of_run))
            if (const auto frame = read(k)) add(*frame);
        note_damaged();
        for (ShownGroup& group : shown_.groups)
            if (group.name != "walls") group.at.resize(shown_.times.size());
        leave_out_far(shown_);
        return std::move(shown_);
    }

  private:
    std::optional<Frame> read(std::size_t number) {
        try {
            return source_.read(number);
        } catch (const InputError& error) {
            damaged_.push_back(fmt::format("the frame at {} is left out of the particles: {} ({})",
                                           number_text(source_.times()[number], "s"), error.problem(),
                                           error.where().text()));
            return std::nullopt;
        }
    }

    void note_damaged() {
        constexpr std::size_t most_notes = 3;
        if (damaged_.size() > most_notes)
            damaged_[most_notes] =
                fmt::format("and {} more frames are left out of the particles", damaged_.size() - most_notes);
        damaged_.resize(std::min(damaged_.size(), most_notes + 1));
        shown_.notes.insert(shown_.notes.end(), damaged_.begin(), damaged_.end());
    }

    void read_walls() {
        try {
            walls_ = source_.walls();
        } catch (const InputError& error) {
            shown_.notes.push_back("the walls are left out of the particles: " + error.problem() + " (" +
                                   error.where().text() + ")");
        }
    }

    /// A surface cannot be thinned out: a quarter of the bytes holds it, or it is left out.
    bool has_place(const FrameGroup& group, std::size_t frames) {
        const std::size_t needed =
            frames * 3 * sizeof(std::uint16_t) * group.size() + sizeof(std::int32_t) * group.triangles.size();
        if (group.triangles.empty() || needed <= bytes_ / 4) return true;
        shown_.notes.push_back(
            fmt::format("the surface of the {} is left out of the particles: its {} triangles would take {:.1f} MB "
                        "of the page",
                        group.name == "walls" ? "walls" : "moving walls", group.triangles.size() / 3,
                        static_cast<double>(needed) / 1e6));
        return false;
    }

    void plan(const Frame& sample) {
        bool flat = !walls_ || is_flat(*walls_);
        std::size_t particles = walls_ ? walls_->size() : 0;
        for (const FrameGroup& group : sample.groups) {
            flat = flat && is_flat(group);
            particles += group.size();
        }
        ParticleBytes all;
        if (walls_ && !has_place(*walls_, 1)) walls_.reset();
        if (walls_) all.once = bytes_of(empty_group(*walls_, 1), walls_->size(), flat);
        for (const FrameGroup& group : sample.groups) {
            if (!has_place(group, std::min(enough_frames_shown, shown_.frames_of_run))) {
                without_.push_back(group.name);
                continue;
            }
            (group.name == "solid" || !group.triangles.empty() ? all.solid_frame : all.thinned_frame) +=
                bytes_of(empty_group(group, 1), group.size(), flat);
        }
        const double most = most_particles_read / static_cast<double>(std::max<std::size_t>(particles, 1));
        plan_ = plan_particles(all, shown_.frames_of_run, static_cast<std::size_t>(std::max(2.0, most)), bytes_);
    }

    [[nodiscard]] std::size_t every_of(const FrameGroup& group) const {
        if (!group.triangles.empty()) return 1;
        return group.name == "solid" ? plan_.every_solid : plan_.every;
    }

    void add_walls() {
        ShownGroup shown = empty_group(*walls_, every_of(*walls_));
        shown.at.push_back(taken(*walls_, EvenChoice(shown.every).of(*walls_), shown));
        shown_.groups.push_back(std::move(shown));
        walls_.reset();
    }

    void add(const Frame& frame) {
        shown_.times.push_back(frame.time);
        for (const FrameGroup& group : frame.groups) {
            if (std::ranges::find(without_, group.name) != without_.end()) continue;
            auto shown = std::ranges::find(shown_.groups, group.name, &ShownGroup::name);
            if (shown == shown_.groups.end()) {
                shown_.groups.push_back(empty_group(group, every_of(group)));
                shown = shown_.groups.end() - 1;
                choices_.try_emplace(group.name, shown->every);
            }
            shown->at.resize(shown_.times.size());
            shown->at.back() = taken(group, choices_.at(group.name).of(group), *shown);
        }
    }

    const FrameSource& source_;
    std::size_t bytes_;
    ShownParticles shown_;
    ParticlePlan plan_;
    std::optional<FrameGroup> walls_;
    std::map<std::string, EvenChoice> choices_;
    std::vector<std::string> damaged_, without_;
};

}  // namespace

ShownParticles read_shown_particles(const FrameSource& source, std::size_t bytes) {
    return Reading(source, bytes).result();
}

std::size_t bytes_of(const ShownGroup& group, std::size_t particles, bool flat) {
    const std::size_t axes = flat ? 2 : 3;
    const std::size_t radius = group.name == "spheres" ? 1 : 0;
    return particles * (sizeof(std::uint16_t) * (axes + radius) + group.fields.size()) +
           sizeof(std::int32_t) * group.triangles.size();
}

bool is_flat(const ShownParticles& particles) {
    std::optional<float> z;
    for (const ShownGroup& group : particles.groups)
        for (const GroupAtTime& at : group.at)
            for (std::size_t i = 0; i < at.size(); ++i) {
                if (!z) z = at.position[2];
                if (at.position[3 * i + 2] != *z) return false;
            }
    return true;
}

}  // namespace dmp::report
