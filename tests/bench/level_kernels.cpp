// What one evaluation of the energy, its gradient and Newton's model costs on the finest grid of a cascade,
// in nanoseconds of CPU time for each active quadrature point of the band; beside it the same gradient by
// dual numbers on the element (ceres::Jet, 24 derivatives in space), the machine's ceilings, and the gain of
// a second thread.
//
// Usage: level_kernels [--pair=REFERENCE,TEMPLATE] [--level=N] [--serve] [--benchmark_...]
//        hand/rest,hand/bent and 8 if not given; --benchmark_filter, --benchmark_format=json and so on are
//        Google Benchmark's

#include "base/large_vector.h"
#include "base/parallel.h"
#include "tests/bench/ceilings.h"
#include "tests/bench/traffic.h"
#include "energies/assembly/ceres_evaluator.h"
#include "energies/terms/term_names.h"
#include "matching/cascade/schedule.h"
#include "matching/derivative_check/check_state.h"
#include "matching/level/level_energy.h"
#include "matching/level/shape_fields.h"
#include "matching/input/shape_pair.h"

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <iostream>
#include <memory>
#include <random>

namespace {

using namespace shellmatch;

struct Silent : Observer {};

double cpu_seconds() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// The finest level of a cascade, at a smooth random deformation.
struct Kernels {
  ExperimentOptions options;
  std::optional<SignedDistance<3>> d1, d2;
  std::optional<Octree<3>> grid;
  std::optional<ShapeFields<3>> shapes;
  std::unique_ptr<LevelEnergy<3>> level;
  std::vector<Vec<3>> phi;
  TermValues weights;
  std::vector<double> gradient, direction;
  double grid_seconds;  ///< CPU time of all threads for grid, distances, coefficients and what the energy
                        ///< precomputes

  Kernels(const std::string& reference, const std::string& target, int finest) {
    options.input.reference = "generate:" + reference;
    options.input.template_file = "generate:" + target;
    options.input.placement = PlacementKind::as_is;
    options.cascade.max_level = finest;
    Silent silent;
    AnyShapePair any = open_shape_pair(options.input, options.landmarks, silent);
    auto& pair = std::get<ShapePair<3>>(any);
    pair.place(options);
    const double begin = cpu_seconds();
    d1.emplace(pair.reference.surface);
    d2.emplace(pair.template_shape.surface);
    shapes.emplace(*d1, *d2, options);
    grid.emplace(options.cascade.min_level);
    shapes->compute_distances(*grid);
    for (int l = options.cascade.min_level; l < finest; ++l) {
      shapes->refine(*grid);
      shapes->compute_distances(*grid);
    }
    level = std::make_unique<LevelEnergy<3>>(*grid, shapes->geometry(*grid), options);
    grid_seconds = cpu_seconds() - begin;
    phi = positions_of<3>(CheckState::parse("random:0.01"), *level, options.energy, {});
    const ScheduleStep step = schedule_of_level(options.cascade, finest).back();
    weights = term_weights(options.energy, step.nu, step.volume_weight);
    gradient.resize(level->unknowns.size());
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (std::size_t i = 0; i < gradient.size(); ++i) direction.push_back(normal(random));
  }
  std::size_t points() const { return level->energy.band().n_active_points(); }
};
std::unique_ptr<Kernels> kernels;

/// One kernel: a call of it, and how many points or nodes a call is for.
struct Kernel {
  const char* name;
  const char* counter;
  std::size_t n;
  bool has_threads;
  std::function<void()> call;
};

/// The energy with the band terms alone: neither volume nor barrier, which every cell of the grid has.
TermValues band_weights() {
  TermValues weights = kernels->weights;
  weights["volume"_term] = weights["barrier"_term] = 0;
  return weights;
}

void evaluate(const TermValues& weights, std::span<double> gradient) {
  TermValues values;
  kernels->level->energy.evaluate(kernels->phi, weights, values, gradient);
  benchmark::DoNotOptimize(values);
  benchmark::DoNotOptimize(gradient.data());
}

/// Every 64th element of the band, whose gradient ceres::Jet gives: one derivative for each of its 24 positions.
struct Duals {
  CeresEvaluator<3> costs;
  TermValues weights = band_weights();
  std::vector<std::size_t> elements;
  std::size_t n_points = 0;

