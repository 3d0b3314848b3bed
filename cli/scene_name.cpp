// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_name.hpp"

#include <filesystem>

namespace dmp::cli {

std::string scene_name(const Scene& scene) {
    const std::filesystem::path file = std::filesystem::absolute(scene.file).lexically_normal();
    if (file.filename() != "scene.toml") return file.stem().string();
    const std::string folder = file.parent_path().filename().string();
    return folder.empty() ? "scene" : folder;
}

}  // namespace dmp::cli
