// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene.hpp"

#include <algorithm>
#include <stdexcept>

#include "scene/words.hpp"

namespace dmp {

template <>
const Words<Quality>& words_of() {
    static const Words<Quality> words = {
        {Quality::draft, "draft"}, {Quality::standard, "standard"}, {Quality::fine, "fine"}};
    return words;
}

template <>
const Words<PartKind>& words_of() {
    static const Words<PartKind> words = {
        {PartKind::fluid, "fluid"}, {PartKind::rigid, "rigid"}, {PartKind::springs, "springs"}};
    return words;
}

template <>
const Words<Arrangement>& words_of() {
    static const Words<Arrangement> words = {{Arrangement::square, "square"}, {Arrangement::hexagonal, "hexagonal"}};
    return words;
}

template <>
const Words<KernelKind>& words_of() {
    static const Words<KernelKind> words = {{KernelKind::wendland_c2, "wendland_c2"}, {KernelKind::lucy, "lucy"}};
    return words;
}

template <>
const Words<WallModel>& words_of() {
    static const Words<WallModel> words = {{WallModel::extrapolated, "extrapolated"}, {WallModel::plain, "plain"}};
    return words;
}

template <>
const Words<SpringStepping>& words_of() {
    static const Words<SpringStepping> words = {{SpringStepping::implicit, "implicit"},
                                                {SpringStepping::subcycled, "subcycled"}};
    return words;
}

template <>
const Words<MeasureKind>& words_of() {
    static const Words<MeasureKind> words = {{MeasureKind::flux, "flux"},
                                             {MeasureKind::gap, "gap"},
                                             {MeasureKind::largest_speed, "largest_speed"},
                                             {MeasureKind::density, "density"},
                                             {MeasureKind::kinetic_energy, "kinetic_energy"},
                                             {MeasureKind::probe, "probe"}};
    return words;
}

template <>
const Words<FluidField>& words_of() {
    static const Words<FluidField> words = {
        {FluidField::velocity, "velocity"},   {FluidField::pressure, "pressure"},
        {FluidField::density, "density"},     {FluidField::shear_stress, "shear_stress"},
        {FluidField::stress, "stress"},       {FluidField::von_mises, "von_mises"},
        {FluidField::vorticity, "vorticity"}, {FluidField::residence_time, "residence_time"}};
    return words;
}

template <>
const Words<SolidField>& words_of() {
    static const Words<SolidField> words = {{SolidField::velocity, "velocity"},
                                            {SolidField::displacement, "displacement"},
                                            {SolidField::mean_displacement, "mean_displacement"},
                                            {SolidField::stress, "stress"},
                                            {SolidField::von_mises, "von_mises"},
                                            {SolidField::strain, "strain"},
                                            {SolidField::force, "force"}};
    return words;
}

namespace {

template <class Enumeration>
std::string find_word(Enumeration value) {
    for (const auto& [candidate, text] : words_of<Enumeration>()) {
        if (candidate == value) return text;
    }
    throw std::logic_error("an enumeration value without a word");
}

}  // namespace

std::string word(Quality quality) { return find_word(quality); }
std::string word(PartKind kind) { return find_word(kind); }
std::string word(Arrangement arrangement) { return find_word(arrangement); }
std::string word(WallModel walls) { return find_word(walls); }
std::string word(SpringStepping stepping) { return find_word(stepping); }
std::string word(FluidField field) { return find_word(field); }
std::string word(SolidField field) { return find_word(field); }
std::string word(KernelKind kernel) { return find_word(kernel); }
std::string word(MeasureKind kind) { return find_word(kind); }

bool Scene::any(const std::array<Expression, 3>& formulas) {
    return !std::all_of(formulas.begin(), formulas.end(), [](const Expression& axis) { return axis.is_zero(); });
}

std::vector<const Part*> Scene::parts_of(PartKind kind) const {
    std::vector<const Part*> found;
    for (const auto& part : parts) {
        if (*part.kind == kind && *part.enabled) found.push_back(&part);
    }
    return found;
}

bool Scene::asks_for(FluidField field) const {
    const auto probes_it = [&](const Measure& measure) {
        return *measure.kind == MeasureKind::probe && *measure.field == field;
    };
    return std::find(output.fields.begin(), output.fields.end(), field) != output.fields.end() ||
           std::any_of(measures.begin(), measures.end(), probes_it);
}

bool Scene::asks_for(SolidField field) const {
    return std::find(output.solid_fields.begin(), output.solid_fields.end(), field) != output.solid_fields.end();
}

}  // namespace dmp
