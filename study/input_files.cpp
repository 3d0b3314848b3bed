// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/input_files.hpp"

#include <filesystem>
#include <set>

#include "base/errors.hpp"
#include "base/hex_text.hpp"
#include "base/safe_file.hpp"
#include "base/text_hash.hpp"

namespace dmp::study {

namespace {

/// Whether a key that varies names a file.
bool names_a_file(const std::string& key) {
    return key == "geometry.file" ||
           (key.starts_with("part.") && (key.ends_with(".file") || key.ends_with(".positions")));
}

std::string hash_of(const std::filesystem::path& file) {
    try {
        return hex_text(text_hash(read_file(file)));
    } catch (const Error&) {  // the runs say what is wrong with it
        return "";
    }
}

}  // namespace

std::vector<InputFile> input_files(const Study& study) {
    std::set<std::string> names{*study.scene.geometry.file};
    for (const Part& part : study.scene.parts) names.insert({*part.file, *part.positions});
    for (const Reference& reference : study.scene.references) names.insert(*reference.file);
    for (const Vary& vary : study.vary)
        for (std::size_t k = 0; k < vary.keys.size(); ++k)
            if (names_a_file(*vary.keys[k].key))
                for (const auto& row : vary.rows) names.insert(row[k].cell);
    names.erase("");
    std::vector<InputFile> files;
    for (const std::string& name : names)
        files.push_back({name, hash_of(std::filesystem::path(study.scene.directory) / name)});
    return files;
}

}  // namespace dmp::study
