#include "energies/elements/band.h"

#include "base/error.h"
#include "base/parallel.h"
#include "energies/elements/cell_blocks.h"
#include "grid/fields/bump.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shellmatch {

namespace {

template <int Dim>
Mat<Dim> full_matrix(const std::array<double, n_symmetric<Dim>>& s) {
  Mat<Dim> m;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) m(i, j) = s[SmallSym<double, Dim>::slot(i, j)];
  return m;
}

template <int Dim>
Vec<Dim> position(const Element<Dim>& element, const Vec<Dim>& xi) {
  return element.corner + element.side * xi;
}

/// The reference's values at all quadrature points of an element, eight at a time.
template <int Dim>
class ElementValues {
 public:
  using Field = GeometryField<Dim>;
  ElementValues(const GeometryField<Dim>& reference, const ShapeTable<Dim>& shape)
      : reference_(&reference), shape_(&shape), packs_(n_chunks(shape.points.size(), autodiff::pack_size)) {}

  void read(const Element<Dim>& element) {
    constexpr std::size_t lanes = autodiff::pack_size;
    for (std::size_t p = 0; p < packs_.size(); ++p) {
      autodiff::Pack weight{};
      std::array<autodiff::Pack, Dim> y{};
      for (std::size_t lane = 0; lane < lanes && p * lanes + lane < shape_->points.size(); ++lane) {
        weight[lane] = 1;
        const Vec<Dim> x = position<Dim>(element, shape_->points[p * lanes + lane].xi);
        for (int k = 0; k < Dim; ++k) y[k][lane] = x[k];
      }
      reference_->look_up(weight, reference_->find(y), packs_[p].data());
    }
  }
  double distance(std::size_t q) const { return packs_[q / autodiff::pack_size][0][q % autodiff::pack_size]; }
  typename Field::Values at(std::size_t q) const {
    typename Field::Values values;
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = packs_[q / autodiff::pack_size][i][q % autodiff::pack_size];
    return values;
  }

 private:
  const Field* reference_;
  const ShapeTable<Dim>* shape_;
  std::vector<typename Field::Packs> packs_;
};

/// What can be said of an element from its centre's distance: |grad d| is 1, and less than 2 however it is interpolated.
enum class Membership { none, sure, unknown };

template <int Dim>
Membership membership(double distance_of_centre, const Element<Dim>& element, double nearest_point, double sigma) {
  const double d = std::abs(distance_of_centre);
  if (d > sigma + std::sqrt(double(Dim)) * element.side) return Membership::none;
  return d + 2 * nearest_point * element.side < sigma ? Membership::sure : Membership::unknown;
}

/// The reference's distance at the centres of up to eight elements.
template <int Dim>
autodiff::Pack centre_distances(std::span<const Element<Dim>> elements, const GeometryField<Dim>& reference) {
  autodiff::Pack weight{};
  std::array<autodiff::Pack, Dim> y{};
  for (std::size_t lane = 0; lane < elements.size(); ++lane) {
    weight[lane] = 1;
    const Vec<Dim> centre = position<Dim>(elements[lane], Vec<Dim>::Constant(0.5));
    for (int k = 0; k < Dim; ++k) y[k][lane] = centre[k];
  }
  typename GeometryField<Dim>::Packs values;
  reference.look_up(weight, reference.find(y), values.data());
  return values[0];
}

}  // namespace

template <int Dim>
std::array<double, Band<Dim>::n_reference> Band<Dim>::reference_point(
    const typename GeometryField<Dim>::Values& at_point, bool root_is_inverse) {
  Vec<Dim> n1;
  std::array<double, n_symmetric<Dim>> root;
  for (int k = 0; k < Dim; ++k) n1[k] = at_point[1 + k];
  for (int i = 0; i < n_symmetric<Dim>; ++i) root[i] = at_point[1 + Dim + i];
  n1 /= std::max(n1.norm(), least_normal_length);  // as renormalised() does for the template
  const Mat<Dim> p = Mat<Dim>::Identity() - n1 * n1.transpose();
  Mat<Dim> r = full_matrix<Dim>(root);
  if (!root_is_inverse) r = r.inverse().eval();
  r = (p * r * p).eval();
  std::array<double, n_reference> flat;
  flat[0] = at_point[0];
  for (int k = 0; k < Dim; ++k) flat[1 + k] = n1[k];
  for (int i = 0; i < Dim; ++i)
    for (int j = i; j < Dim; ++j)
      flat[1 + Dim + SmallSym<double, Dim>::slot(i, j)] = 0.5 * (r(i, j) + r(j, i));
  return flat;
}

