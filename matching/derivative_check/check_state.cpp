#include "matching/derivative_check/check_state.h"

#include "energies/terms/term_names.h"

#include "base/error.h"
#include "energies/assembly/folds.h"
#include "grid/octree/constraints.h"
#include "matching/derivative_check/random_field.h"
#include "matching/level/shape_fields.h"

#include <charconv>
#include <filesystem>

namespace shellmatch {

namespace {

template <class T>
bool read_number(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return !text.empty() && error == std::errc() && end == text.data() + text.size();
}

/// Moves every node at random, by the largest multiple of `noise` that keeps det Dphi above `bound` in every cell.
template <int Dim>
void add_noise(const LevelEnergy<Dim>& level, const std::vector<Vec<Dim>>& noise, double bound,
               std::vector<Vec<Dim>>& phi) {
  const auto with = [&](double share) {
    std::vector<Vec<Dim>> moved = phi;
    for (std::size_t i = 0; i < phi.size(); ++i) moved[i] += share * noise[i];
    return moved;
  };
  double low = 0, high = 1;
  for (int step = 0; step < 12; ++step) {
    const double middle = 0.5 * (low + high);
    const bool fits = find_folds<Dim>(level.unknowns.elements(), with(middle)).lower_bound >= bound;
    (fits ? low : high) = middle;
  }
  phi = with(low);
}

}  // namespace

CheckState CheckState::parse(const std::string& text) {
  CheckState state;
  if (text == "identity") {
    state.kind = Kind::identity;
  } else if (text.starts_with("random:")) {
    const std::string_view numbers = std::string_view(text).substr(7);
    const std::size_t colon = numbers.find(':');
    if (!read_number(numbers.substr(0, colon), state.amplitude) || !(state.amplitude >= 0 && state.amplitude <= 1) ||
        (colon != std::string_view::npos && !read_number(numbers.substr(colon + 1), state.seed)))
      throw_input_error(
          "--state {}: expected random:AMPLITUDE or random:AMPLITUDE:SEED with 0 <= AMPLITUDE <= 1 in "
          "sides of the domain and an integer SEED >= 0, for example random:0.03:1",
          text);
  } else {
    if (!std::filesystem::exists(text))
      throw_input_error(
          "--state {}: expected identity, random:AMPLITUDE, random:AMPLITUDE:SEED or the output folder of "
          "a run; there is no such folder",
          text);
    state.kind = Kind::folder;
    state.folder = text;
  }
  return state;
}

std::string CheckState::text() const {
  switch (kind) {
    case Kind::identity: return "identity";
    case Kind::random: return fmt::format("random:{}:{}", amplitude, seed);
    case Kind::folder: break;
  }
  return folder;
}

template <int Dim>
std::vector<Vec<Dim>> positions_of(const CheckState& state, const LevelEnergy<Dim>& level, const EnergyOptions& options,
                                   const std::optional<Deformation<Dim>>& found) {
  std::vector<Vec<Dim>> phi = identity_map(level.grid);
  if (state.kind == CheckState::Kind::identity) return phi;
  if (state.kind == CheckState::Kind::folder) {
    for (Index i = 0; i < level.grid.n_nodes(); ++i) phi[i] = found->apply_in_unit_domain(phi[i]);
    distribute(level.grid, phi);
    return phi;
  }
  std::mt19937 random(state.seed);
  const SmoothRandomField<Dim> field(random);
  const bool fixed = options.boundary == BoundaryCondition::dirichlet;
  std::vector<Vec<Dim>> noise(phi.size());
  for (Index i = 0; i < level.grid.n_nodes(); ++i) {
    const Vec<Dim> x = phi[i];
    double damping = 1;
    if (fixed)
      for (int k = 0; k < Dim; ++k) damping *= 4 * x[k] * (1 - x[k]);
    phi[i] += state.amplitude * damping * field(x);
    for (double& n : noise[i])
      n = (fixed && level.grid.is_boundary_node(i) ? 0 : 0.4) * level.grid.finest_side() * random_unit(random);
  }
  distribute(level.grid, phi);
  distribute(level.grid, noise);
  const double bound = options.terms.factor("barrier"_term) > 0 ? 0.5 * options.terms.own("fold_threshold") : 0.3;
  const double smooth_bound = find_folds<Dim>(level.unknowns.elements(), phi).lower_bound;
  if (!(smooth_bound > 0))
    throw_input_error("--state {}: a random deformation of this amplitude folds; choose a smaller one", state.text());
  if (state.amplitude > 0 && smooth_bound > bound) add_noise(level, noise, bound, phi);
  return phi;
}

SHELLMATCH_2D_3D(positions_of);

}  // namespace shellmatch
