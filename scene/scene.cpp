// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene.hpp"

#include <algorithm>
#include <stdexcept>

#include "scene/words.hpp"

namespace dmp::scene {

template <>
const Words<Quality>& words_of() {
    static const Words<Quality> words = {
        {Quality::draft, "draft"}, {Quality::standard, "standard"}, {Quality::fine, "fine"}};
    return words;
}

template <>
const Words<PartKind>& words_of() {
    static const Words<PartKind> words = {{PartKind::fluid, "fluid"},     {PartKind::rigid, "rigid"},
                                          {PartKind::springs, "springs"}, {PartKind::spheres, "spheres"},
                                          {PartKind::plane, "plane"},     {PartKind::surface, "surface"}};
    return words;
}

template <>
const Words<ContactLawKind>& words_of() {
    static const Words<ContactLawKind> words = {{ContactLawKind::hertz_mindlin, "hertz_mindlin"},
                                                {ContactLawKind::hertz_history, "hertz_history"},
                                                {ContactLawKind::thesis_eq_7_5, "thesis_eq_7_5"},
                                                {ContactLawKind::none, "none"}};
    return words;
}

template <>
const Words<AdhesionKind>& words_of() {
    static const Words<AdhesionKind> words = {
        {AdhesionKind::none, "none"}, {AdhesionKind::bradley, "bradley"}, {AdhesionKind::jkr, "jkr"}};
    return words;
}

template <>
const Words<RollingKind>& words_of() {
    static const Words<RollingKind> words = {{RollingKind::constant, "constant"}, {RollingKind::spring, "spring"}};
    return words;
}

template <>
const Words<ForceAmount>& words_of() {
    static const Words<ForceAmount> words = {{ForceAmount::total, "total"},
                                             {ForceAmount::per_particle, "per_particle"}};
    return words;
}

template <>
const Words<ShapeKind>& words_of() {
    static const Words<ShapeKind> words = {{ShapeKind::parabola, "parabola"}, {ShapeKind::circle, "circle"}};
    return words;
}

template <>
const Words<PushedSide>& words_of() {
    static const Words<PushedSide> words = {
        {PushedSide::both, "both"}, {PushedSide::inside, "inside"}, {PushedSide::outside, "outside"}};
    return words;
}

template <>
const Words<Arrangement>& words_of() {
    static const Words<Arrangement> words = {
        {Arrangement::square, "square"}, {Arrangement::hexagonal, "hexagonal"}, {Arrangement::fcc, "fcc"}};
    return words;
}

template <>
const Words<RepairKind>& words_of() {
    static const Words<RepairKind> words = {{RepairKind::none, "none"},
                                            {RepairKind::weld, "weld"},
                                            {RepairKind::fill, "fill"},
                                            {RepairKind::vote, "vote"},
                                            {RepairKind::wrap, "wrap"}};
    return words;
}

template <>
const Words<FillKind>& words_of() {
    static const Words<FillKind> words = {
        {FillKind::lattice, "lattice"}, {FillKind::relaxed, "relaxed"}, {FillKind::sampled, "sampled"}};
    return words;
}

template <>
const Words<KernelKind>& words_of() {
    static const Words<KernelKind> words = {{KernelKind::wendland_c2, "wendland_c2"},
                                            {KernelKind::wendland_c4, "wendland_c4"},
                                            {KernelKind::lucy, "lucy"},
                                            {KernelKind::cubic_spline, "cubic_spline"},
                                            {KernelKind::quintic_spline, "quintic_spline"}};
    return words;
}

template <>
const Words<BoxSide>& words_of() {
    static const Words<BoxSide> words = {{BoxSide::x_low, "x_low"}, {BoxSide::x_high, "x_high"},
                                         {BoxSide::y_low, "y_low"}, {BoxSide::y_high, "y_high"},
                                         {BoxSide::z_low, "z_low"}, {BoxSide::z_high, "z_high"}};
    return words;
}

template <>
const Words<WallModel>& words_of() {
    static const Words<WallModel> words = {{WallModel::extrapolated, "extrapolated"}, {WallModel::plain, "plain"}};
    return words;
}

template <>
const Words<EquationOfState>& words_of() {
    static const Words<EquationOfState> words = {{EquationOfState::tait, "tait"}, {EquationOfState::linear, "linear"}};
    return words;
}

template <>
const Words<DensityModel>& words_of() {
    static const Words<DensityModel> words = {{DensityModel::continuity, "continuity"},
                                              {DensityModel::summation, "summation"}};
    return words;
}

template <>
const Words<ViscousLaw>& words_of() {
    static const Words<ViscousLaw> words = {{ViscousLaw::morris, "morris"},
                                            {ViscousLaw::monaghan, "monaghan"},
                                            {ViscousLaw::monaghan_approaching, "monaghan_approaching"}};
    return words;
}

template <>
const Words<ViscosityMean>& words_of() {
    static const Words<ViscosityMean> words = {{ViscosityMean::harmonic, "harmonic"},
                                               {ViscosityMean::arithmetic, "arithmetic"}};
    return words;
}

template <>
const Words<SpringStepping>& words_of() {
    static const Words<SpringStepping> words = {{SpringStepping::implicit, "implicit"},
                                                {SpringStepping::subcycled, "subcycled"}};
    return words;
}

template <>
const Words<ViscosityStepping>& words_of() {
    static const Words<ViscosityStepping> words = {{ViscosityStepping::explicitly, "explicit"},
                                                   {ViscosityStepping::implicitly, "implicit"}};
    return words;
}

template <>
const Words<SpeciesStepping>& words_of() {
    static const Words<SpeciesStepping> words = {{SpeciesStepping::explicitly, "explicit"},
                                                 {SpeciesStepping::implicitly, "implicit"}};
    return words;
}

template <>
const Words<SpeciesUnit>& words_of() {
    static const Words<SpeciesUnit> words = {
        {SpeciesUnit::mass, "kg/m^3"}, {SpeciesUnit::moles, "mol/m^3"}, {SpeciesUnit::none, "1"}};
    return words;
}

template <>
const Words<Axis>& words_of() {
    static const Words<Axis> words = {{Axis::x, "x"}, {Axis::y, "y"}, {Axis::z, "z"}};
    return words;
}

template <>
const Words<MeasureKind>& words_of() {
    static const Words<MeasureKind> words = {{MeasureKind::flux, "flux"},
                                             {MeasureKind::gap, "gap"},
                                             {MeasureKind::largest_speed, "largest_speed"},
                                             {MeasureKind::density, "density"},
                                             {MeasureKind::kinetic_energy, "kinetic_energy"},
                                             {MeasureKind::probe, "probe"},
                                             {MeasureKind::amount, "amount"},
                                             {MeasureKind::mean_concentration, "mean_concentration"},
                                             {MeasureKind::profile, "profile"},
                                             {MeasureKind::spread, "spread"},
                                             {MeasureKind::wall_flux, "wall_flux"},
                                             {MeasureKind::peclet, "peclet"},
                                             {MeasureKind::velocity, "velocity"},
                                             {MeasureKind::spin, "spin"},
                                             {MeasureKind::wall_force, "wall_force"},
                                             {MeasureKind::detached, "detached"},
                                             {MeasureKind::aggregate, "aggregate"}};
    return words;
}

template <>
const Words<SolidifyRule>& words_of() {
    static const Words<SolidifyRule> words = {{SolidifyRule::per_pair, "per_pair"},
                                              {SolidifyRule::per_candidate, "per_candidate"},
                                              {SolidifyRule::mutually_closest, "mutually_closest"}};
    return words;
}

template <>
const Words<SeedActivity>& words_of() {
    static const Words<SeedActivity> words = {
        {SeedActivity::always, "always"}, {SeedActivity::once, "once"}, {SeedActivity::one_in, "one_in"}};
    return words;
}

template <>
const Words<BondTo>& words_of() {
    static const Words<BondTo> words = {{BondTo::seed, "seed"}, {BondTo::neighbours, "neighbours"}};
    return words;
}

template <>
const Words<FluidField>& words_of() {
    static const Words<FluidField> words = {{FluidField::velocity, "velocity"},
                                            {FluidField::pressure, "pressure"},
                                            {FluidField::density, "density"},
                                            {FluidField::shear_stress, "shear_stress"},
                                            {FluidField::stress, "stress"},
                                            {FluidField::von_mises, "von_mises"},
                                            {FluidField::vorticity, "vorticity"},
                                            {FluidField::residence_time, "residence_time"},
                                            {FluidField::concentration, "concentration"}};
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
std::string word(ContactLawKind law) { return find_word(law); }
std::string word(AdhesionKind adhesion) { return find_word(adhesion); }
std::string word(RollingKind rolling) { return find_word(rolling); }
std::string word(ForceAmount amount) { return find_word(amount); }
std::string word(ShapeKind kind) { return find_word(kind); }
std::string word(PushedSide side) { return find_word(side); }
std::string word(Arrangement arrangement) { return find_word(arrangement); }
std::string word(RepairKind repair) { return find_word(repair); }
std::string word(FillKind fill) { return find_word(fill); }
std::string word(BoxSide side) { return find_word(side); }
std::string word(WallModel walls) { return find_word(walls); }
std::string word(EquationOfState equation) { return find_word(equation); }
std::string word(DensityModel density) { return find_word(density); }
std::string word(ViscousLaw law) { return find_word(law); }
std::string word(ViscosityMean mean) { return find_word(mean); }
std::string word(SpringStepping stepping) { return find_word(stepping); }
std::string word(ViscosityStepping stepping) { return find_word(stepping); }
std::string word(SpeciesStepping stepping) { return find_word(stepping); }
std::string word(SpeciesUnit unit) { return find_word(unit); }
std::string word(Axis axis) { return find_word(axis); }
std::string word(FluidField field) { return find_word(field); }
std::string word(SolidField field) { return find_word(field); }
std::string word(KernelKind kernel) { return find_word(kernel); }
std::string word(MeasureKind kind) { return find_word(kind); }
std::string word(SolidifyRule rule) { return find_word(rule); }
std::string word(SeedActivity activity) { return find_word(activity); }
std::string word(BondTo bonds) { return find_word(bonds); }

bool Part::slides() const { return !std::ranges::all_of(surface_velocity.value, &Expression::is_zero); }

bool Part::moves() const { return !spin->is_zero() || !std::ranges::all_of(velocity.value, &Expression::is_zero); }

std::string Species::amount_unit() const {
    return *unit == SpeciesUnit::mass ? "kg" : *unit == SpeciesUnit::moles ? "mol" : "m^3";
}

std::string Species::concentration_unit() const { return word(*unit); }

const Value<double>* Species::diffusivity_in(const Part& part) const {
    // One diffusivity for all is that of all liquids; solids conduct where they are named.
    if (*part.kind != PartKind::fluid && !diffusivity.parts.contains(*part.name)) return nullptr;
    return diffusivity.of(*part.name);
}

std::size_t Scene::species_of(const Measure& measure) const {
    if (measure.species->empty() && species.size() == 1) return 0;
    for (std::size_t s = 0; s < species.size(); ++s)
        if (*species[s].name == *measure.species) return s;
    throw std::out_of_range("no species '" + *measure.species + "'");
}

std::vector<const Join*> Scene::joins_of_enabled() const {
    const auto is_enabled = [this](const std::string& name) {
        const Part* part = part_named(name);
        return part != nullptr && *part->enabled;
    };
    std::vector<const Join*> found;
    for (const Join& join : joins)
        if (std::ranges::all_of(*join.parts, is_enabled)) found.push_back(&join);
    return found;
}

const Part* Scene::part_named(const std::string& name) const {
    const auto found = std::ranges::find_if(parts, [&](const Part& part) { return *part.name == name; });
    return found == parts.end() ? nullptr : &*found;
}

const Part& Scene::part_of_particles(const std::string& name) const {
    if (const Part* part = part_named(name)) return *part;
    throw InputError("the particles have a part '" + name + "' that the scene does not know", "mesh the scene again");
}

std::vector<const Part*> Scene::parts_of(PartKind kind) const {
    std::vector<const Part*> found;
    for (const auto& part : parts) {
        if (*part.kind == kind && *part.enabled) found.push_back(&part);
    }
    return found;
}

std::vector<std::string> Scene::names_of_parts(PartKind kind) const {
    const std::vector<const Part*> found = parts_of(kind);
    std::vector<std::string> names;
    names.reserve(found.size());
    for (const Part* part : found) names.push_back(part->name);
    return names;
}

const ContactPair* Scene::contact_between(const std::string& a, const std::string& b) const {
    const ContactPair* best = nullptr;
    int best_rank = -1;
    const auto rank = [&](const std::string& first, const std::string& second) {
        const auto fits = [](const std::string& named, const std::string& part) {
            return named == part ? 1 : named == "any" ? 0 : -3;
        };
        return fits(first, a) + fits(second, b);
    };
    for (const ContactPair& pair : contact_pairs) {
        const auto& [first, second] = *pair.parts;
        const int found = std::max(rank(first, second), rank(second, first));
        if (found >= 0 && found >= best_rank) {
            best = &pair;
            best_rank = found;
        }
    }
    return best;
}

bool Scene::asks_for(FluidField field) const {
    const auto probes_it = [&](const Measure& measure) {
        return *measure.kind == MeasureKind::probe && *measure.field == field;
    };
    const auto waits_for_it = [&](const Solidify& rule) {
        return field == FluidField::residence_time && (*rule.seed_residence_above > 0 || *rule.residence_above > 0);
    };
    return std::find(output.fields.begin(), output.fields.end(), field) != output.fields.end() ||
           std::any_of(measures.begin(), measures.end(), probes_it) ||
           std::any_of(solidify.begin(), solidify.end(), waits_for_it);
}

bool Scene::asks_for(SolidField field) const {
    return std::find(output.solid_fields.begin(), output.solid_fields.end(), field) != output.solid_fields.end();
}

}  // namespace dmp::scene
