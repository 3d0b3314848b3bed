// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "solver/parallel/exact_sum.hpp"

namespace dmp::solver {

struct Communicator;

/// What may be sent from rank to rank as it lies in memory.
template <class T>
concept Sendable = std::is_trivially_copyable_v<T>;

/// The processes that share a run, and what they tell each other. Every function but rank(), size() and is_first() must
/// be called by all ranks, in the same order; each comes back with the same value on all ranks unless it says
/// otherwise. One rank alone calls no MPI. Copies of a Ranks are the same ranks.
class Ranks {
  public:
    /// This process and nobody else; MPI need not be running.
    static Ranks alone() { return {}; }
    /// All processes that mpirun started; MPI must be running (MpiSession).
    static Ranks world();
    /// The processes of an MPI communicator, of which it takes a duplicate: messages do not mix with other people's.
    explicit Ranks(const Communicator& communicator);

    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] bool is_first() const { return rank_ == 0; }
    /// For those who speak MPI themselves; there must be several ranks.
    [[nodiscard]] const Communicator& communicator() const { return *communicator_; }

    /// NaN if it is NaN on any rank.
    [[nodiscard]] double largest(double value) const;
    [[nodiscard]] double smallest(double value) const { return -largest(-value); }
    /// Entry by entry; as many on every rank.
    void largest(std::span<double> values) const;
    [[nodiscard]] bool any(bool value) const;
    [[nodiscard]] std::int64_t sum(std::int64_t value) const;
    /// Entry by entry; as many on every rank.
    void sum(std::span<std::int64_t> values) const;
    /// Adds the other ranks' sums: the same bits however the summands are spread over ranks.
    void sum(ExactSum& value) const;
    /// The same entry by entry, in one message; as many on every rank.
    void sum(std::span<ExactSum> values) const;

    /// The first rank's on every rank.
    template <Sendable T>
    void broadcast(std::vector<T>& values) const {
        values.resize(static_cast<std::size_t>(first_ranks(static_cast<std::int64_t>(values.size()))));
        broadcast_bytes(std::as_writable_bytes(std::span(values)));
    }
    void broadcast(std::string& text) const;

    /// Every rank's values, rank by rank.
    template <Sendable T>
    [[nodiscard]] std::vector<T> all_gather(std::span<const T> values) const {
        const std::vector<std::int64_t> counts = all_counts(static_cast<std::int64_t>(values.size()));
        std::vector<T> all(static_cast<std::size_t>(std::accumulate(counts.begin(), counts.end(), std::int64_t{0})));
        all_gather_bytes(std::as_bytes(values), counts, sizeof(T), std::as_writable_bytes(std::span(all)));
        return all;
    }

    /// Values for each rank, to_each[rank], which may be empty; what each rank sent to this one. Differs by rank.
    template <Sendable T>
    [[nodiscard]] std::vector<std::vector<T>> exchange(const std::vector<std::vector<T>>& to_each) const {
        std::vector<std::int64_t> counts;
        std::vector<std::span<const std::byte>> sent;
        for (const std::vector<T>& values : to_each) {
            counts.push_back(static_cast<std::int64_t>(values.size()));
            sent.push_back(std::as_bytes(std::span(values)));
        }
        std::vector<std::vector<T>> from_each(to_each.size());
        std::vector<std::span<std::byte>> received;
        for (std::size_t other = 0; const std::int64_t count : exchange_counts(counts)) {
            from_each[other].resize(static_cast<std::size_t>(count));
            received.push_back(std::as_writable_bytes(std::span(from_each[other++])));
        }
        exchange_bytes(sent, received);
        return from_each;
    }

    /// Every rank's values, rank by rank, on the first rank; nothing on the others.
    template <Sendable T>
    [[nodiscard]] std::vector<T> gather_to_first(std::span<const T> values) const {
        std::vector<std::vector<T>> to_each(static_cast<std::size_t>(size_));
        to_each[0].assign(values.begin(), values.end());
        std::vector<T> all;
        for (const std::vector<T>& part : exchange(to_each)) all.insert(all.end(), part.begin(), part.end());
        return all;
    }

    // Vectors are not deduced as spans.
    template <Sendable T>
    [[nodiscard]] std::vector<T> all_gather(const std::vector<T>& values) const {
        return all_gather(std::span<const T>(values));
    }
    template <Sendable T>
    [[nodiscard]] std::vector<T> gather_to_first(const std::vector<T>& values) const {
        return gather_to_first(std::span<const T>(values));
    }

  private:
    Ranks() = default;

    [[nodiscard]] std::int64_t first_ranks(std::int64_t value) const;
    void broadcast_bytes(std::span<std::byte> bytes) const;
    [[nodiscard]] std::vector<std::int64_t> all_counts(std::int64_t count) const;
    void all_gather_bytes(std::span<const std::byte> own, const std::vector<std::int64_t>& counts, std::size_t size,
                          std::span<std::byte> all) const;
    [[nodiscard]] std::vector<std::int64_t> exchange_counts(const std::vector<std::int64_t>& counts) const;
    void exchange_bytes(const std::vector<std::span<const std::byte>>& sent,
                        const std::vector<std::span<std::byte>>& received) const;

    std::shared_ptr<const Communicator> communicator_;  ///< none: alone
    int rank_ = 0;
    int size_ = 1;
};

/// Starts MPI, if mpirun started this process, and ends it again. One a process, around all that uses MPI. MPI is told
/// that only the thread that made the session will call it.
class MpiSession {
  public:
    MpiSession();
    ~MpiSession();
    MpiSession(const MpiSession&) = delete;
    MpiSession& operator=(const MpiSession&) = delete;

    /// True: mpirun (or another starter of MPI processes) started this process.
    static bool started_by_mpirun();
    /// All processes, or this one alone.
    [[nodiscard]] Ranks ranks() const;
    /// Ends all ranks at once with this exit code: for an error of one rank, which the others, waiting for it, do not
    /// see. Comes back only where this process runs alone.
    void end_all(int exit_code) const;

  private:
    bool running_ = false;  ///< MPI is, and this session ends it
};

}  // namespace dmp::solver
