// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/wall_law.hpp"

#include <algorithm>
#include <utility>

#include "models/dem/contact_laws.hpp"
#include "solver/parallel/with_vector_unit.hpp"

namespace dmp::solver {

namespace {

template <ContactModel model>
WallPush push(const SphereMotion& sphere, const WallTouch& touch, const ContactConstants<double>& pair,
              const ContactTime& time, double* kept) {
    using Law = ContactLaw<model>;
    constexpr auto values = static_cast<std::size_t>(Law::history_values);
    const auto three = [](const Row& row) { return Vector<double, 3>{{row.c[0], row.c[1], row.c[2]}}; };
    const SpherePoint<double> i{three(sphere.velocity), three(sphere.spin), sphere.radius(), sphere.velocity.c[3]};
    const Contact<double> contact =
        contact_with_wall<Law>(i, touch.normal, touch.distance, touch.wall_velocity, Vector<double, 3>::zero());
    typename Law::template History<double> history;
    std::copy_n(kept, values, history.begin());
    const ContactForce<double> force = Law::law(contact, pair, history, time.dt);
    std::copy_n(history.begin(), values, kept);
    const double arm = Law::lever(i.radius, contact.radius, contact.overlap);
    return {force.on_i(touch.normal), force.torque(arm, touch.normal) + force.rolling, force.normal};
}

/// Calls visit.template operator()<model>() with the model as a constant.
template <class Visit, std::size_t... number>
void with_model(const ContactModel& model, const Visit& visit, std::index_sequence<number...> /*all*/) {
    const auto call = [&]<std::size_t n>() {
        if constexpr (contact_model(n).is_consistent())
            if (contact_model(n) == model) visit.template operator()<contact_model(n)>();
    };
    (call.template operator()<number>(), ...);
}
template <class Visit>
void with_model(const ContactModel& model, const Visit& visit) {
    with_model(model, visit, std::make_index_sequence<contact_models>{});
}

}  // namespace

double contact_reach(const ContactModel& model, const ContactConstants<double>& pair, double radius) {
    double reach = 0;
    with_model(model, [&]<ContactModel constant>() { reach = ContactLaw<constant>::reach(radius, pair); });
    return reach;
}

WallLaw wall_law(const ContactModel& model) {
    WallLaw law = nullptr;
    with_model(model, [&]<ContactModel constant>() { law = &push<constant>; });
    return law;
}

double contact_energy(const ContactModel& model, const ContactConstants<double>& pair, double overlap, double radius,
                      std::span<const double> history) {
    double energy = 0;
    with_model(model, [&]<ContactModel constant>() {
        using Law = ContactLaw<constant>;
        typename Law::template History<double> kept;
        std::copy_n(history.begin(), kept.size(), kept.begin());
        energy = Law::energy(overlap, radius, pair, kept);
    });
    return energy;
}

int history_values(const ContactModel& model) {
    int values = 0;
    with_model(model, [&]<ContactModel constant>() { values = ContactLaw<constant>::history_values; });
    return values;
}

ContactSweep contact_sweep(const ContactModel& model, VectorUnit unit) {
    return with_vector_unit(unit, [&]<VectorUnit chosen>() { return compiled_contact_sweep<chosen>(model); });
}

}  // namespace dmp::solver
