// Second derivatives of the band terms, eight elements at a time.

#include "energies/hessian/band_variables.h"
#include "energies/hessian/energy_hessian.h"
#include "energies/elements/sum_factorised_evaluator.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace shellmatch {

namespace {

using autodiff::Pack;
/// What the matrix is kept in. Two points are summed at a time, the second in the upper half.
typedef float FloatPack __attribute__((vector_size(sizeof(float) * autodiff::pack_size)));
typedef float TwoPoints __attribute__((vector_size(2 * sizeof(FloatPack))));

/// Unit vectors along the template's normals; where there is none any one serves.
template <int Dim>
std::array<Pack, Dim> unit_normal(const Pack* n) {
  Pack square{};
  for (int k = 0; k < Dim; ++k) square += n[k] * n[k];
  const Pack length = autodiff::root_of(square);
  std::array<Pack, Dim> unit;
  for (int k = 0; k < Dim; ++k)
    unit[k] = autodiff::where_greater(length, Pack{} + 1e-9, n[k] / length, Pack{} + (k == 0 ? 1.0 : 0.0));
  return unit;
}

/// Modes of two points: the columns of V^T L, where h = L L^T and V is the derivative of the variables by the element's
/// degrees of freedom.
template <class Variables, int Dim>
class Modes {
 public:
  static constexpr int n_dofs = n_corners<Dim> * Dim, n_variables = Variables::n;

  /// Of the first or the second point.
  void set(int half, const BandModelPoint<Dim>& at, const SquarePack<n_variables>& h,
           const typename ShapeTable<Dim>::Point& q, const Pack& inverse_side) {
    const auto l = cholesky<n_variables>(h);
    const Pack root_weight = autodiff::root_of(at.weight);
    // The factor is lower triangular: the first `mode` entries of a mode are 0.
    const auto set_mode = [&]<int Mode>(std::integral_constant<int, Mode>) __attribute__((always_inline)) {
      constexpr bool moves_dphi = Mode < Variables::n_dphi;
      std::array<Pack, n_variables> direction{};
      for (int v = Mode; v < n_variables; ++v) direction[v] = l[v][Mode];
      std::array<std::array<Pack, Dim>, Dim> dphi{};
      if constexpr (moves_dphi) {
        Variables::template dphi_of<Mode>(at, direction, dphi);
        for (int a = 0; a < Dim; ++a)
          for (int d = 0; d < Dim; ++d) dphi[a][d] *= root_weight * inverse_side;
      }
      // Component a of corner c moves row a of Dphi by grad N_c, and phi_a by N_c.
      for (int a = 0; a < Dim; ++a) {
        const Pack of_phi = root_weight * direction[Variables::n_dphi + a];
        for (int c = 0; c < n_corners<Dim>; ++c) {
          Pack s = q.n[c] * of_phi;
          if constexpr (moves_dphi)
            for (int d = 0; d < Dim; ++d) s += q.dn[c][d] * dphi[a][d];
          modes_[c * Dim + a][Mode].half[half] = __builtin_convertvector(s, FloatPack);
        }
      }
    };
    [&]<int... Mode>(std::integer_sequence<int, Mode...>) __attribute__((always_inline)) {
      (set_mode(std::integral_constant<int, Mode>{}), ...);
    }
    (std::make_integer_sequence<int, n_variables>{});
  }
  void clear(int half) {
    for (auto& row : modes_)
      for (auto& entry : row) entry.half[half] = FloatPack{};
  }

  /// Adds weight V^T (L L^T) V to the matrices of eight elements, each as ElementMatrices stores it.
  void add_squares_to(std::array<TwoPoints, ElementMatrices<Dim>::n_block_entries>& k) const {
    // A block at a time: its sums stay in registers.
    TwoPoints* block = k.data();
    for (int c = 0; c < n_corners<Dim>; ++c)
      for (int d = c; d < n_corners<Dim>; ++d, block += Dim * Dim) {
        std::array<TwoPoints, Dim * Dim> sum;
        for (int i = 0; i < Dim * Dim; ++i) sum[i] = block[i];
        for (int mode = 0; mode < n_variables; ++mode)
          for (int column = 0; column < Dim; ++column)
            for (int row = 0; row < Dim; ++row)
              sum[column * Dim + row] += modes_[c * Dim + row][mode].both * modes_[d * Dim + column][mode].both;
        for (int i = 0; i < Dim * Dim; ++i) block[i] = sum[i];
      }
  }

 private:
  union Entry {
    TwoPoints both;
    FloatPack half[2];
  };
  std::array<std::array<Entry, n_variables>, n_dofs> modes_;
};

}  // namespace

