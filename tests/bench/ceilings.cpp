#include "tests/bench/ceilings.h"

#include "energies/autodiff/pack.h"

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

namespace shellmatch::bench {

namespace {

using autodiff::Pack;
using autodiff::pack_size;

void rate(benchmark::State& state, const char* name, double billions) {
  state.counters[name] = benchmark::Counter(billions, benchmark::Counter::kIsIterationInvariantRate);
}

/// Cycles per second: additions of integers that wait for each other take one cycle each.
void clock(benchmark::State& state) {
  constexpr int n = 20000;
  long x = 1;
  for (auto _ : state)
    for (int i = 0; i < n; ++i) {
      x += x;
      asm volatile("" : "+r"(x));
    }
  benchmark::DoNotOptimize(x);
  rate(state, "gigahertz", 1e-9 * n);
}

/// Multiplications fused with additions, in registers; `n_additions` plain ones beside every twelve of them.
template <int n_additions>
void flops(benchmark::State& state) {
  constexpr int n_chains = 12, n_rounds = 1000;
  std::array<Pack, n_chains> x;
  std::array<Pack, n_chains> y;
  for (int i = 0; i < n_chains; ++i) x[i] = y[i] = Pack{} + 1.0 + i;
  const Pack factor = Pack{} + 0.999999, summand = Pack{} + 1e-6;
  for (auto _ : state) {
    for (int round = 0; round < n_rounds; ++round)
      for (int i = 0; i < n_chains; ++i) {
        x[i] = x[i] * factor + summand;
        if (i < n_additions) y[i] = y[i] + summand;
      }
    benchmark::DoNotOptimize(x);
    benchmark::DoNotOptimize(y);
  }
  rate(state, "gflops", 1e-9 * n_rounds * (2 * n_chains + n_additions) * pack_size);
}

// Eight times the L3 cache of the machine of docs/performance.md.
constexpr std::size_t n_packs = std::size_t{1} << 22;
constexpr double array_bytes = static_cast<double>(n_packs * sizeof(Pack));

/// A sum over an array in memory.
void read(benchmark::State& state) {
  const std::vector<Pack> memory(n_packs, Pack{} + 1.0);
  for (auto _ : state) {
    std::array<Pack, 8> sums{};
    for (std::size_t i = 0; i < n_packs; i += 8)
      for (std::size_t k = 0; k < 8; ++k) sums[k] += memory[i + k];
    benchmark::DoNotOptimize(sums);
  }
  rate(state, "gbytes", 1e-9 * array_bytes);
}

/// a = b + 3 c, McCalpin's triad: two arrays read, one written.
void triad(benchmark::State& state) {
  std::vector<Pack> a(n_packs), b(n_packs, Pack{} + 1.0), c(n_packs, Pack{} + 2.0);
  for (auto _ : state) {
    for (std::size_t i = 0; i < n_packs; ++i) a[i] = b[i] + 3.0 * c[i];
    benchmark::ClobberMemory();
  }
  rate(state, "gbytes", 3e-9 * array_bytes);
}

}  // namespace

void register_ceilings() {
  benchmark::RegisterBenchmark("ceiling_clock", clock);
  benchmark::RegisterBenchmark("ceiling_fma", flops<0>);
  benchmark::RegisterBenchmark("ceiling_fma_and_add", flops<12>);
  benchmark::RegisterBenchmark("ceiling_read", read)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("ceiling_triad", triad)->Unit(benchmark::kMillisecond);
}

}  // namespace shellmatch::bench