template <int Dim>
Band<Dim>::Band(std::span<const Element<Dim>> elements, const ShapeTable<Dim>& shape,
                const GeometryField<Dim>& reference, bool root_is_inverse, double sigma)
    : n_points_(shape.points.size()) {
  double nearest_point = std::numeric_limits<double>::infinity();  // of the quadrature's, to the centre
  for (const auto& q : shape.points) nearest_point = std::min(nearest_point, (q.xi - Vec<Dim>::Constant(0.5)).norm());
  std::vector<char> is_member(elements.size(), 0);
  parallel_chunks(elements.size(), 64, [&](const Chunk& chunk) {
    ElementValues<Dim> values(reference, shape);
    autodiff::Pack distance{};
    for (std::size_t e = chunk.begin; e < chunk.end; ++e) {
      const std::size_t lane = (e - chunk.begin) % n_lanes, n = std::min<std::size_t>(n_lanes, chunk.end - e);
      if (lane == 0) distance = centre_distances(elements.subspan(e, n), reference);
      const Membership known = membership(distance[lane], elements[e], nearest_point, sigma);
      is_member[e] = known == Membership::sure;
      if (known != Membership::unknown) continue;
      values.read(elements[e]);
      for (std::size_t q = 0; q < n_points_ && !is_member[e]; ++q)
        is_member[e] = std::abs(values.distance(q)) < sigma;
    }
  });
  const std::size_t of_block = cells_per_block(elements.size());
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (e % of_block == 0) first_batch_.push_back(batches_.size());
    if (!is_member[e]) continue;
    if (batches_.size() == first_batch_.back() || batches_.back().n_elements == n_lanes) {
      batches_.push_back({.element = {}, .n_elements = 0});
      batches_.back().element.fill(static_cast<Index>(e));
    }
    Batch& batch = batches_.back();
    batch.element[batch.n_elements++] = static_cast<Index>(e);
    ++n_elements_;
  }
  first_batch_.push_back(batches_.size());
  points_.resize(batches_.size() * n_points_);

  struct Sums {
    double measure = 0;
    std::size_t n_active = 0;
    Sums& operator+=(const Sums& o) {
      measure += o.measure;
      n_active += o.n_active;
      return *this;
    }
  };
  const Sums sums = parallel_sum(batches_.size(), 256, Sums{}, [&](const Chunk& chunk) {
    Sums sum;
    ElementValues<Dim> values(reference, shape);
    for (std::size_t b = chunk.begin; b < chunk.end; ++b) {
      const Batch& batch = batches_[b];
      for (int lane = 0; lane < n_lanes; ++lane) {
        const Element<Dim>& element = elements[batch.element[lane]];
        values.read(element);
        double volume = 1;
        for (int k = 0; k < Dim; ++k) volume *= element.side;
        for (std::size_t q = 0; q < n_points_; ++q) {
          const auto flat = reference_point(values.at(q), root_is_inverse);
          Point& point = points_[b * n_points_ + q];
          const bool counts = lane < batch.n_elements;
          point.weight[lane] = counts ? bump(flat[0], sigma) * volume * shape.points[q].weight : 0.0;
          sum.measure += point.weight[lane];
          sum.n_active += counts && std::abs(flat[0]) < sigma;
          for (int i = 0; i < n_reference; ++i) point.reference[i][lane] = flat[i];
        }
      }
    }
    return sum;
  });
  measure_ = sums.measure;
  n_active_points_ = sums.n_active;
}

template class Band<2>;
template class Band<3>;

}  // namespace shellmatch
