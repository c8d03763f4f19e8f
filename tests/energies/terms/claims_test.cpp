// What the terms of the list and their densities say of themselves: that they forbid folds, that they are isotropic.

#include "energies/densities/positive_hessian.h"
#include "tests/energies/densities/random_matrices.h"
#include "tests/energies/terms/term_types.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace shellmatch {
namespace {

using namespace test;

/// Values of a term at random Dphi, each times a reflection where `folded`; of a corner term on the cell [0,1]^Dim
/// under Dphi.
template <class Term>
std::vector<double> values_at_random(bool folded) {
  constexpr int Dim = Term::dim;
  std::mt19937 random(Dim);
  const auto own = other_options<Term>();
  const Material<double> material{0.7, 1.3, own.data()};
  std::vector<double> values;
  for (int trial = 0; trial < 50; ++trial) {
    Mat<Dim> a = random_orientation_preserving<Dim>(random, 0.6, 1.7);
    if (folded) a.col(trial % Dim) *= trial % 2 ? -1.0 : 0.0;  // det A < 0, and det A = 0
    if constexpr (IsBandTerm<Term>) {
      const Vec<Dim> n1 = random_rotation<Dim>(random).col(0), n2 = random_rotation<Dim>(random).col(0);
      const auto unit = small_symmetric<Dim>(Mat<Dim>::Identity());
      values.push_back(band_density<Term>(TargetPoint<Dim, double>{0.1, small<Dim>(n2), unit}, small<double, Dim>(a),
                                          ReferencePoint<Dim, double>{0.2, small<Dim>(n1), unit}, material));
    } else if constexpr (IsCellTerm<Term>) {
      values.push_back(Term::Density::template value<double, double>(small<double, Dim>(a), material));
    } else {
      std::array<double, (1 << Dim) * Dim> corners;
      for (int corner = 0; corner < 1 << Dim; ++corner) {
        Vec<Dim> x;
        for (int k = 0; k < Dim; ++k) x[k] = corner >> k & 1;
        const Vec<Dim> y = a * x;
        for (int k = 0; k < Dim; ++k) corners[corner * Dim + k] = y[k];
      }
      std::array<double, 3 + Term::own.size()> passive{Term::scale(1.0, material), material.lambda, material.mu};
      std::copy(own.begin(), own.end(), passive.begin() + 3);
      values.push_back(CornerFunctor<Term>::template evaluate<double, double>(corners.data(), passive.data()));
    }
  }
  return values;
}

/// Is the term finite without folds, and with folds nowhere if it says that it forbids them, else everywhere?
template <class Term>
void check_folds() {
  const auto is_finite = [](double v) { return std::isfinite(v); };
  const auto without = values_at_random<Term>(false), with = values_at_random<Term>(true);
  EXPECT_TRUE(std::all_of(without.begin(), without.end(), is_finite));
  const auto n_finite = std::count_if(with.begin(), with.end(), is_finite);
  EXPECT_EQ(n_finite, Term::info.forbids_folds ? 0 : static_cast<long>(with.size()));
}

TEST(Claims, TermsThatForbidFoldsAreFiniteWithoutThemOnly) {
  const auto check = []<class Term>() {
    SCOPED_TRACE(TermTestNames::GetName<Term>(0));
    check_folds<Term>();
  };
  for_each_term(AllTerms<2>{}, check);
  for_each_term(AllTerms<3>{}, check);
}

/// W(Q A R) = W(A) for rotations Q and R?
template <class Density, int Dim>
bool is_isotropic(const Material<double>& material) {
  std::mt19937 random(Dim);
  for (int trial = 0; trial < 20; ++trial) {
    const Mat<Dim> a = random_orientation_preserving<Dim>(random, 0.6, 1.7);
    const Mat<Dim> turned = random_rotation<Dim>(random) * a * random_rotation<Dim>(random);
    const double expected = Density::value(small(a), material);
    if (!(std::abs(Density::value(small(turned), material) - expected) <= 1e-11 * (1 + std::abs(expected))))
      return false;
  }
  return true;
}

/// |A e1|^4 + det A: of no symmetry.
template <int Dim>
struct Anisotropic {
  template <class T, class P>
  static constexpr T value(const SmallMat<T, Dim>& a, const Material<P>&) {
    T along = a(0, 0) * a(0, 0);
    for (int i = 1; i < Dim; ++i) along = along + a(i, 0) * a(i, 0);
    return along * along + determinant(a);
  }
};

TEST(Claims, DensitiesThatSayTheyAreIsotropicAre) {
  int n_isotropic = 0;
  const auto check = [&]<class Term>() {
    if constexpr (detail::IsIsotropic<typename Term::Density>) {
      const auto own = other_options<Term>();
      EXPECT_TRUE((is_isotropic<typename Term::Density, Term::dim>({0.7, 1.3, own.data()})))
          << TermTestNames::GetName<Term>(0);
      ++n_isotropic;
    }
  };
  for_each_term(AllTerms<2>{}, check);
  for_each_term(AllTerms<3>{}, check);
  EXPECT_GT(n_isotropic, 0);
  EXPECT_FALSE((is_isotropic<Anisotropic<2>, 2>({0.7, 1.3})));
  EXPECT_FALSE((is_isotropic<Anisotropic<3>, 3>({0.7, 1.3})));
}

}  // namespace
}  // namespace shellmatch