template <int Dim>
template <class Variables>
void EnergyHessian<Dim>::add_band_terms(const Chunk& cells, std::span<const Vec<Dim>> phi, const TermValues& weights,
                                        ElementMatrices<Dim>& matrices) const {
  using Arrays = PointArrays<Dim>;
  constexpr int n_entries = ElementMatrices<Dim>::n_block_entries;
  struct Acting {
    const BandCode<Dim>* code;
    const double* own;
    const UserFields<Dim>* own_fields;  ///< null where it has none
    double weight;
  };
  const EnergyTerms<Dim>& terms = energy_->terms();
  std::vector<Acting> acting;
  int n_own_fields = 0;
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (const auto* code = std::get_if<BandCode<Dim>>(&terms[t].term.code); code && weights[t] > 0) {
      const auto& fields = terms[t].own_fields;
      acting.push_back({code, terms[t].own.data(), fields.empty() ? nullptr : &fields, weights[t]});
      n_own_fields = std::max(n_own_fields, fields.n_components());
    }
  if (acting.empty()) return;
  const auto elements = unknowns_->elements();
  const Band<Dim>& band = energy_->band();
  const GeometryField<Dim>& target = energy_->target();
  const auto& points = energy_->shape().points;

  ElementBatch<Dim> batch;
  SumFactorisedEvaluator<Dim> evaluator(energy_->shape());
  Arrays p;
  std::vector<Pack> own_fields(static_cast<std::size_t>(n_own_fields));
  p.own_fields = own_fields.data();
  p.passive[Arrays::n_reference] = Pack{} + terms[0].material.lambda;
  p.passive[Arrays::n_reference + 1] = Pack{} + terms[0].material.mu;
  std::array<TwoPoints, n_entries> k;
  Modes<Variables, Dim> modes;
  const auto [first, last] = band.batches_of(cells.index);
  for (std::size_t b = first; b < last; ++b) {
    const auto& members = band.batches()[b];
    batch.load(elements, phi, [&](int lane) { return members.element[lane]; });
    if (b + 1 < last) batch.prefetch(elements, phi, [&](int lane) { return band.batches()[b + 1].element[lane]; });
    evaluator.evaluate(batch);
    k.fill(TwoPoints{});
    int n_set = 0;
    for (std::size_t q = 0; q < points.size(); ++q) {
      const auto& point = band.point(b, q);
      if (autodiff::sum_lanes(point.weight) == 0) continue;
      const auto position = evaluator.position(q);
      target.look_up(point.weight, target.find(position), p.active.data(), p.derivative);
      std::ranges::copy(position, p.active.begin() + Arrays::n_without_phi);
      evaluator.jacobian(q, p.active.data() + Arrays::n_target);
      for (int i = 0; i < Arrays::n_reference; ++i) p.passive[i] = point.reference(i);
      std::array<Pack, Dim> n1;
      for (int a = 0; a < Dim; ++a) n1[a] = point.reference(1 + a);
      const auto t1 = tangent_basis<Dim>(n1), t2 = tangent_basis<Dim>(unit_normal<Dim>(p.active.data() + 1));
      const BandModelPoint<Dim> at{p, point.weight, t1, t2};
      SquarePack<Variables::n> h{};
      for (const Acting& term : acting) {
        if (term.own_fields)
          term.own_fields->read(
              elements, [&](int lane) { return members.element[lane]; }, energy_->shape(), q, own_fields.data());
        Variables::add(*term.code, at, term.weight, term.own, h);
      }
      // Lanes without weight may hold anything: an infinity would outlive the multiplication by zero.
      for (int i = 0; i < Variables::n; ++i)
        for (int j = 0; j <= i; ++j)
          h[i][j] = autodiff::where_greater(point.weight, Pack{}, h[i][j], Pack{} + (i == j ? 1.0 : 0.0));
      modes.set(n_set++, at, h, points[q], batch.inverse_side);
      if (n_set == 2) {
        modes.add_squares_to(k);
        n_set = 0;
      }
    }
    if (n_set == 1) {
      modes.clear(1);
      modes.add_squares_to(k);
    }
    for (int lane = 0; lane < members.n_elements; ++lane) {
      std::array<float, n_entries> of_element;
      for (int i = 0; i < n_entries; ++i) of_element[i] = k[i][lane] + k[i][lane + autodiff::pack_size];
      matrices.add(static_cast<std::size_t>(members.element[lane]) - cells.begin, of_element);
    }
  }
}

#define SHELLMATCH_INSTANTIATE(Dim, Variables)                                                              \
  template void EnergyHessian<Dim>::add_band_terms<Variables<Dim>>(const Chunk&, std::span<const Vec<Dim>>, \
                                                                   const TermValues&, ElementMatrices<Dim>&) const;
SHELLMATCH_INSTANTIATE(2, TangentVariables)
SHELLMATCH_INSTANTIATE(2, AllVariables)
SHELLMATCH_INSTANTIATE(3, TangentVariables)
SHELLMATCH_INSTANTIATE(3, AllVariables)
#undef SHELLMATCH_INSTANTIATE

}  // namespace shellmatch
