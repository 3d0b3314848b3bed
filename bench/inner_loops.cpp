// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// The inner loops by themselves, with Google Benchmark: inner_loops --benchmark_filter=NAME.
#include <benchmark/benchmark.h>

#include "bench/half_list.hpp"
#include "bench/start.hpp"
#include "bench/uses.hpp"
#include "models/sph/kernels.hpp"
#include "particles/cell_grid.hpp"

namespace {

using namespace dmp;
using namespace dmp::bench;

/// Distances from 0 to beyond the support, in no order.
std::vector<double> distances() {
    constexpr std::size_t count = 4096;
    std::vector<double> distances(count);
    for (std::size_t i = 0; i < count; ++i) distances[i] = 0.6 * (1 + noise(1, i, 0));
    return distances;
}

void count_items(benchmark::State& state, std::size_t each) {
    state.SetItemsProcessed(static_cast<std::int64_t>(static_cast<std::size_t>(state.iterations()) * each));
}

template <class Kernel>
void kernel_value(benchmark::State& state) {
    const Kernel kernel(1.0);
    const auto r = distances();
    for (auto _ : state) {
        double sum = 0;
        for (const double x : r) sum += kernel.value(x);
        benchmark::DoNotOptimize(sum);
    }
    count_items(state, r.size());
}

template <class Kernel>
void kernel_slope(benchmark::State& state) {
    const Kernel kernel(1.0);
    const auto r = distances();
    for (auto _ : state) {
        double sum = 0;
        for (const double x : r) sum += kernel.slope(x);
        benchmark::DoNotOptimize(sum);
    }
    count_items(state, r.size());
}

/// Arguments: dimension, disordered, support in tenths of the spacing.
Channel channel_of(const benchmark::State& state) {
    Channel channel;
    channel.dimension = static_cast<int>(state.range(0));
    channel.disordered = state.range(1) != 0;
    channel.support = 0.1 * static_cast<double>(state.range(2));
    return channel;
}

void half_list_sweep(benchmark::State& state) {
    const Channel channel = channel_of(state);
    const auto list =
        make_half_list(make_particles(channel), KernelKind::wendland_c2, channel.support * Liquid::spacing);
    for (auto _ : state) {
        list->sweep();
        benchmark::ClobberMemory();
    }
    count_items(state, list->particles());
}

void half_list_build(benchmark::State& state) {
    const Channel channel = channel_of(state);
    const ParticleSet set = make_particles(channel);
    for (auto _ : state)
        benchmark::DoNotOptimize(make_half_list(set, KernelKind::wendland_c2, channel.support * Liquid::spacing));
    count_items(state, set.size());
}

void cell_grid_build(benchmark::State& state) {
    const Channel channel = channel_of(state);
    const ParticleSet set = make_particles(channel);
    Coordinates points;
    for (int axis = 0; axis < channel.dimension; ++axis)
        for (const Vec& position : set.position) points[axis].push_back(position[axis]);
    for (auto _ : state) {
        const CellGrid grid(points, set.size(), channel.dimension, channel.support * Liquid::spacing);
        benchmark::DoNotOptimize(grid.order().data());
    }
    count_items(state, set.size());
}

void starts(benchmark::internal::Benchmark* benchmark) {
    benchmark->ArgNames({"dimension", "disordered", "support"});
    for (const auto& [dimension, support] : {std::pair{2, 25}, std::pair{3, 20}, std::pair{3, 25}})
        for (const int disordered : {0, 1}) benchmark->Args({dimension, disordered, support});
}

BENCHMARK(kernel_value<WendlandC2<2>>);
BENCHMARK(kernel_value<Lucy<2>>);
BENCHMARK(kernel_slope<WendlandC2<2>>);
BENCHMARK(kernel_slope<Lucy<2>>);
BENCHMARK(half_list_sweep)->Apply(starts)->Unit(benchmark::kMillisecond);
BENCHMARK(half_list_build)->Apply(starts)->Unit(benchmark::kMillisecond);
BENCHMARK(cell_grid_build)->Apply(starts)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
