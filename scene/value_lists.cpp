// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Value types that are lists of quantities, points or names.
#include <algorithm>
#include <array>

#include "scene/value_types.hpp"

namespace dmp::scene {

ValueType<std::vector<double>> quantity_or_list(const std::string& example, const Range& range) {
    const ValueType<double> one = quantity(example, range);
    return {one.description + ", or a list of them",
            [one](const TomlNode& node, const std::string& path) {
                std::vector<double> values;
                if (!node.is_array()) {
                    values.push_back(one.read(node, path));
                    return values;
                }
                for (const auto& item : node.children) values.push_back(one.read(item, path));
                if (values.empty())
                    throw InputError(node.location, path + ": found an empty list",
                                     "give " + one.description + ", or a list of them");
                return values;
            },
            [one](const std::vector<double>& values) {
                if (values.size() == 1) return one.write(values.front());
                std::vector<std::string> items;
                items.reserve(values.size());
                for (const double value : values) items.push_back(one.write(value));
                return detail::toml_list(items);
            }};
}

ValueType<std::vector<Vec>> points() {
    const std::string description = R"(a list of points such as [[0, 0, "1 mm"], [0, 0, "3 mm"]])";
    return {description,
            [description](const TomlNode& node, const std::string& path) {
                std::vector<Vec> values;
                for (const auto& item : detail::list_items(node, path, description))
                    values.push_back(point().read(item, path));
                if (values.empty())
                    throw InputError(node.location, path + ": found an empty list", "give " + description);
                return values;
            },
            [](const std::vector<Vec>& values) {
                std::vector<std::string> items;
                items.reserve(values.size());
                for (const Vec& value : values) items.push_back(point().write(value));
                return detail::toml_list(items);
            }};
}

ValueType<Vec> direction() {
    const std::string description = "a direction of three numbers such as [0, 0, 1]";
    return {description,
            [description](const TomlNode& node, const std::string& path) {
                const auto& items = detail::list_items(node, path, description);
                if (items.size() != 3)
                    throw InputError(
                        node.location,
                        path + ": found a list of " + std::to_string(items.size()) + ", expected three numbers",
                        "write " + last_word(path) + " = [x, y, z], such as [0, 0, 1]");
                Vec value;
                for (std::size_t i = 0; i < 3; ++i) value[static_cast<Eigen::Index>(i)] = number().read(items[i], path);
                if (value.norm() == 0)
                    throw InputError(node.location, path + ": found [0, 0, 0], which has no direction",
                                     "give " + description);
                return value;
            },
            [](const Vec& value) {
                std::vector<std::string> items;
                for (const double component : value) items.push_back(number().write(component));
                return detail::toml_list(items);
            }};
}

ValueType<std::array<int, 3>> wave_numbers() {
    const std::string description = "a list of two or three whole numbers such as [1, 0]";
    return {description,
            [description](const TomlNode& node, const std::string& path) {
                const auto& items = detail::list_items(node, path, description);
                if (items.size() != 2 && items.size() != 3)
                    throw InputError(node.location,
                                     path + ": found a list of " + std::to_string(items.size()) +
                                         ", expected two or three whole numbers",
                                     "give " + description);
                std::array<int, 3> waves{};
                for (std::size_t axis = 0; axis < items.size(); ++axis) waves[axis] = integer().read(items[axis], path);
                if (waves == std::array<int, 3>{})
                    throw InputError(node.location, path + ": found no wave along any axis", "give " + description);
                return waves;
            },
            [](const std::array<int, 3>& waves) {
                std::vector<std::string> items;
                for (const int number : waves) items.push_back(integer().write(number));
                return detail::toml_list(items);
            }};
}

ValueType<std::vector<std::string>> names() {
    const std::string description = R"(a list of names such as ["cilia"])";
    return {description,
            [description](const TomlNode& node, const std::string& path) {
                std::vector<std::string> values;
                for (const auto& item : detail::list_items(node, path, description))
                    values.push_back(name().read(item, path));
                if (values.empty())
                    throw InputError(node.location, path + ": found an empty list", "give " + description);
                detail::refuse_repeated_names(node, path);
                return values;
            },
            [](const std::vector<std::string>& values) {
                std::vector<std::string> items;
                items.reserve(values.size());
                for (const std::string& value : values) items.push_back(toml_quoted(value));
                return detail::toml_list(items);
            }};
}

ValueType<std::array<std::string, 2>> two_names() {
    const std::string description = R"(a list of two parts' names such as ["carrier", "floor"])";
    return {description,
            [description](const TomlNode& node, const std::string& path) {
                const auto& items = detail::list_items(node, path, description);
                if (items.size() != 2)
                    throw InputError(
                        node.location,
                        path + ": found a list of " + std::to_string(items.size()) + ", expected two names",
                        "name both parts; name a part twice for contacts within it");
                return std::array<std::string, 2>{name().read(items[0], path), name().read(items[1], path)};
            },
            [](const std::array<std::string, 2>& value) {
                return detail::toml_list({toml_quoted(value[0]), toml_quoted(value[1])});
            }};
}

}  // namespace dmp::scene
