// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/domain/halo.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "solver/parallel/communicator.hpp"
#include "solver/parallel/select.hpp"

namespace dmp::solver {

namespace {

constexpr int halo_tag = 2;

void refuse(bool wrong, const char* what) {
    if (wrong) throw std::logic_error(std::string("halo: ") + what);
}

}  // namespace

struct Halo::Requests {
    std::vector<MPI_Request> all;
};

Halo::Halo(Ranks ranks, ParticleSpace space, int threads)
    : ranks_(std::move(ranks)), space_(std::move(space)), threads_(threads), requests_(std::make_unique<Requests>()) {}

Halo::~Halo() = default;
Halo::Halo(Halo&&) noexcept = default;
Halo& Halo::operator=(Halo&&) noexcept = default;

void Halo::build(ParticleGroup& group, const Domain& domain, double reach) {
    refuse(!fields_.empty(), "an exchange is under way");
    group.resize(group.owned(), 0);
    own_ = {ranks_.rank(), {}, {}, {}};
    outgoing_.clear();
    for (Outgoing& wanted : wanted_ghosts(group, domain, reach))
        if (wanted.rank == ranks_.rank())
            own_ = std::move(wanted);
        else
            outgoing_.push_back(std::move(wanted));
    make_room(group);
    exchange(group, group.declared());
}

/// The particles of this rank that each other rank needs; no entry for ranks that need none.
std::vector<Halo::Outgoing> Halo::wanted_ghosts(const ParticleGroup& group, const Domain& domain, double reach) const {
    std::vector<Outgoing> all;
    const HaloTargets targets(domain, ranks_, space_, reach);
    if (targets.list().empty()) return all;
    std::array<const double*, 3> x{};
    for (int axis = 0; axis < space_.dimension; ++axis) x[axis] = group.data(Field::position, axis);
    const std::vector<std::int32_t> candidates =
        select(group.owned(), threads_, [&](std::size_t i) { return targets.may_need(x, i); });
    for (const HaloTarget& target : targets.list()) {
        const std::vector<std::int32_t> chosen =
            select(candidates.size(), threads_, [&](std::size_t k) { return targets.needs(target, x, candidates[k]); });
        if (chosen.empty()) continue;
        if (all.empty() || all.back().rank != target.rank) all.push_back({target.rank, {}, {}, {}});
        Outgoing& outgoing = all.back();
        for (const std::int32_t k : chosen) outgoing.sources.push_back(candidates[k]);
        outgoing.runs.push_back({target.image, outgoing.sources.size()});
    }
    return all;
}

/// Sends the tags of the ghosts to the other ranks and makes space for all ghosts.
void Halo::make_room(ParticleGroup& group) {
    const auto tags_of = [&group](const Outgoing& outgoing) {
        std::vector<ParticleTag> tags;
        for (const std::int32_t source : outgoing.sources) tags.push_back(group.tags()[source]);
        return tags;
    };
    std::vector<std::vector<ParticleTag>> to_each(static_cast<std::size_t>(ranks_.size()));
    to_each[ranks_.rank()] = tags_of(own_);
    for (const Outgoing& outgoing : outgoing_) to_each[outgoing.rank] = tags_of(outgoing);
    std::vector<std::vector<ParticleTag>> from_each = ranks_.exchange(to_each);

    owned_ = group.owned();
    total_ = owned_ + own_.sources.size();
    incoming_.clear();
    for (int rank = 0; rank < ranks_.size(); ++rank) {
        const std::size_t count = from_each[rank].size();
        if (rank == ranks_.rank() || count == 0) continue;
        incoming_.push_back({rank, total_, count, {}});
        total_ += count;
    }
    group.resize(owned_, total_ - owned_);
    std::copy(from_each[ranks_.rank()].begin(), from_each[ranks_.rank()].end(), group.tags().begin() + owned_);
    for (const Incoming& incoming : incoming_)
        std::copy(from_each[incoming.rank].begin(), from_each[incoming.rank].end(),
                  group.tags().begin() + incoming.first);
}

void Halo::start(ParticleGroup& group, const FieldList& fields) {
    refuse(!fields_.empty(), "an exchange is under way");
    refuse(group.owned() != owned_ || group.total() != total_, "the group has changed since build()");
    for (const Field field : fields) refuse(!group.has(field), "a field was not declared");
    fields_ = fields;
    std::vector<std::pair<Field, int>> arrays;
    for (const Field field : fields)
        for (int axis = 0; axis < group.axes(field); ++axis) arrays.emplace_back(field, axis);

    post_receives(arrays.size());
    for (Outgoing& outgoing : outgoing_) {
        const std::size_t count = outgoing.sources.size();
        outgoing.buffer.resize(count * arrays.size());
        double* to = outgoing.buffer.data();
        for (const auto& [field, axis] : arrays) {
            copy_values(outgoing, group, field, axis, to);
            to += count;
        }
        MPI_Isend(outgoing.buffer.data(), static_cast<int>(outgoing.buffer.size()), MPI_DOUBLE, outgoing.rank, halo_tag,
                  ranks_.communicator().handle, &requests_->all.emplace_back());
        ++traffic_.messages;
        traffic_.bytes += static_cast<std::int64_t>(outgoing.buffer.size() * sizeof(double));
    }
    for (const auto& [field, axis] : arrays) copy_values(own_, group, field, axis, group.data(field, axis) + owned_);
}

void Halo::post_receives(std::size_t arrays) {
    for (Incoming& incoming : incoming_) {
        incoming.buffer.resize(incoming.count * arrays);
        MPI_Irecv(incoming.buffer.data(), static_cast<int>(incoming.buffer.size()), MPI_DOUBLE, incoming.rank, halo_tag,
                  ranks_.communicator().handle, &requests_->all.emplace_back());
    }
}

void Halo::finish(ParticleGroup& group) {
    std::vector<MPI_Request>& requests = requests_->all;
    if (!requests.empty()) MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    requests.clear();
    for (const Incoming& incoming : incoming_) {
        const double* from = incoming.buffer.data();
        for (const Field field : fields_)
            for (int axis = 0; axis < group.axes(field); ++axis) {
                std::copy_n(from, incoming.count, group.data(field, axis) + incoming.first);
                from += incoming.count;
            }
    }
    fields_.clear();
}

void Halo::copy_values(const Outgoing& outgoing, const ParticleGroup& group, Field field, int axis, double* to) const {
    const double* from = group.data(field, axis);
    const std::int32_t* sources = outgoing.sources.data();
    std::size_t begin = 0;
    for (const Run& run : outgoing.runs) {
        const bool mirrored = changes_sign(field, axis, group.dimension(), run.image.mirrored);
        const double shift = field == Field::position ? run.image.shift[axis] : 0;
        if (mirrored)
#pragma omp parallel for num_threads(threads_) schedule(static) if (run.end - begin >= worth_threads)
            for (std::size_t k = begin; k < run.end; ++k) to[k] = shift - from[sources[k]];
        else if (shift == 0)  // adding 0 would turn -0 into +0
#pragma omp parallel for num_threads(threads_) schedule(static) if (run.end - begin >= worth_threads)
            for (std::size_t k = begin; k < run.end; ++k) to[k] = from[sources[k]];
        else
#pragma omp parallel for num_threads(threads_) schedule(static) if (run.end - begin >= worth_threads)
            for (std::size_t k = begin; k < run.end; ++k) to[k] = from[sources[k]] + shift;
        begin = run.end;
    }
}

void Halo::exchange_rows(double* rows, std::size_t width) {
    refuse(!fields_.empty(), "an exchange is under way");
    post_receives(width);
    for (Outgoing& outgoing : outgoing_) {
        outgoing.buffer.resize(outgoing.sources.size() * width);
        copy_rows(outgoing, rows, width, outgoing.buffer.data());
        MPI_Isend(outgoing.buffer.data(), static_cast<int>(outgoing.buffer.size()), MPI_DOUBLE, outgoing.rank, halo_tag,
                  ranks_.communicator().handle, &requests_->all.emplace_back());
        ++traffic_.messages;
        traffic_.bytes += static_cast<std::int64_t>(outgoing.buffer.size() * sizeof(double));
    }
    copy_rows(own_, rows, width, rows + owned_ * width);
    std::vector<MPI_Request>& requests = requests_->all;
    if (!requests.empty()) MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    requests.clear();
    for (const Incoming& incoming : incoming_) std::ranges::copy(incoming.buffer, rows + incoming.first * width);
}

void Halo::copy_rows(const Outgoing& outgoing, const double* rows, std::size_t width, double* to) {
    std::size_t k = 0;
    for (const Run& run : outgoing.runs) {
        for (const bool mirrored : run.image.mirrored) refuse(mirrored, "rows cannot have mirror images");
        for (; k < run.end; ++k) {
            double* row = to + k * width;
            std::copy_n(rows + static_cast<std::size_t>(outgoing.sources[k]) * width, width, row);
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (run.image.shift[axis] != 0) row[axis] += run.image.shift[axis];
        }
    }
}

double Halo::ghosts_per_owned() const {
    const std::int64_t owned = ranks_.sum(static_cast<std::int64_t>(owned_));
    const std::int64_t ghosts = ranks_.sum(static_cast<std::int64_t>(total_ - owned_));
    return owned > 0 ? static_cast<double>(ghosts) / static_cast<double>(owned) : 0;
}

}  // namespace dmp::solver
