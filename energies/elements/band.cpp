#include "energies/elements/band.h"

#include "base/error.h"
#include "base/parallel.h"
#include "energies/densities/small_matrix.h"
#include "energies/elements/cell_blocks.h"
#include "grid/fields/bump.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace shellmatch {

namespace {

template <int Dim, class T>
SmallMat<T, Dim> inverse(const SmallMat<T, Dim>& a) {
  const SmallMat<T, Dim> c = cofactor(a);
  T determinant = a(0, 0) * c(0, 0);
  for (int j = 1; j < Dim; ++j) determinant += a(0, j) * c(0, j);
  const T factor = 1.0 / determinant;
  SmallMat<T, Dim> result;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) result(i, j) = factor * c(j, i);
  return result;
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
      : reference_(&reference), shape_(&shape), packs_(n_chunks(shape.points.size(), autodiff::pack_size)) {
    for (int i = 0; i < shape.points_per_direction; ++i)
      along_axis_.push_back(shape.points[static_cast<std::size_t>(i)].xi[0]);
  }

  /// The last point fills up the last pack.
  void read(const Element<Dim>& element) {
    if (reference_->look_up_cube(element.corner, element.side, along_axis_, packs_)) return;
    constexpr std::size_t lanes = autodiff::pack_size;
    for (std::size_t p = 0; p < packs_.size(); ++p) {
      std::array<autodiff::Pack, Dim> y;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const Vec<Dim> x =
            position<Dim>(element, shape_->points[std::min(p * lanes + lane, shape_->points.size() - 1)].xi);
        for (int k = 0; k < Dim; ++k) y[k][lane] = x[k];
      }
      reference_->look_up(autodiff::Pack{} + 1.0, reference_->find(y), packs_[p].data());
    }
  }
  double distance(std::size_t q) const { return packs_[q / autodiff::pack_size][0][q % autodiff::pack_size]; }
  std::span<const typename Field::Packs> packs() const { return packs_; }

 private:
  const Field* reference_;
  const ShapeTable<Dim>* shape_;
  std::vector<double> along_axis_;  ///< positions of the points on the unit cell
  std::vector<typename Field::Packs> packs_;
};

/// What can be said of an element from its centre's distance: |grad d| is 1, and less than 2 however it is
/// interpolated.
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
template <class T>
std::array<T, Band<Dim>::n_reference> Band<Dim>::reference_point(
    const std::array<T, GeometryField<Dim>::n_values>& at_point, bool root_is_inverse) {
  T square = at_point[1] * at_point[1];
  for (int k = 1; k < Dim; ++k) square += at_point[1 + k] * at_point[1 + k];
  const T length = autodiff::max_of(autodiff::root_of(square),
                                    T{} + least_normal_length);  // as renormalised() does for the template
  SmallVec<T, Dim> n1;
  for (int k = 0; k < Dim; ++k) n1[k] = at_point[1 + k] / length;
  SmallMat<T, Dim> p, root;
  for (int i = 0; i < Dim; ++i)
    for (int j = 0; j < Dim; ++j) {
      p(i, j) = (i == j ? 1.0 : 0.0) - n1[i] * n1[j];
      root(i, j) = at_point[1 + Dim + SmallSym<double, Dim>::slot(i, j)];
    }
  const SmallMat<T, Dim> r = product<Dim>(product<Dim>(p, root_is_inverse ? root : inverse(root)), p);
  std::array<T, n_reference> flat;
  flat[0] = at_point[0];
  for (int k = 0; k < Dim; ++k) flat[1 + k] = n1[k];
  for (int i = 0; i < Dim; ++i)
    for (int j = i; j < Dim; ++j) flat[1 + Dim + SmallSym<double, Dim>::slot(i, j)] = 0.5 * (r(i, j) + r(j, i));
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
      for (std::size_t q = 0; q < n_points_ && !is_member[e]; ++q) is_member[e] = std::abs(values.distance(q)) < sigma;
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
        const bool counts = lane < batch.n_elements;
        for (std::size_t first = 0; first < n_points_; first += n_lanes) {
          const auto at_points = reference_point(values.packs()[first / n_lanes], root_is_inverse);
          for (std::size_t q = first; q < std::min(first + n_lanes, n_points_); ++q) {
            Point& point = points_[b * n_points_ + q];
            for (int i = 0; i < n_reference; ++i) point.kept[i][lane] = static_cast<float>(at_points[i][q - first]);
            const double d = at_points[0][q - first];
            point.weight[lane] = counts ? bump(d, sigma) * volume * shape.points[q].weight : 0.0;
            sum.measure += point.weight[lane];
            sum.n_active += counts && std::abs(d) < sigma;
          }
        }
      }
    }
    return sum;
  });
  measure_ = sums.measure;
  n_active_points_ = sums.n_active;
}

template <int Dim>
Index Band<Dim>::lane_of(std::size_t element) const {
  const auto e = static_cast<Index>(element);
  const auto after = std::ranges::upper_bound(batches_, e, {}, [](const Batch& b) { return b.element[0]; });
  if (after == batches_.begin()) return no_index;
  const Batch& batch = *std::prev(after);
  for (int lane = 0; lane < batch.n_elements; ++lane)
    if (batch.element[lane] == e) return static_cast<Index>(&batch - batches_.data()) * n_lanes + lane;
  return no_index;
}

template class Band<2>;
template class Band<3>;
template std::array<double, Band<2>::n_reference> Band<2>::reference_point(
    const std::array<double, GeometryField<2>::n_values>&, bool);
template std::array<double, Band<3>::n_reference> Band<3>::reference_point(
    const std::array<double, GeometryField<3>::n_values>&, bool);

}  // namespace shellmatch
