// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/wall_law.hpp"

#include <algorithm>
#include <utility>

#include "solver/spheres/contact_models.hpp"

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

template <std::size_t... number>
WallLaw law_of(std::size_t wanted, std::index_sequence<number...> /*all*/) {
    WallLaw found = nullptr;
    ((number == wanted ? void(found = &push<contact_model(number)>) : void()), ...);
    return found;
}

template <std::size_t... number>
int values_of(std::size_t wanted, std::index_sequence<number...> /*all*/) {
    int found = 0;
    ((number == wanted ? void(found = ContactLaw<contact_model(number)>::history_values) : void()), ...);
    return found;
}

template <std::size_t... number>
double reach_of(std::size_t wanted, double radius, const ContactConstants<double>& pair,
                std::index_sequence<number...> /*all*/) {
    double found = 0;
    ((number == wanted ? void(found = ContactLaw<contact_model(number)>::reach(radius, pair)) : void()), ...);
    return found;
}

}  // namespace

double contact_reach(const ContactModel& model, const ContactConstants<double>& pair, double radius) {
    return reach_of(number_of(model), radius, pair, std::make_index_sequence<contact_models>{});
}

WallLaw wall_law(const ContactModel& model) {
    return law_of(number_of(model), std::make_index_sequence<contact_models>{});
}

int history_values(const ContactModel& model) {
    return values_of(number_of(model), std::make_index_sequence<contact_models>{});
}

ContactSweep contact_sweep(const ContactModel& model, VectorUnit unit) {
    switch (chosen_vector_unit(unit)) {
#if defined(__x86_64__)
        case VectorUnit::avx512:
            return compiled_contact_sweep<VectorUnit::avx512>(model);
        default:
            return compiled_contact_sweep<VectorUnit::avx2>(model);
#else
        default:
            return compiled_contact_sweep<VectorUnit::generic>(model);
#endif
    }
}

}  // namespace dmp::solver
