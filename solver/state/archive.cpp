// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/state/archive.hpp"

#include <algorithm>

#include "base/errors.hpp"
#include "base/number_text.hpp"

namespace dmp::solver {

const Hdf5Reader& Archive::reader_of(const std::string& name) const {
    if (!reader_->has(name))
        throw InputError("the checkpoint holds no '" + name + "', which the scene needs now",
                         "Go on with the dmp and the fields that the run was started with, or start a new run.");
    return *reader_;
}

template <class T>
void Archive::array(const std::string& name, std::vector<T>& values) {
    if (loading()) {
        values = reader_of(name).array<T>(name);
    } else if (writer_ != nullptr) {
        writer_->write_array<T>(name, values);
    }
}

void Archive::operator()(const std::string& name, double& value) {
    if (loading()) {
        value = reader_of(name).number<double>(name);
    } else if (writer_ != nullptr) {
        writer_->write_number<double>(name, value);
    }
}

void Archive::operator()(const std::string& name, std::int64_t& value) {
    if (loading()) {
        value = reader_of(name).number<std::int64_t>(name);
    } else if (writer_ != nullptr) {
        writer_->write_number<std::int64_t>(name, value);
    }
}

void Archive::operator()(const std::string& name, std::string& text) {
    if (loading()) {
        text = reader_of(name).text(name);
    } else if (writer_ != nullptr) {
        writer_->write_text(name, text);
    }
}

void Archive::same(const std::string& name, double value, const std::string& what, const std::string& key,
                   const std::string& unit) {
    double before = value;
    (*this)(name, before);
    if (before == value) return;
    if (starts_run())
        throw InputError(what + " is " + number_text(before, 17) + " in the state that the run is to start from, and " +
                             number_text(value, 17) +
                             " would be chosen for it; under another one the state would mean "
                             "something else",
                         key.empty()
                             ? "Leave the values as they are that it is chosen by."
                             : "Keep it with --set " + key + "='\"" + number_text(before, 17) + " " + unit + "\"'.");
    throw InputError(what + " was chosen for the run's first duration as " + number_text(before, 12) + ", and is " +
                         number_text(value, 12) + " for this one",
                     "Leave run.duration as it was and give the later end with --until; or start a new run.");
}

void Archive::operator()(const std::string& name, std::vector<double>& values) { array(name, values); }

template <int D>
void Archive::vectors(const std::string& name, std::vector<Vector<double, D>>& values) {
    std::vector<double> flat;
    for (const auto& value : values) flat.insert(flat.end(), value.c, value.c + D);
    array(name, flat);
    values.resize(flat.size() / D);
    for (std::size_t k = 0; k < values.size(); ++k)
        for (int axis = 0; axis < D; ++axis) values[k][axis] = flat[D * k + axis];
}
void Archive::operator()(const std::string& name, std::vector<Vector<double, 2>>& values) { vectors(name, values); }
void Archive::operator()(const std::string& name, std::vector<Vector<double, 3>>& values) { vectors(name, values); }

void Archive::operator()(const std::string& name, std::array<double, 3>& values) {
    std::vector<double> three(values.begin(), values.end());
    array(name, three);
    if (three.size() != 3) reader_->refuse("'" + name + "' does not have three numbers");
    std::copy(three.begin(), three.end(), values.begin());
}

template <class T, class Of>
void Archive::save_of_all(const std::string& name, std::size_t owned, const Of& of) {
    std::vector<T> own(owned);
    for (std::size_t i = 0; i < owned; ++i) own[i] = of(i);
    std::vector<T> all = ranks_.gather_to_first(own);
    array(name, all);
}

template <class T>
std::vector<T> Archive::share(const std::string& name, std::uint64_t begin, std::uint64_t end) const {
    if (reader_of(name).length(name) < end) reader_->refuse("'" + name + "' is too short");
    std::vector<T> values(end - begin);
    reader_->read<T>(name, begin, std::span(values));
    return values;
}

void Archive::operator()(const std::string& name, ParticleGroup& group) {
    const auto array_name = [&](Field field, int axis) {
        return name + "/" + std::string(info(field).name) +
               (info(field).shape != FieldShape::scalar || group.axes(field) > 1 ? "_" + std::to_string(axis) : "");
    };
    if (!loading()) {
        const auto tags = group.tags();
        save_of_all<std::int64_t>(name + "/id", group.owned(), [&](std::size_t i) { return tags[i].id; });
        save_of_all<std::int32_t>(name + "/body", group.owned(), [&](std::size_t i) { return tags[i].body; });
        save_of_all<std::uint16_t>(name + "/part", group.owned(), [&](std::size_t i) { return tags[i].part; });
        for (const Field field : group.state())
            for (int axis = 0; axis < group.axes(field); ++axis)
                save_of_all<double>(array_name(field, axis), group.owned(),
                                    [&](std::size_t i) { return group.data(field, axis)[i]; });
        return;
    }
    const std::uint64_t count = reader_of(name + "/id").length(name + "/id");
    const auto rank = static_cast<std::uint64_t>(ranks_.rank()), ranks = static_cast<std::uint64_t>(ranks_.size());
    const std::uint64_t begin = count * rank / ranks, end = count * (rank + 1) / ranks;
    const auto id = share<std::int64_t>(name + "/id", begin, end);
    const auto body = share<std::int32_t>(name + "/body", begin, end);
    const auto part = share<std::uint16_t>(name + "/part", begin, end);
    group.resize(end - begin, 0);
    for (std::size_t i = 0; i < id.size(); ++i) group.tags()[i] = {id[i], body[i], part[i]};
    for (const Field field : group.state())
        for (int axis = 0; axis < group.axes(field); ++axis)
            std::ranges::copy(share<double>(array_name(field, axis), begin, end), group.data(field, axis));
}

}  // namespace dmp::solver
