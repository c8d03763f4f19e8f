// Gradients by the order of the Taylor remainder: every term and model, both boundary conditions, in
// the plane and in space, on grids with hanging nodes; and the same check catches wrong gradients.

#include "energies/cost/element_cost.h"
#include "energies/terms/membrane.h"
#include "energies/terms/term_names.h"
#include "tests/energies/cost/element_sums.h"
#include "tests/energies/exact_shapes.h"
#include "tests/energies/matching_problem.h"
#include "tests/energies/terms/term_types.h"
#include "tests/support/taylor.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace shellmatch {
namespace {

using namespace test;

// The energy along phi + t v, where v is a random direction in the unknowns.
template <int Dim>
class Along {
 public:
  Along(const Problem<Dim>& problem, std::vector<Vec<Dim>> phi, const TermValues& weights, unsigned seed)
      : problem_(problem), phi_(std::move(phi)), weights_(weights), x_(problem.unknowns.size()), v_(x_.size()) {
    problem.unknowns.restrict_to(phi_, x_);
    const auto smooth = at_nodes<Dim>(problem.grid, smooth_field<Dim>(seed));
    problem.unknowns.restrict_to(smooth, v_);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-1, 1);
    for (double& v : v_) v += problem.grid.finest_side() * noise(random);
  }
  double operator()(double t) {
    std::vector<double> y(x_.size());
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = x_[i] + t * v_[i];
    problem_.unknowns.expand(y, phi_);
    const auto values = problem_.values(phi_, weights_);
    EXPECT_TRUE(values.has_value());
    return values ? values->sum() : 0;
  }
  std::vector<double> gradient() {
    problem_.unknowns.expand(x_, phi_);
    return problem_.gradient(phi_, weights_);
  }
  double derivative(const std::vector<double>& gradient) const {
    return std::inner_product(gradient.begin(), gradient.end(), v_.begin(), 0.0);
  }
  double derivative() { return derivative(gradient()); }

 private:
  const Problem<Dim>& problem_;
  std::vector<Vec<Dim>> phi_;
  TermValues weights_;
  std::vector<double> x_, v_;
};

template <class T>
struct Gradient : ::testing::Test {
  static constexpr int Dim = T::value;
  const Octree<Dim> grid = hanging_grid<Dim>(0.28);
  const ExactShape<Dim> reference = sphere<Dim>(0.28);

  // Calls body(problem, phi, term) for every term of the list, with other options than the defaults, and every boundary
  // condition.
  void for_each_term(const CoefficientFields<Dim>& target, double amplitude, auto&& body) const {
    for (const auto boundary : {BoundaryCondition::neumann, BoundaryCondition::dirichlet})
      for (const TermInfo& info : all_term_infos) {
        SCOPED_TRACE(fmt::format("{} {}, {}", info.name, info.model, enum_name(boundary)));
        const Term term = term_named(info.name);
        ProblemOptions o;
        o.energy.lambda = 0.7;
        o.energy.boundary = boundary;
        set_other_options(o.energy.terms);
        if (!info.model.empty()) o.energy.terms.model(term) = info.model;
        const Problem<Dim> problem(grid, exact_fields<Dim>(grid, reference), target, o);
        // Far enough for the barrier to act.
        const double size = term == "barrier"_term ? 3 * amplitude : amplitude;
        body(problem, deformed<Dim>(grid, size, 5, boundary == BoundaryCondition::dirichlet), term);
      }
  }
};
using Dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Gradient, Dimensions);

TYPED_TEST(Gradient, RemainderIsOfSecondOrderOverThreeDecades) {
  constexpr int D = TypeParam::value;
  this->for_each_term(linear_fields<D>(this->grid), 0.02, [](const auto& problem, const auto& phi, Term term) {
    for (unsigned seed = 1; seed <= 2; ++seed) {
      Along<D> line(problem, phi, only(term), seed);
      EXPECT_TRUE(has_derivative(line, line.derivative()));
    }
  });
}

// A curved target has kinks where a quadrature point passes into another cell. Near the identity all points are a
// fifth of a cell away from that, and the steps are shorter.
TYPED_TEST(Gradient, RemainderIsOfSecondOrderBetweenKinksOfACurvedTarget) {
  constexpr int D = TypeParam::value;
  const auto target = exact_fields<D>(this->grid, ellipsoid<D>(Vec<D>::LinSpaced(0.33, 0.24)));
  this->for_each_term(target, 0.1 * this->grid.finest_side(), [](const auto& problem, const auto& phi, Term term) {
    // Nothing is near folding there; the barrier has had its turn above.
    if (term == "barrier"_term) return;
    Along<D> line(problem, phi, only(term), 3);
    EXPECT_TRUE(has_derivative(line, line.derivative(), {.largest = 1e-3, .decades = 3}));
  });
}

