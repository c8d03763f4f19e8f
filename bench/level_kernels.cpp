// What one evaluation of the energy, its gradient and Newton's model costs on the finest grid of a cascade,
// in nanoseconds of CPU time for each active quadrature point of the band; beside it the same gradient by
// dual numbers on the element (ceres::Jet, 24 derivatives in space), the machine's ceilings, and the gain of
// a second thread.
//
// Usage: level_kernels [--pair=REFERENCE,TEMPLATE] [--level=N] [--benchmark_...]
//        hand/rest,hand/bent and 8 if not given; --benchmark_filter, --benchmark_format=json and so on are
//        Google Benchmark's

#include "base/large_vector.h"
#include "base/parallel.h"
#include "bench/ceilings.h"
#include "bench/traffic.h"
#include "energies/element_oracle.h"
#include "matching/cascade.h"
#include "matching/check_state.h"
#include "matching/level_energy.h"
#include "matching/shape_fields.h"
#include "matching/shape_pair.h"

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <ctime>
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
    AnyShapePair any = open_shape_pair(options.input, silent);
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

/// Runs `work` on state.range(0) threads; counts CPU time of all of them for each of `n` things.
void measure(benchmark::State& state, std::size_t n, const char* counter, const auto& work) {
  set_n_threads(static_cast<int>(state.range(0)));
  work();
  const double begin = cpu_seconds();
  for (auto _ : state) work();
  const double seconds = cpu_seconds() - begin;
  state.counters[counter] =
      1e9 * seconds / (static_cast<double>(state.iterations()) * static_cast<double>(n));
  set_n_threads(0);
}

void value(benchmark::State& state) {
  TermValues values;
  measure(state, kernels->points(), "cpu_ns_per_point", [&] {
    kernels->level->energy.evaluate(kernels->phi, kernels->weights, values, {});
    benchmark::DoNotOptimize(values);
  });
}

void gradient(benchmark::State& state) {
  TermValues values;
  measure(state, kernels->points(), "cpu_ns_per_point", [&] {
    kernels->level->energy.evaluate(kernels->phi, kernels->weights, values, kernels->gradient);
    benchmark::DoNotOptimize(kernels->gradient.data());
  });
}

/// The band terms alone: neither volume nor barrier, which every cell of the grid has.
void band_gradient(benchmark::State& state) {
  TermValues values, weights = kernels->weights;
  weights[Term::volume] = weights[Term::barrier] = 0;
  measure(state, kernels->points(), "cpu_ns_per_point", [&] {
    kernels->level->energy.evaluate(kernels->phi, weights, values, kernels->gradient);
    benchmark::DoNotOptimize(kernels->gradient.data());
  });
}

/// The same by ceres::Jet on every 64th element of the band: one derivative for each of its 24 positions.
void band_gradient_by_duals(benchmark::State& state) {
  const auto& level = *kernels->level;
  const ElementOracle<3> oracle(level.energy, level.unknowns, level.geometry.target, kernels->options.energy);
  TermValues weights = kernels->weights;
  weights[Term::volume] = weights[Term::barrier] = 0;
  std::vector<std::size_t> elements;
  std::size_t n_points = 0, n_seen = 0;
  for (std::size_t e = 0; e < level.unknowns.elements().size(); ++e)
    if (const auto points = oracle.band_points(e); !points.empty() && n_seen++ % 64 == 0) {
      elements.push_back(e);
      n_points += points.size();
    }
  measure(state, n_points, "cpu_ns_per_point", [&] {
    ElementOracle<3>::Dofs g;
    for (const std::size_t e : elements) {
      benchmark::DoNotOptimize(oracle.gradient(weights, e, oracle.dofs_of(e, kernels->phi), g));
      benchmark::DoNotOptimize(g);
    }
  });
}

void newton_model(benchmark::State& state) {
  measure(state, kernels->points(), "cpu_ns_per_point",
          [&] { kernels->level->hessian.assemble(kernels->phi, kernels->weights); });
}

void newton_product(benchmark::State& state) {
  auto& hessian = kernels->level->hessian;
  hessian.assemble(kernels->phi, kernels->weights);
  const LargeVector<double> x(kernels->direction.begin(), kernels->direction.end());  // as in Newton's linear solver
  LargeVector<double> y(x.size());
  measure(state, kernels->level->unknowns.nodes().size(), "cpu_ns_per_free_node", [&] {
    hessian.apply(x, y);
    benchmark::DoNotOptimize(y.data());
  });
}

}  // namespace

int main(int argc, char** argv) {
  std::string pair = "hand/rest,hand/bent";
  int level = 8;
  std::vector<char*> rest{argv[0]};
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.starts_with("--pair=") && word.find(',') != std::string::npos)
      pair = word.substr(7);
    else if (word.starts_with("--level="))
      level = std::atoi(word.c_str() + 8);
    else
      rest.push_back(argv[i]);
  }
  int n_rest = static_cast<int>(rest.size());
  benchmark::Initialize(&n_rest, rest.data());
  if (benchmark::ReportUnrecognizedArguments(n_rest, rest.data()) || level < 3 || level > 12) {
    fmt::print(stderr,
               "usage: level_kernels [--pair=REFERENCE,TEMPLATE] [--level=3..12] [--benchmark_...]\n");
    return 2;
  }
  try {
    const auto comma = pair.find(',');
    kernels = std::make_unique<Kernels>(pair.substr(0, comma), pair.substr(comma + 1), level);
  } catch (const std::exception& error) {
    fmt::print(stderr, "level_kernels: {}\n", error.what());
    return 2;
  }
  fmt::print("{} level {}: {} nodes, {} free, {} cells, {} of them in the band, {} active points\n", pair,
             level, kernels->grid->n_nodes(), kernels->level->unknowns.nodes().size(),
             kernels->grid->leaves().size(), kernels->level->energy.band().n_elements(), kernels->points());
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
  const auto add = [](const char* name, void (*body)(benchmark::State&), bool threads) {
    auto* b = benchmark::RegisterBenchmark(name, body)
                  ->Unit(benchmark::kMillisecond)
                  ->UseRealTime()
                  ->Arg(1)
                  ->ArgName("threads");
    if (threads) b->Arg(2);
  };
  add("value", value, true);
  add("gradient", gradient, true);
  add("band_gradient", band_gradient, true);
  add("band_gradient_by_duals", band_gradient_by_duals, false);
  add("newton_model", newton_model, true);
  add("newton_product", newton_product, true);
  bench::register_ceilings();
  benchmark::RunSpecifiedBenchmarks();
}
