// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/neighbours/cluster_list.hpp"

#include <algorithm>
#include <cmath>

#include "particles/cell_grid.hpp"

namespace dmp {

namespace {

using Point = std::array<double, 3>;

Point point_of(const ParticleStore& particles, int i) {
    Point point{};
    for (int axis = 0; axis < particles.dimension(); ++axis) point[axis] = particles.data(Field::position, axis)[i];
    return point;
}

/// Cuts particles into clusters: strips two spacings high (and deep), sorted along x, eight at a time; a new cluster
/// starts at a new strip and after a gap, so that clusters stay small in space.
void cut_into_clusters(const ParticleStore& particles, std::span<const int> ids, double spacing,
                       std::vector<Cluster>& clusters) {
    struct Key {
        int z, y;
        double x;
        int id;
        bool operator<(const Key& other) const {
            return std::tie(z, y, x, id) < std::tie(other.z, other.y, other.x, other.id);
        }
    };
    std::vector<Key> keys;
    keys.reserve(ids.size());
    const double strip = 2 * spacing;
    for (const int id : ids) {
        const Point p = point_of(particles, id);
        keys.push_back(
            {static_cast<int>(std::floor(p[2] / strip)), static_cast<int>(std::floor(p[1] / strip)), p[0], id});
    }
    std::sort(keys.begin(), keys.end());
    const double longest = spacing * static_cast<double>(Lanes::width);
    for (std::size_t k = 0; k < keys.size();) {
        Cluster cluster;
        const Key& first = keys[k];
        while (k < keys.size() && cluster.count < Lanes::width && keys[k].y == first.y && keys[k].z == first.z &&
               keys[k].x - first.x < longest)
            cluster.member[cluster.count++] = keys[k++].id;
        std::fill(cluster.member.begin() + static_cast<std::ptrdiff_t>(cluster.count), cluster.member.end(), first.id);
        clusters.push_back(cluster);
    }
}

/// Particles of one kind by body: springs one group a body, the others one group.
std::vector<std::vector<int>> groups_of(const ParticleStore& particles, const ParticleSet& set, ParticleKind kind) {
    std::vector<std::vector<int>> groups;
    for (const int id : particles.ids(kind)) {
        const auto group = static_cast<std::size_t>(kind == ParticleKind::springs ? set.body[id] : 0);
        if (group >= groups.size()) groups.resize(group + 1);
        groups[group].push_back(id);
    }
    return groups;
}

/// Finds the neighbours of one cluster after another and appends them to a list of its own.
class Finder {
  public:
    Finder(const ParticleStore& particles, const ParticleSet& set, const CellGrid& grid, double reach)
        : particles_(particles), set_(set), grid_(grid), reach_(reach) {}

    void find(Cluster& cluster) {
        const int self = cluster.member[0];
        const ParticleKind own_kind = particles_.kind(self);
        Point low = point_of(particles_, self), high = low;
        Vector lanes;
        for (int axis = 0; axis < particles_.dimension(); ++axis) {
            const double* x = particles_.data(Field::position, axis);
            lanes[axis] = Lanes::gather(x, cluster.member.data());
            for (std::size_t k = 1; k < cluster.count; ++k) {
                low[axis] = std::min(low[axis], x[cluster.member[k]]);
                high[axis] = std::max(high[axis], x[cluster.member[k]]);
            }
            low[axis] -= reach_;
            high[axis] += reach_;
        }
        for (auto& kind : by_kind_) kind.clear();
        grid_.for_each_near(low, high, [&](int j) {
            if (nearest_square(lanes, j) >= reach_ * reach_) return;
            const int source = particles_.source(j);
            const ParticleKind kind = particles_.kind(source);
            const bool never_interact =
                kind == own_kind && (kind == ParticleKind::rigid ||
                                     (kind == ParticleKind::springs && set_.body[source] == set_.body[self]));
            if (never_interact) return;
            by_kind_[static_cast<std::size_t>(kind)].push_back(j);
        });
        for (std::size_t kind = 0; kind < by_kind_.size(); ++kind) {
            cluster.first[kind] = static_cast<int>(found.size());
            found.insert(found.end(), by_kind_[kind].begin(), by_kind_[kind].end());
        }
        cluster.first[by_kind_.size()] = static_cast<int>(found.size());
    }

    std::vector<int> found;

  private:
    using Vector = std::array<Lanes, 3>;

    /// Square of the distance between particle j and the nearest member.
    [[nodiscard]] double nearest_square(const Vector& members, int j) const {
        Lanes square = 0.0;
        for (int axis = 0; axis < particles_.dimension(); ++axis) {
            const Lanes d = members[axis] - particles_.data(Field::position, axis)[j];
            square += d * d;
        }
        double nearest = square.raw[0];
        for (std::size_t k = 1; k < Lanes::width; ++k) nearest = std::min(nearest, square.raw[k]);
        return nearest;
    }

    const ParticleStore& particles_;
    const ParticleSet& set_;
    const CellGrid& grid_;
    double reach_;
    std::array<std::vector<int>, 3> by_kind_;
};

}  // namespace

void ClusterList::build(const ParticleStore& particles, const ParticleSet& set, double reach, int threads) {
    Coordinates points;
    for (int axis = 0; axis < particles.dimension(); ++axis) {
        const double* x = particles.data(Field::position, axis);
        points[axis].assign(x, x + particles.with_images());
    }
    const CellGrid grid(points, particles.with_images(), particles.dimension(), 0.5 * reach);

    std::vector<Cluster*> all;
    for (const ParticleKind kind : {ParticleKind::fluid, ParticleKind::rigid, ParticleKind::springs}) {
        auto& clusters = clusters_[static_cast<std::size_t>(kind)];
        clusters.clear();
        for (const auto& group : groups_of(particles, set, kind))
            cut_into_clusters(particles, group, set.spacing, clusters);
        for (auto& cluster : clusters) all.push_back(&cluster);
    }

    // As many runs of clusters as threads, each listed on its own; the lists are then joined in order.
    std::vector<Finder> finders(static_cast<std::size_t>(threads), Finder(particles, set, grid, reach));
    const auto run = [&](int t) {
        return all.size() * static_cast<std::size_t>(t) / static_cast<std::size_t>(threads);
    };
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (int t = 0; t < threads; ++t)
        for (std::size_t c = run(t); c < run(t + 1); ++c) finders[t].find(*all[c]);
    neighbours_.clear();
    for (int t = 0; t < threads; ++t) {
        const int offset = static_cast<int>(neighbours_.size());
        for (std::size_t c = run(t); c < run(t + 1); ++c)
            for (int& first : all[c]->first) first += offset;
        neighbours_.insert(neighbours_.end(), finders[t].found.begin(), finders[t].found.end());
    }
}

}  // namespace dmp
