// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/read_slurm.hpp"

#include <algorithm>
#include <cctype>
#include <functional>
#include <vector>

#include "study/toml_table.hpp"

namespace dmp::study {

namespace {

constexpr double shortest_limit = 60, usual_margin = 120;  // [s]

/// What job scripts take as it stands: no spaces, line breaks or quotes.
ValueType<std::string> slurm_word(const std::string& what) {
    return {what + ", of letters, digits and _ - . , : + @ & | * [ ] ( )",
            [what](const TomlNode& node, const std::string& path) {
                const std::string text = text_not_empty().read(node, path);
                const bool plain = std::ranges::all_of(text, [](char c) {
                    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                           std::string_view("_-.,:+@&|*[]()").find(c) != std::string_view::npos;
                });
                if (!plain || text.front() == '-')
                    throw wrong_kind(node, path, what, "it may have letters, digits and _ - . , : + @ & | * [ ] ( )");
                return text;
            },
            [](const std::string& text) { return toml_quoted(text); }};
}

/// "4G": digits, and K, M, G or T.
ValueType<std::string> slurm_memory() {
    const std::string what = "a memory as Slurm writes it, such as \"4G\"";
    return {what,
            [what](const TomlNode& node, const std::string& path) {
                const std::string text = text_not_empty().read(node, path);
                const auto digits = text.find_first_not_of("0123456789");
                const bool good = digits != 0 && digits == text.size() - 1 &&
                                  std::string_view("KMGT").find(text.back()) != std::string_view::npos;
                if (!good) throw wrong_kind(node, path, what, "write a number and K, M, G or T");
                return text;
            },
            [](const std::string& text) { return toml_quoted(text); }};
}

/// Each key, and how it is read.
struct SlurmKey {
    std::string key;
    std::function<void(Slurm&, const TomlNode&, const std::string&)> read;
};

template <class T>
SlurmKey key(const std::string& name, const ValueType<T>& type, Value<T> Slurm::*member) {
    return {name, [type, member](Slurm& slurm, const TomlNode& node, const std::string& path) {
                slurm.*member = Value<T>(type.read(node, path), node.location);
            }};
}

const std::vector<SlurmKey>& slurm_keys() {
    static const std::vector<SlurmKey> keys{
        key("partition", slurm_word("the name of a partition, such as \"long\""), &Slurm::partition),
        key("account", slurm_word("the name of an account"), &Slurm::account),
        key("qos", slurm_word("the name of a quality of service"), &Slurm::qos),
        key("constraint", slurm_word("features of nodes, such as \"avx512\""), &Slurm::constraint),
        key("memory", slurm_memory(), &Slurm::memory),
        key("time", quantity("2 h", positive), &Slurm::time),
        key("stop_before", quantity("2 min", positive), &Slurm::stop_before),
        key("ranks", integer(at_least(1)), &Slurm::ranks),
        key("threads", integer(at_least(1)), &Slurm::threads),
        key("runs_per_job", integer(at_least(1)), &Slurm::runs_per_job),
        key("launcher", one_of<Launcher>(), &Slurm::launcher)};
    return keys;
}

void check(const Slurm& slurm) {
    if (slurm.time.given() && *slurm.time < shortest_limit)
        throw InputError(slurm.time.location, "slurm.time is less than a minute, the shortest limit that Slurm has",
                         "give \"1 min\" or more");
    if (!slurm.stop_before.given() || !slurm.time.given() || *slurm.stop_before < *slurm.time) return;
    throw InputError(slurm.stop_before.location, "slurm.stop_before is not shorter than slurm.time",
                     "give the time that a checkpoint needs, such as \"2 min\"");
}

}  // namespace

double Slurm::seconds_before_limit() const {
    if (stop_before.given()) return *stop_before;
    return time.given() ? std::min(usual_margin, *time / 4) : usual_margin;
}

Slurm read_slurm(const TomlNode& document) {
    Slurm slurm;
    const TomlNode* node = document.child("slurm");
    if (node == nullptr) return slurm;
    std::vector<std::string> names;
    for (const SlurmKey& each : slurm_keys()) names.push_back(each.key);
    const TomlTable table(*node, "slurm", names);
    for (const SlurmKey& each : slurm_keys())
        if (const TomlNode* value = table.find(each.key)) each.read(slurm, *value, table.path_of(each.key));
    check(slurm);
    return slurm;
}

Slurm with_options(Slurm slurm, const std::map<std::string, std::string>& options) {
    for (const auto& [option, text] : options) {
        if (text.empty()) continue;
        const std::string name = option.substr(option.find_first_not_of('-'));
        const auto found = std::ranges::find(slurm_keys(), name, &SlurmKey::key);
        const SourceLocation location{option, 0, 0};
        TomlNode value = parse_toml_value(text, location);
        if (name != "ranks" && name != "threads") value = parse_toml_value(toml_quoted(text), location);
        found->read(slurm, value, name);
    }
    check(slurm);
    return slurm;
}

}  // namespace dmp::study
