// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a scene, and as what --set changes in it: texts that end with a zero byte, the scene first. It is read
// and checked in full, or refused by an InputError whose place is in it.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

#include "base/errors.hpp"
#include "scene/read_scene.hpp"
#include "scene/scene_difference.hpp"
#include "tests/modules.hpp"

namespace {

/// A file in memory, with a path.
class MemoryFile {
  public:
    [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }
    void put(const std::string& text) const {
        if (ftruncate(descriptor_, 0) != 0 ||
            pwrite(descriptor_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
            std::abort();
    }

  private:
    int descriptor_ = memfd_create("scene", 0);
};

std::vector<std::string> texts_in(const std::uint8_t* data, std::size_t size) {
    std::vector<std::string> texts(1);
    for (std::size_t k = 0; k < size; ++k)
        if (data[k] == 0)
            texts.emplace_back();
        else
            texts.back() += static_cast<char>(data[k]);
    return texts;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const MemoryFile file;
    std::vector<std::string> texts = texts_in(data, size);
    file.put(texts.front());
    texts.erase(texts.begin());
    if (texts.size() > 4) texts.resize(4);
    try {
        const dmp::scene::Scene scene = dmp::scene::read_scene(file.path(), texts);
        const std::string text = dmp::scene::resolved_scene(scene);
        if (!dmp::scene::differences(text, text).empty()) std::abort();
    } catch (const dmp::InputError& error) {
        if (error.problem().empty()) std::abort();
    }
    return 0;
}
