#pragma once
/// \file
/// Inputs to the recorded energy terms, generic and degenerate, and the checks on each of them: by packs, as they are
/// evaluated. That numbers give the same is checked on small functors with every operation (autodiff_test.cpp), and on
/// one term (compiled/example_test.cpp).

#include "energies/terms/term_functors.h"
#include "tests/energies/autodiff/compiled_against_jets.h"
#include "tests/energies/terms/term_types.h"

#include <algorithm>
#include <random>

namespace shellmatch::test {

/// The term's own options at one of eight points: their defaults, or others.
template <class Term>
std::array<double, Term::own.size()> own_at(int lane) {
  auto own = other_options<Term>();
  if (lane % 2)
    for (std::size_t i = 0; i < own.size(); ++i) own[i] = Term::own[i].value;
  return own;
}

/// Eight points each: the first generic, the second without normal, the third without Dphi and root, the fourth
/// without mismatch, the others generic. The value, and the argument with its derivative.
template <IsBandTerm Term>
void check_recorded() {
  using Functor = PointFunctor<Term>;
  using Argument = PointArgument<Term>;
  constexpr int Dim = Term::dim, n_own = static_cast<int>(Term::own.size());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int repeat = 0; repeat < 10; ++repeat) {
    std::array<Inputs<Functor>, autodiff::pack_size> points;
    for (int lane = 0; lane < autodiff::pack_size; ++lane) {
      auto& p = points[lane];
      for (double& x : p.active) x = uniform(random);
      for (double& x : p.passive) x = uniform(random);
      // Last come lambda, mu and the term's own options.
      for (int i = 1; i <= 2; ++i) p.passive[Functor::n_passive - n_own - i] = 1.5 + uniform(random);
      const auto own = own_at<Term>(lane);
      std::copy(own.begin(), own.end(), p.passive.end() - n_own);
      if (lane == 1) std::fill_n(p.active.begin() + 1, Dim, 0.0);
      if (lane == 2) std::fill(p.active.begin() + 1 + Dim, p.active.end(), 0.0);
      if (lane == 3) p.active[0] = p.passive[0];
    }
    expect_as_jets<Functor, MadeFor::packs>(points);
    std::array<Inputs<Argument>, autodiff::pack_size> same;
    for (int lane = 0; lane < autodiff::pack_size; ++lane) same[lane] = {points[lane].active, points[lane].passive};
    expect_jacobian_as_jets<Argument, MadeFor::packs>(same);
  }
  expect_good_tape<Functor>();
  expect_good_tape<Argument>();
}

/// Generic Dphi, the identity, one that folds and one of rank 0.
template <IsCellTerm Term>
void check_recorded() {
  using Functor = PointFunctor<Term>;
  constexpr int Dim = Term::dim;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-0.3, 0.3);
  for (int repeat = 0; repeat < 10; ++repeat) {
    std::array<Inputs<Functor>, autodiff::pack_size> points;
    for (int lane = 0; lane < autodiff::pack_size; ++lane) {
      auto& p = points[lane];
      for (int i = 0; i < Dim * Dim; ++i) p.active[i] = (i % (Dim + 1) == 0) + (lane == 1 ? 0.0 : uniform(random));
      for (int i = 0; i < 2; ++i) p.passive[i] = 1 + uniform(random);
      const auto own = own_at<Term>(lane);
      std::copy(own.begin(), own.end(), p.passive.begin() + 2);
      if (lane == 2)
        for (int i = 0; i < Dim; ++i) p.active[i] = -p.active[i];
      if (lane == 3) p.active.fill(0);
    }
    expect_as_jets<Functor, MadeFor::packs>(points);
  }
  expect_good_tape<Functor>();
}

/// Cells near and far from folding, the undeformed one, one that is flat and one that is turned inside out.
template <IsCornerTerm Term>
void check_recorded() {
  using Functor = CornerFunctor<Term>;
  constexpr int Dim = Term::dim;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-0.15, 0.15);
  for (int repeat = 0; repeat < 10; ++repeat) {
    std::array<Inputs<Functor>, autodiff::pack_size> points;
    for (int lane = 0; lane < autodiff::pack_size; ++lane) {
      auto& p = points[lane];
      for (int i = 0; i < Functor::n_active; ++i)
        p.active[i] = ((i / Dim) >> (i % Dim) & 1) + (lane == 1 ? 0.0 : uniform(random));
      const auto own = own_at<Term>(lane);
      p.passive[1] = p.passive[2] = 1;
      p.passive[0] = Term::scale(1.0, Material<double>{1, 1, own.data()});
      std::copy(own.begin(), own.end(), p.passive.begin() + 3);
      for (int i = 0; i < Functor::n_active; i += Dim) {
        if (lane == 2) p.active[i] = -p.active[i];
        if (lane == 3) p.active[i] = 0;
      }
    }
    // The terms of the sum are inverse to small determinants: their derivatives lose digits.
    expect_as_jets<Functor, MadeFor::packs>(points, 1e-11);
  }
  expect_good_tape<Functor>();
}

}  // namespace shellmatch::test