  Duals() : costs(kernels->level->energy) {
    std::size_t n_seen = 0;
    for (std::size_t e = 0; e < kernels->level->unknowns.elements().size(); ++e)
      if (const auto points = costs.band_points(e); !points.empty() && n_seen++ % 64 == 0) {
        elements.push_back(e);
        n_points += points.size();
      }
  }
  void operator()() const {
    CeresEvaluator<3>::Dofs g;
    for (const std::size_t e : elements) {
      benchmark::DoNotOptimize(costs.gradient(weights, e, costs.dofs_of(e, kernels->phi), g));
      benchmark::DoNotOptimize(g);
    }
  }
};

/// A product with Newton's matrix, which is assembled at the first.
struct Product {
  LargeVector<double> x{kernels->direction.begin(), kernels->direction.end()}, y;  // as in Newton's linear solver
  void operator()() {
    auto& hessian = kernels->level->hessian;
    if (y.empty()) hessian.assemble(kernels->phi, kernels->weights);
    y.resize(x.size());
    hessian.apply(x, y);
    benchmark::DoNotOptimize(y.data());
  }
};

std::vector<Kernel> all_kernels() {
  const std::size_t points = kernels->points(), nodes = kernels->level->unknowns.nodes().size();
  const auto duals = std::make_shared<Duals>();
  const char* by_point = "cpu_ns_per_point";
  return {
      {"value", by_point, points, true, [] { evaluate(kernels->weights, {}); }},
      {"gradient", by_point, points, true, [] { evaluate(kernels->weights, kernels->gradient); }},
      {"band_gradient", by_point, points, true, [] { evaluate(band_weights(), kernels->gradient); }},
      {"band_gradient_by_duals", by_point, duals->n_points, false, [duals] { (*duals)(); }},
      {"newton_model", by_point, points, true,
       [] { kernels->level->hessian.assemble(kernels->phi, kernels->weights); }},
      {"newton_product", "cpu_ns_per_free_node", nodes, true, Product{}},
  };
}

/// Counts CPU time of all threads for each of a kernel's points or nodes.
void measure(benchmark::State& state, const Kernel& kernel) {
  set_n_threads(static_cast<int>(state.range(0)));
  kernel.call();
  const double begin = cpu_seconds();
  for (auto _ : state) kernel.call();
  const double seconds = cpu_seconds() - begin;
  state.counters[kernel.counter] =
      1e9 * seconds / (static_cast<double>(state.iterations()) * static_cast<double>(kernel.n));
  set_n_threads(0);
}

/// One call for each line of standard input, `KERNEL THREADS`; answers with nanoseconds for a point or node, of CPU
/// time and of wall time. So another process can call two builds in turn.
int serve() {
  const auto all = all_kernels();
  fmt::print("ready\n");
  std::fflush(stdout);
  std::string name;
  for (int threads = 0; std::cin >> name >> threads;) {
    const auto kernel = std::ranges::find(all, name, &Kernel::name);
    if (kernel == all.end() || threads < 1) {
      fmt::print(stderr, "level_kernels: no kernel '{}', or no number of threads\n", name);
      return 2;
    }
    set_n_threads(threads);
    const double cpu = cpu_seconds();
    const auto wall = std::chrono::steady_clock::now();
    kernel->call();
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - wall;
    const double n = 1e-9 * static_cast<double>(kernel->n);
    fmt::print("{:.3f} {:.3f}\n", (cpu_seconds() - cpu) / n, passed.count() / n);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::string pair = "hand/rest,hand/bent";
  int level = 8;
  bool serves = false;
  std::vector<char*> rest{argv[0]};
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.starts_with("--pair=") && word.find(',') != std::string::npos) pair = word.substr(7);
    else if (word.starts_with("--level=")) level = std::atoi(word.c_str() + 8);
    else if (word == "--serve") serves = true;
    else rest.push_back(argv[i]);
  }
  int n_rest = static_cast<int>(rest.size());
  benchmark::Initialize(&n_rest, rest.data());
  if (benchmark::ReportUnrecognizedArguments(n_rest, rest.data()) || level < 3 || level > 12) {
    fmt::print(stderr,
               "usage: level_kernels [--pair=REFERENCE,TEMPLATE] [--level=3..12] [--serve] [--benchmark_...]\n");
    return 2;
  }
  try {
    const auto comma = pair.find(',');
    kernels = std::make_unique<Kernels>(pair.substr(0, comma), pair.substr(comma + 1), level);
  } catch (const std::exception& error) {
    fmt::print(stderr, "level_kernels: {}\n", error.what());
    return 2;
  }
  if (serves) return serve();
  fmt::print("{} level {}: {} nodes, {} free, {} cells, {} of them in the band, {} active points\n", pair, level,
             kernels->grid->n_nodes(), kernels->level->unknowns.nodes().size(), kernels->grid->leaves().size(),
             kernels->level->energy.band().n_elements(), kernels->points());
  // Into the report of --benchmark_out; bytes for one evaluation.
  const bench::Traffic traffic = bench::traffic_of(*kernels->level);
  for (const auto& [name, bytes] : {std::pair<const char*, double>{"value_bytes", traffic.value},
                                    {"gradient_bytes", traffic.gradient},
                                    {"band_gradient_bytes", traffic.band_gradient},
                                    {"newton_model_bytes", traffic.newton_model},
                                    {"newton_product_bytes", traffic.newton_product},
                                    {"blocks", traffic.n_blocks},
                                    {"grid_microseconds", 1e6 * kernels->grid_seconds}})
    benchmark::AddCustomContext(name, fmt::format("{:.0f}", bytes));
  for (const auto& [name, count] : {std::pair<const char*, std::size_t>{"nodes", kernels->grid->n_nodes()},
                                    {"free_nodes", kernels->level->unknowns.nodes().size()},
                                    {"cells", kernels->grid->leaves().size()},
                                    {"band_cells", kernels->level->energy.band().n_elements()},
                                    {"active_points", kernels->points()}})
    benchmark::AddCustomContext(name, std::to_string(count));
  for (const Kernel& kernel : all_kernels()) {
    auto* b = benchmark::RegisterBenchmark(kernel.name, measure, kernel)
                  ->Unit(benchmark::kMillisecond)
                  ->UseRealTime()
                  ->Arg(1)
                  ->ArgName("threads");
    if (kernel.has_threads) b->Arg(2);
  }
  bench::register_ceilings();
  benchmark::RunSpecifiedBenchmarks();
}
