// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parallel/ranks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "base/errors.hpp"
#include "solver/parallel/communicator.hpp"

namespace dmp::solver {

namespace {

constexpr int exchange_tag = 1;

/// MPI counts are of type int: long messages are sent in pieces.
constexpr std::size_t piece = std::size_t{1} << 30;

template <class Bytes, class Transfer>
void in_pieces(Bytes bytes, const Transfer& transfer) {
    for (std::size_t begin = 0; begin < bytes.size(); begin += piece) {
        const auto part = bytes.subspan(begin, std::min(piece, bytes.size() - begin));
        transfer(part.data(), static_cast<int>(part.size()));
    }
}

int mpi_count(std::int64_t count) {
    if (count > std::numeric_limits<int>::max())
        throw ResourceError("the ranks send too many values in one MPI call: " + std::to_string(count),
                            "Use a coarser spacing, or write less at once.");
    return static_cast<int>(count);
}

}  // namespace

Ranks::Ranks(const Communicator& communicator) {
    Communicator own;
    MPI_Comm_dup(communicator.handle, &own.handle);
    MPI_Comm_rank(own.handle, &rank_);
    MPI_Comm_size(own.handle, &size_);
    communicator_ = std::shared_ptr<const Communicator>(new Communicator(own), [](const Communicator* held) {
        int ended = 0;
        MPI_Finalized(&ended);
        MPI_Comm handle = held->handle;
        if (ended == 0) MPI_Comm_free(&handle);
        delete held;
    });
}

Ranks Ranks::world() { return Ranks(Communicator{MPI_COMM_WORLD}); }

double Ranks::largest(double value) const {
    largest(std::span(&value, 1));
    return value;
}

void Ranks::largest(std::span<double> values) const {
    if (size_ == 1) return;
    // The result of MPI_MAX with a NaN is undefined, so NaN is sent as a separate flag.
    const std::size_t count = values.size();
    std::vector<double> marked(2 * count);
    for (std::size_t k = 0; k < count; ++k) {
        const bool is_nan = std::isnan(values[k]);
        marked[k] = is_nan ? -std::numeric_limits<double>::infinity() : values[k];
        marked[count + k] = is_nan ? 1 : 0;
    }
    MPI_Allreduce(MPI_IN_PLACE, marked.data(), mpi_count(static_cast<std::int64_t>(marked.size())), MPI_DOUBLE, MPI_MAX,
                  communicator_->handle);
    for (std::size_t k = 0; k < count; ++k)
        values[k] = marked[count + k] > 0 ? std::numeric_limits<double>::quiet_NaN() : marked[k];
}

bool Ranks::any(bool value) const {
    if (size_ == 1) return value;
    int flag = value ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &flag, 1, MPI_INT, MPI_LOR, communicator_->handle);
    return flag != 0;
}

std::int64_t Ranks::sum(std::int64_t value) const {
    sum(std::span(&value, 1));
    return value;
}

void Ranks::sum(std::span<std::int64_t> values) const {
    if (size_ == 1) return;
    MPI_Allreduce(MPI_IN_PLACE, values.data(), mpi_count(static_cast<std::int64_t>(values.size())), MPI_INT64_T,
                  MPI_SUM, communicator_->handle);
}

void Ranks::sum(ExactSum& value) const { sum(std::span(&value, 1)); }

void Ranks::sum(std::span<ExactSum> values) const {
    if (size_ == 1) return;
    std::vector<std::int64_t> words;
    words.reserve(values.size() * ExactSum::words);
    for (ExactSum& value : values)
        words.insert(words.end(), value.carried_words().begin(), value.carried_words().end());
    sum(words);
    auto next = words.begin();
    for (ExactSum& value : values) {
        ExactSum::Words own;
        std::copy_n(next, own.size(), own.begin());
        next += own.size();
        value = ExactSum();
        value.add_words(own);
    }
}

void Ranks::broadcast(std::string& text) const {
    std::vector<char> characters(text.begin(), text.end());
    broadcast(characters);
    text.assign(characters.begin(), characters.end());
}

