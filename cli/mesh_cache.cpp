// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh_cache.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <sstream>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "base/text_hash.hpp"
#include "cli/particle_input.hpp"
#include "cli/uses.hpp"
#include "mesher/geometry_options.hpp"
#include "mesher/mesh_spheres.hpp"
#include "particles/particle_file.hpp"

namespace dmp::cli {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

/// Words of gmsh's scripts that bring in other files, of which the cache knows nothing.
constexpr std::array including{"Merge", "Include", "ShapeFromFile"};

bool brings_in_others(const fs::path& cad_geometry, const std::string& text) {
    const std::string ending = cad_geometry.extension().string();
    if (ending != ".geo" && ending != ".geo_unrolled") return false;
    return std::ranges::any_of(including, [&](const char* word) { return text.find(word) != std::string::npos; });
}

/// This program as it is now: another build may mesh otherwise.
std::string program_text() {
    std::error_code none;
    const fs::path program = fs::read_symlink("/proc/self/exe", none);
    const auto size = fs::file_size(program, none);
    const auto written = fs::last_write_time(program, none).time_since_epoch().count();
    return fmt::format("program {} bytes, written at {}", size, written);
}

/// All that the particles depend on, a line each; empty where that is not known.
std::vector<std::string> lines_behind(const Scene& scene) {
    if (is_of_spheres(scene) || scene.geometry.file->empty()) return {};
    const fs::path cad_geometry = geometry_options_of(scene).file;
    std::error_code none;
    if (!fs::is_regular_file(cad_geometry, none)) return {};  // who reads it says what is wrong with it
    const std::string text = read_file(cad_geometry);
    if (brings_in_others(cad_geometry, text)) return {};
    std::vector<std::string> lines = values_behind_particles(scene);
    lines.push_back(fmt::format("geometry {:016x} {}", text_hash(text), cad_geometry.extension().string()));
    lines.push_back(program_text());
    return lines;
}

/// While it lives, no other process writes into this cache: two that have made the same particles would write under the
/// same unfinished name. Without a lock (a file system that has none) they may; who reads then finds damage, and makes
/// the particles anew.
class WritingAlone {
  public:
    explicit WritingAlone(const fs::path& folder)
        : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        if (folder_ >= 0) ::flock(folder_, LOCK_EX);
    }
    ~WritingAlone() {
        if (folder_ >= 0) ::close(folder_);
    }
    WritingAlone(const WritingAlone&) = delete;
    WritingAlone& operator=(const WritingAlone&) = delete;

  private:
    int folder_;
};

fs::path with_ending(const fs::path& name, const char* ending) { return fs::path(name).concat(ending); }

}  // namespace

std::optional<fs::path> MeshCache::users_folder() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return fs::path(value != nullptr ? value : "");
    };
    if (const fs::path caches = variable("XDG_CACHE_HOME"); caches.is_absolute()) return caches / "dmp" / "particles";
    if (const fs::path home = variable("HOME"); home.is_absolute()) return home / ".cache" / "dmp" / "particles";
    return std::nullopt;
}

std::optional<fs::path> MeshCache::name_of(const std::vector<std::string>& lines) const {
    if (!folder_ || lines.empty()) return std::nullopt;
    std::string all;
    for (const std::string& line : lines) all += line + "\n";
    return *folder_ / fmt::format("{:016x}", text_hash(all));
}

std::optional<ParticlesWithOrigin> MeshCache::find(const Scene& scene) const {
    const std::vector<std::string> lines = lines_behind(scene);
    const auto name = name_of(lines);
    std::error_code none;
    if (!name || !fs::exists(with_ending(*name, ".h5"), none)) return std::nullopt;
    try {
        StoredParticles stored = read_particle_file(with_ending(*name, ".h5"));
        if (stored.made_from != lines) return std::nullopt;  // another scene of the same hash
        const Json json = Json::parse(read_file(with_ending(*name, ".json")));
        ParticlesWithOrigin found{std::move(stored.particles), {"geometry", scene.geometry.file, {}, {}}};
        for (const auto& line : json.at("elastic"))
            found.origin.springs.emplace_back(line.at(0).get<std::string>(), line.at(1).get<std::string>());
        found.origin.notes = json.at("notes").get<std::vector<std::string>>();
        found.origin.warnings = json.at("warnings").get<std::vector<std::string>>();
        found.origin.notes.push_back("these particles were made in an earlier run, which took " +
                                     fmt::format("{:.3g} s", json.at("seconds").get<double>()) +
                                     "; 'dmp mesh' makes them anew");
        fs::last_write_time(with_ending(*name, ".h5"), fs::file_time_type::clock::now(), none);
        return found;
    } catch (const Error&) {  // damaged: they are made anew, and take its place
    } catch (const Json::exception&) {
    }
    return std::nullopt;
}

ParticlesWithOrigin MeshCache::make(const Scene& scene, const std::function<ParticlesWithOrigin()>& how) const {
    const auto start = std::chrono::steady_clock::now();
    ParticlesWithOrigin made = how();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    keep(scene, made, took.count());
    return made;
}

void MeshCache::keep(const Scene& scene, ParticlesWithOrigin& made, double seconds) const {
    if (seconds < worth_keeping) return;
    try {
        const std::vector<std::string> lines = lines_behind(scene);
        const auto name = name_of(lines);
        if (!name) return;
        make_folder(*folder_);
        const WritingAlone alone(*folder_);
        Json json{{"elastic", Json::array()},
                  {"notes", made.origin.notes},
                  {"warnings", made.origin.warnings},
                  {"seconds", seconds}};
        for (const auto& [part, constants] : made.origin.springs) json["elastic"].push_back({part, constants});
        write_file(with_ending(*name, ".json"), json.dump(2, ' ', false, Json::error_handler_t::replace));
        write_particles(with_ending(*name, ".h5"), made.particles, lines);
        make_room();
    } catch (const Error& error) {
        made.origin.notes.push_back("these particles could not be kept for the next run: " + error.problem());
    }
}

void MeshCache::make_room() const {
    std::vector<fs::directory_entry> kept;
    std::uintmax_t all = 0;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(*folder_, none))
        if (entry.path().extension() == ".h5") {
            kept.push_back(entry);
            all += entry.file_size(none);
        }
    std::ranges::sort(kept, {}, [&](const fs::directory_entry& entry) { return entry.last_write_time(none); });
    for (const fs::directory_entry& oldest : kept) {
        if (all <= largest) return;
        all -= oldest.file_size(none);
        fs::remove(oldest.path(), none);
        fs::remove(fs::path(oldest.path()).replace_extension(".json"), none);
    }
}

}  // namespace dmp::cli
