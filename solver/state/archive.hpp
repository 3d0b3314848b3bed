// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/hdf5_file.hpp"
#include "base/simd/vector.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_store.hpp"

namespace dmp::solver {

/// Why a state is loaded: for its own run to go on, or for a new run with other values to start with.
enum class LoadedFor { going_on, new_run };

/// Saves a state to a checkpoint or loads it from one. A class with state lists each value once, for both directions:
///     void archive(Archive& file) { file("step", step_); file("time", time_); }
/// Values are the same on all ranks, and all ranks must call with the same names; particles are distributed. When
/// saving, only rank 0 has a file; when loading, every rank reads.
class Archive {
  public:
    /// `file` may be null on all ranks except rank 0.
    Archive(const Ranks& ranks, Hdf5Writer* file) : ranks_(ranks), writer_(file) {}
    Archive(const Ranks& ranks, const Hdf5Reader& file, LoadedFor purpose = LoadedFor::going_on)
        : ranks_(ranks), reader_(&file), purpose_(purpose) {}

    [[nodiscard]] bool loading() const { return reader_ != nullptr; }
    /// Whether it loads the state with which a new run starts. What a run counts and sums up from its start on, and
    /// what the state's own scene was judged by, stay as they are then.
    [[nodiscard]] bool starts_run() const { return loading() && purpose_ == LoadedFor::new_run; }

    void operator()(const std::string& name, double& value);
    void operator()(const std::string& name, std::int64_t& value);
    void operator()(const std::string& name, std::string& text);
    void operator()(const std::string& name, std::vector<double>& values);
    void operator()(const std::string& name, std::vector<Vector<double, 2>>& values);
    void operator()(const std::string& name, std::vector<Vector<double, 3>>& values);
    void operator()(const std::string& name, std::array<double, 3>& values);
    /// A group's owned particles with their tags and state fields. When loading, each rank gets a share, regardless
    /// of position. Throws InputError if the group's fields differ from those in the file.
    void operator()(const std::string& name, ParticleGroup& group);

    /// A value that is not part of the state, but without which the state would go on in another way. When loading,
    /// throws InputError, which calls it `what`, if it is another than that of the file. `key` of the scene gives
    /// it, in `unit`; "": none does.
    void same(const std::string& name, double value, const std::string& what, const std::string& key = "",
              const std::string& unit = "");

  private:
    /// The file to load from. Throws InputError if it has no such dataset: the run began without it.
    const Hdf5Reader& reader_of(const std::string& name) const;
    template <class T>
    void array(const std::string& name, std::vector<T>& values);
    template <int D>
    void vectors(const std::string& name, std::vector<Vector<double, D>>& values);
    template <class T, class Of>
    void save_of_all(const std::string& name, std::size_t owned, const Of& of);
    template <class T>
    std::vector<T> share(const std::string& name, std::uint64_t begin, std::uint64_t end) const;

    const Ranks& ranks_;
    Hdf5Writer* writer_ = nullptr;
    const Hdf5Reader* reader_ = nullptr;
    LoadedFor purpose_ = LoadedFor::going_on;
};

}  // namespace dmp::solver