std::int64_t Ranks::first_ranks(std::int64_t value) const {
    if (size_ > 1) MPI_Bcast(&value, 1, MPI_INT64_T, 0, communicator_->handle);
    return value;
}

void Ranks::broadcast_bytes(std::span<std::byte> bytes) const {
    if (size_ == 1) return;
    in_pieces(bytes,
              [this](std::byte* data, int count) { MPI_Bcast(data, count, MPI_BYTE, 0, communicator_->handle); });
}

std::vector<std::int64_t> Ranks::all_counts(std::int64_t count) const {
    std::vector<std::int64_t> counts(static_cast<std::size_t>(size_), count);
    if (size_ > 1) MPI_Allgather(&count, 1, MPI_INT64_T, counts.data(), 1, MPI_INT64_T, communicator_->handle);
    return counts;
}

void Ranks::all_gather_bytes(std::span<const std::byte> own, const std::vector<std::int64_t>& counts, std::size_t size,
                             std::span<std::byte> all) const {
    if (size_ == 1) {
        std::copy(own.begin(), own.end(), all.begin());
        return;
    }
    std::vector<int> count, first;
    std::int64_t sum = 0;
    for (const std::int64_t values : counts) {
        count.push_back(mpi_count(values));
        first.push_back(mpi_count(sum));
        sum += values;
    }
    MPI_Datatype value = MPI_DATATYPE_NULL;
    MPI_Type_contiguous(static_cast<int>(size), MPI_BYTE, &value);
    MPI_Type_commit(&value);
    MPI_Allgatherv(own.data(), count[static_cast<std::size_t>(rank_)], value, all.data(), count.data(), first.data(),
                   value, communicator_->handle);
    MPI_Type_free(&value);
}

std::vector<std::int64_t> Ranks::exchange_counts(const std::vector<std::int64_t>& counts) const {
    std::vector<std::int64_t> received = counts;
    if (size_ > 1) MPI_Alltoall(counts.data(), 1, MPI_INT64_T, received.data(), 1, MPI_INT64_T, communicator_->handle);
    return received;
}

void Ranks::exchange_bytes(const std::vector<std::span<const std::byte>>& sent,
                           const std::vector<std::span<std::byte>>& received) const {
    std::vector<MPI_Request> requests;
    const auto self = static_cast<std::size_t>(rank_);
    for (std::size_t other = 0; other < received.size(); ++other) {
        if (other == self) continue;
        in_pieces(received[other], [&](std::byte* data, int count) {
            MPI_Irecv(data, count, MPI_BYTE, static_cast<int>(other), exchange_tag, communicator_->handle,
                      &requests.emplace_back());
        });
    }
    for (std::size_t other = 0; other < sent.size(); ++other) {
        if (other == self) continue;
        in_pieces(sent[other], [&](const std::byte* data, int count) {
            MPI_Isend(data, count, MPI_BYTE, static_cast<int>(other), exchange_tag, communicator_->handle,
                      &requests.emplace_back());
        });
    }
    std::copy(sent[self].begin(), sent[self].end(), received[self].begin());
    if (!requests.empty()) MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

MpiSession::MpiSession() {
    if (!started_by_mpirun()) return;
    int provided = MPI_THREAD_SINGLE;
    // Otherwise hwloc queries display :0 for graphics cards and ends with it: another dmp process may use that
    // display briefly to render its pictures.
    setenv("HWLOC_COMPONENTS", "-gl", 0);
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    if (provided < MPI_THREAD_FUNNELED) {
        MPI_Finalize();
        throw ResourceError("this MPI does not support threads",
                            "Install an MPI with MPI_THREAD_FUNNELED, such as Debian's Open MPI.");
    }
    running_ = true;
}

MpiSession::~MpiSession() {
    if (running_) MPI_Finalize();
}

bool MpiSession::started_by_mpirun() {
    return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr || std::getenv("PMI_SIZE") != nullptr;
}

Ranks MpiSession::ranks() const { return running_ ? Ranks::world() : Ranks::alone(); }

void MpiSession::end_all(int exit_code) const {
    if (running_) MPI_Abort(MPI_COMM_WORLD, exit_code);
}

}  // namespace dmp::solver
