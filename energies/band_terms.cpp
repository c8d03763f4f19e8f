// The inner loop of the program: match, membrane and bending at eight quadrature points at a time.

#include "energies/band_kernel.h"
#include "energies/element_batch.h"
#include "energies/matching_energy.h"

namespace shellmatch {

namespace {

using autodiff::Pack;
using autodiff::pack_size;

/// Where eight points are mapped to, and Dphi there.
template <int Dim>
struct Image {
  typename GeometryField<Dim>::Spots spots;
  std::array<Pack, Dim * Dim> dphi;
  Image(const GeometryField<Dim>& target, const ElementBatch<Dim>& batch,
        const typename ShapeTable<Dim>::Point& shape) {
    std::array<Pack, Dim> y;
    batch.evaluate(shape, y, dphi.data());
    spots = target.find(y);
  }
};

/// Template and Dphi at eight points: the functors' active arguments. What does not count must not become
/// NaN.
template <int Dim, bool WithGradient>
void look_up(const GeometryField<Dim>& target, const Pack& weight, const Image<Dim>& image, PointArrays<Dim>& p) {
  if constexpr (WithGradient)
    target.look_up(weight, image.spots, p.active.data(), p.derivative);
  else
    target.look_up(weight, image.spots, p.active.data());
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j)
      p.active[PointArrays<Dim>::n_target + i * Dim + j] =
          weight > 0 ? image.dphi[i * Dim + j] : Pack{} + (i == j ? 1.0 : 0.0);
}

}  // namespace

template <int Dim>
template <bool WithGradient>
void MatchingEnergy<Dim>::add_band_terms(const Chunk& patch, std::span<const Vec<Dim>> phi, const TermValues& weights,
                                         TermValues& values, double* gradients, BandSums* band) const {
  constexpr int n_target = PointArrays<Dim>::n_target;
  constexpr int n_reference = ReferencePoint<Dim, double>::size;
  if (!(band || weights[Term::match] > 0 || weights[Term::membrane] > 0 || weights[Term::bending] > 0)) return;
  const auto elements = elements_;
  const auto batches = band_.batches();
  const TermKernel<Dim> other_membrane = comparison_kernel<Dim, WithGradient>(options_.membrane);
  const TermKernel<Dim> other_bending = comparison_kernel<Dim, WithGradient>(options_.bending);

  ElementBatch<Dim> batch;
  PointArrays<Dim> p;
  p.passive[n_reference] = Pack{} + options_.lambda;
  p.passive[n_reference + 1] = Pack{} + options_.mu;
  std::array<Pack, 3> sums{};
  const auto [first, last] = band_.batches_of(patch.index);
  for (std::size_t b = first; b < last; ++b) {
    batch.load(elements, phi, [&](int lane) { return batches[b].element[lane]; });
    batch.clear_gradient();
    if (b + 1 < last) batch.prefetch(elements, phi, [&](int lane) { return batches[b + 1].element[lane]; });
    Image<Dim> next(*target_, batch, shape_.points.front());
    for (std::size_t q = 0; q < shape_.points.size(); ++q) {
      const auto& point = band_.point(b, q);
      const auto& shape = shape_.points[q];
      band_.prefetch_after(b, q);
      const Image<Dim> image = next;  // the following is found while this one is worked on
      if (q + 1 < shape_.points.size()) next = Image<Dim>(*target_, batch, shape_.points[q + 1]);
      if (autodiff::sum_lanes(point.weight) == 0) continue;
      look_up<Dim, WithGradient>(*target_, point.weight, image, p);
      for (int i = 0; i < n_reference; ++i) p.passive[i] = point.reference[i];
      if (band) band->add<Dim>(point.weight, p.passive.data() + 1, p.active.data() + 1, p.active.data() + n_target);
      if constexpr (WithGradient) p.adjoint.fill(Pack{});
      if (weights[Term::match] > 0)
        sums[0] += apply_term<BandFunctor<Match<Dim>, Dim>, Dim, WithGradient>(
            p, point.weight * weights[Term::match]);
      if (weights[Term::membrane] > 0) {
        const Pack seed = point.weight * weights[Term::membrane];
        sums[1] += other_membrane ? other_membrane(p, seed)
                                  : apply_term<BandFunctor<Membrane<Dim>, Dim>, Dim, WithGradient>(p, seed);
      }
      if (weights[Term::bending] > 0) {
        const Pack seed = point.weight * weights[Term::bending];
        sums[2] += other_bending ? other_bending(p, seed)
                                 : apply_term<BandFunctor<Bending<Dim>, Dim>, Dim, WithGradient>(p, seed);
      }
      if constexpr (WithGradient) {
        std::array<Pack, Dim> by_position;
        for (int k = 0; k < Dim; ++k) {
          by_position[k] = p.adjoint[0] * p.derivative[k][0];
          for (int i = 1; i < n_target; ++i) by_position[k] += p.adjoint[i] * p.derivative[k][i];
        }
        batch.add_adjoint(shape, by_position, p.adjoint.data() + n_target);
      }
    }
    if constexpr (WithGradient)
      for (int lane = 0; lane < batches[b].n_elements; ++lane) {
        double* out = gradients + (static_cast<std::size_t>(batches[b].element[lane]) - patch.begin) * batch.n_dofs;
        for (int i = 0; i < batch.n_dofs; ++i) out[i] += batch.gradient[i][lane];
      }
  }
  for (int t = 0; t < 3; ++t) values.v[t] = autodiff::sum_lanes(sums[t]);
}

template void MatchingEnergy<2>::add_band_terms<true>(const Chunk&, std::span<const Vec<2>>, const TermValues&,
                                                    TermValues&, double*, BandSums*) const;
template void MatchingEnergy<2>::add_band_terms<false>(const Chunk&, std::span<const Vec<2>>, const TermValues&,
                                                    TermValues&, double*, BandSums*) const;
template void MatchingEnergy<3>::add_band_terms<true>(const Chunk&, std::span<const Vec<3>>, const TermValues&,
                                                    TermValues&, double*, BandSums*) const;
template void MatchingEnergy<3>::add_band_terms<false>(const Chunk&, std::span<const Vec<3>>, const TermValues&,
                                                    TermValues&, double*, BandSums*) const;

}  // namespace shellmatch
