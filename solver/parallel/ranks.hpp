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

/// Types that can be sent between ranks as raw bytes.
template <class T>
concept Sendable = std::is_trivially_copyable_v<T>;

/// The processes of a run and their communication. All functions except rank(), size() and is_first() must be called
/// by all ranks, in the same order; each returns the same value on all ranks unless stated otherwise. On one rank no
/// MPI is called. Copies of a Ranks refer to the same ranks.
class Ranks {
  public:
    /// This process alone; MPI need not be running.
    static Ranks alone() { return {}; }
    /// All processes that mpirun started; MPI must be running (MpiSession).
    static Ranks world();
    /// The processes of an MPI communicator, which is duplicated: messages do not mix with those of other users.
    explicit Ranks(const Communicator& communicator);

    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] bool is_first() const { return rank_ == 0; }
    /// For direct calls of MPI; there must be several ranks.
    [[nodiscard]] const Communicator& communicator() const { return *communicator_; }

    /// NaN if it is NaN on any rank.
    [[nodiscard]] double largest(double value) const;
    [[nodiscard]] double smallest(double value) const { return -largest(-value); }
    /// Entry by entry; every rank must pass the same number of values.
    void largest(std::span<double> values) const;
    [[nodiscard]] bool any(bool value) const;
    [[nodiscard]] std::int64_t sum(std::int64_t value) const;
    /// Entry by entry; every rank must pass the same number of values.
    void sum(std::span<std::int64_t> values) const;
    /// Adds the sums of all ranks. The result has the same bits for any distribution of the summands over ranks.
    void sum(ExactSum& value) const;
    /// The same entry by entry, in one message; every rank must pass the same number of values.
    void sum(std::span<ExactSum> values) const;

    /// Copies rank 0's values to all ranks.
    template <Sendable T>
    void broadcast(std::vector<T>& values) const {
        values.resize(static_cast<std::size_t>(first_ranks(static_cast<std::int64_t>(values.size()))));
        broadcast_bytes(std::as_writable_bytes(std::span(values)));
    }
    void broadcast(std::string& text) const;

    /// The values of all ranks, in the order of the ranks.
    template <Sendable T>
    [[nodiscard]] std::vector<T> all_gather(std::span<const T> values) const {
        const std::vector<std::int64_t> counts = all_counts(static_cast<std::int64_t>(values.size()));
        std::vector<T> all(static_cast<std::size_t>(std::accumulate(counts.begin(), counts.end(), std::int64_t{0})));
        all_gather_bytes(std::as_bytes(values), counts, sizeof(T), std::as_writable_bytes(std::span(all)));
        return all;
    }

    /// Sends to_each[rank], which may be empty, to each rank; returns the values received from each rank. The result
    /// differs between ranks.
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

    /// The values of all ranks on rank 0, in the order of the ranks; empty on the others.
    template <Sendable T>
    [[nodiscard]] std::vector<T> gather_to_first(std::span<const T> values) const {
        std::vector<std::vector<T>> to_each(static_cast<std::size_t>(size_));
        to_each[0].assign(values.begin(), values.end());
        std::vector<T> all;
        for (const std::vector<T>& part : exchange(to_each)) all.insert(all.end(), part.begin(), part.end());
        return all;
    }

    // Vectors do not convert to spans in template argument deduction.
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

    std::shared_ptr<const Communicator> communicator_;  ///< null on a single rank
    int rank_ = 0;
    int size_ = 1;
};

/// Initialises MPI, if mpirun started this process, and finalises it. Make one per process, around all use of MPI.
/// MPI is initialised for calls from this thread only.
class MpiSession {
  public:
    MpiSession();
    ~MpiSession();
    MpiSession(const MpiSession&) = delete;
    MpiSession& operator=(const MpiSession&) = delete;

    /// True if mpirun (or another starter of MPI processes) started this process.
    static bool started_by_mpirun();
    /// All processes, or this one alone if mpirun did not start it.
    [[nodiscard]] Ranks ranks() const;
    /// Ends all ranks at once with this exit code: for an error on one rank, which the others, waiting for it, cannot
    /// detect. Returns only if this process runs alone.
    void end_all(int exit_code) const;

  private:
    bool running_ = false;  ///< true if this session has initialised MPI
};

}  // namespace dmp::solver