// Splines have no kinks: points may pass into as many cells as they like, and a good many may lie on faces, where
// multilinear fields have no derivative.
TYPED_TEST(Gradient, RemainderIsOfSecondOrderAcrossCellsOfASmoothTarget) {
  constexpr int D = TypeParam::value;
  const auto reference_fields = exact_fields<D>(this->grid, this->reference);
  const auto target = exact_fields<D>(this->grid, ellipsoid<D>(Vec<D>::LinSpaced(0.33, 0.24)));
  const Problem<D> smooth(this->grid, reference_fields, target, {.smooth = true}),
      linear(this->grid, reference_fields, target);
  const double to_face = -smooth.energy.shape().points[0].xi[0] * this->grid.finest_side();
  const auto on_faces = at_nodes<D>(this->grid, [&](const Vec<D>& x) { return Vec<D>(x + to_face * Vec<D>::Unit(0)); });
  for (const Term term : {"match"_term, "membrane"_term, "bending"_term}) {
    SCOPED_TRACE(term_names()[static_cast<std::size_t>(term)]);
    Along<D> line(smooth, deformed<D>(this->grid, 0.02, 5), only(term), 2);
    EXPECT_TRUE(has_derivative(line, line.derivative()));
    EXPECT_FALSE(has_derivative(line, 1.01 * line.derivative()));
    Along<D> from_faces(smooth, on_faces, only(term), 2), with_kinks(linear, on_faces, only(term), 2);
    // The derivatives on both sides of a face agree up to single precision, which shorter steps would see.
    EXPECT_TRUE(has_derivative(from_faces, from_faces.derivative(), {.decades = 2}));
    EXPECT_FALSE(has_derivative(with_kinks, with_kinks.derivative()));
  }
}

TYPED_TEST(Gradient, OnePercentTooLongIsCaught) {
  constexpr int D = TypeParam::value;
  this->for_each_term(linear_fields<D>(this->grid), 0.02, [](const auto& problem, const auto& phi, Term term) {
    Along<D> line(problem, phi, only(term), 1);
    EXPECT_FALSE(has_derivative(line, 1.01 * line.derivative()));
  });
}

// A band term whose derivative forgets that the coefficients are read at phi(x).
template <int Dim>
class FrozenMembrane {
 public:
  FrozenMembrane(const Problem<Dim>& problem, std::size_t batch, int lane, double side)
      : problem_(problem), batch_(batch), lane_(lane), side_(side) {}
  template <class T>
  bool operator()(const T* dofs, T* energy) const {
    *energy = T(0.0);
    for (std::size_t q = 0; q < problem_.energy.shape().points.size(); ++q) {
      const auto& point = problem_.energy.band().point(batch_, q);
      SmallVec<T, Dim> y;
      SmallMat<T, Dim> dphi;
      deformation_at<Dim>(dofs, problem_.energy.shape().points[q], side_, y, dphi);
      SmallVec<double, Dim> place;
      for (int k = 0; k < Dim; ++k) place[k] = autodiff::scalar_part(y[k]);
      const TargetPoint<Dim, double> p = problem_.target.template at<double>(place);
      TargetPoint<Dim, T> frozen;
      for (int k = 0; k < Dim; ++k) frozen.n2[k] = T(p.n2[k]);
      ReferencePoint<Dim, double> x{};
      for (int k = 0; k < Dim; ++k) x.n1[k] = point.reference(1 + k)[lane_];
      const Material<double> material{problem_.options.lambda, problem_.options.mu};
      *energy += point.weight[lane_] * band_density<Membrane<Dim>>(frozen, dphi, x, material);
    }
    return true;
  }

 private:
  const Problem<Dim>& problem_;
  std::size_t batch_;
  int lane_;
  double side_;
};

TYPED_TEST(Gradient, AForgottenDerivativeOfTheLookUpIsCaught) {
  constexpr int D = TypeParam::value;
  const Problem<D> problem(this->grid, exact_fields<D>(this->grid, this->reference), linear_fields<D>(this->grid));
  const auto phi = deformed<D>(this->grid, 0.03, 5);
  ElementSum<D> sum{problem, phi};
  const auto& band = problem.energy.band();
  const auto elements = problem.unknowns.elements();
  for (std::size_t b = 0; b < band.batches().size(); ++b)
    for (int lane = 0; lane < band.batches()[b].n_elements; ++lane) {
      const auto& element = elements[band.batches()[b].element[lane]];
      sum.add(element, FrozenMembrane<D>(problem, b, lane, element.side));
    }
  EXPECT_NEAR(sum.value, problem.value(phi, "membrane"_term), 1e-12);
  Along<D> line(problem, phi, only("membrane"_term), 1);
  EXPECT_TRUE(has_derivative(line, line.derivative()));
  EXPECT_FALSE(has_derivative(line, line.derivative(sum.gradient())));
  // Match depends on phi by the look-up alone: forgetting it leaves no derivative.
  Along<D> match(problem, phi, only("match"_term), 1);
  EXPECT_FALSE(has_derivative(match, 0.0));
}

}  // namespace
}  // namespace shellmatch
