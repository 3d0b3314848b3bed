// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "models/dem/contact_law.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

struct Sphere {
    Vector<double, 3> position, velocity, spin;
    double radius, mass;
    Vector<double, 3> force{}, torque{};
};

/// A wall through the origin: its normal points to the spheres.
struct Floor {
    Vector<double, 3> normal{{0, 0, 1}};
    ContactConstants<> pair;
};

/// Spheres among themselves and on a floor: every pair in turn, one law, velocity Verlet. Forces see the velocities of
/// half a step ago, which moved the spheres to where they are.
template <ContactModel model>
class FewSpheres {
  public:
    using V3 = Vector<double, 3>;
    using Law = ContactLaw<model>;
    using History = typename Law::template History<double>;

    std::vector<Sphere> spheres;
    ContactConstants<> pair;
    std::optional<Floor> floor;
    V3 gravity{};
    /// Called with each contact's overlap, effective radius and force, when forces are found.
    struct Met {
        double overlap, radius;
        ContactForce<double> force;
    };
    std::vector<Met> met;

    /// Forces of the moment, histories as they are.
    void begin() { find_forces(0); }
    void step(double dt) {
        kick(dt / 2);
        for (Sphere& sphere : spheres) sphere.position += dt * sphere.velocity;
        find_forces(dt);
        kick(dt / 2);
    }
    [[nodiscard]] double kinetic_energy() const {
        double sum = 0;
        for (const Sphere& s : spheres)
            sum += 0.5 * s.mass * (dot(s.velocity, s.velocity) + 0.4 * s.radius * s.radius * dot(s.spin, s.spin));
        return sum;
    }
    [[nodiscard]] bool touching() const {
        return std::any_of(met.begin(), met.end(), [](const Met& contact) { return contact.overlap > 0; });
    }
    /// Of pair i, j (j < i), or of i and the floor (j = i).
    [[nodiscard]] History& history(std::size_t i, std::size_t j) {
        histories_.resize(spheres.size() * spheres.size());
        return histories_[i * spheres.size() + j];
    }

  private:
    void kick(double dt) {
        for (Sphere& s : spheres) {
            s.velocity += (dt / s.mass) * s.force + dt * gravity;
            s.spin += (dt / (0.4 * s.mass * s.radius * s.radius)) * s.torque;
        }
    }
    static SpherePoint<double> point(const Sphere& s) { return {s.velocity, s.spin, s.radius, s.mass}; }

    void find_forces(double dt) {
        met.clear();
        for (Sphere& s : spheres) s.force = s.torque = V3{};
        for (std::size_t i = 0; i < spheres.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) meet(spheres[i], spheres[j], history(i, j), dt);
            if (floor) land(spheres[i], history(i, i), dt);
        }
    }
    void meet(Sphere& i, Sphere& j, History& kept, double dt) {
        const V3 separation = i.position - j.position;
        const double square = dot(separation, separation);
        const double radius = i.radius * j.radius / (i.radius + j.radius);
        const double reach = i.radius + j.radius + Law::reach(radius, pair);
        if (square >= reach * reach) {
            kept = {};
            return;
        }
        const auto contact = contact_of_spheres<Law>(point(i), point(j), separation, std::sqrt(square));
        const auto force = Law::law(contact, pair, kept, dt);
        met.push_back({contact.overlap, contact.radius, force});
        act(i, contact, force);
        j.force -= force.on_i(contact.normal);
        j.torque += force.torque(Law::lever(j.radius, contact.radius, contact.overlap), contact.normal) - force.rolling;
    }
    void land(Sphere& i, History& kept, double dt) {
        const double distance = dot(i.position, floor->normal);
        if (distance >= i.radius + Law::reach(i.radius, floor->pair)) {
            kept = {};
            return;
        }
        const auto contact = contact_with_wall<Law>(point(i), floor->normal, distance, V3{}, V3{});
        const auto force = Law::law(contact, floor->pair, kept, dt);
        met.push_back({contact.overlap, contact.radius, force});
        act(i, contact, force);
    }
    static void act(Sphere& i, const Contact<double>& contact, const ContactForce<double>& force) {
        i.force += force.on_i(contact.normal);
        i.torque += force.torque(Law::lever(i.radius, contact.radius, contact.overlap), contact.normal) + force.rolling;
    }

    std::vector<History> histories_;
};

}  // namespace dmp::tests
