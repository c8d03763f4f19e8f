#pragma once
/// \file
/// The compiled code of a recorded functor against the same functor on ceres::Jet, and what a good tape is.

#include "energies/autodiff/compiled.h"
#include "energies/autodiff/jet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace shellmatch::test {

/// Inputs of a functor at one point.
template <class Functor>
struct Inputs {
  std::array<double, Functor::n_active> active{};
  std::array<double, Functor::n_passive> passive{};
};

/// What code is made for: packs alone, as of the long terms, whose code takes long to compile, or numbers as well.
enum class MadeFor { packs, numbers_and_packs };

/// Value and gradient at eight points, as numbers and as a pack, against Ceres. Where Ceres' value is not finite
/// the others must not be either.
template <class Functor, MadeFor made_for = MadeFor::numbers_and_packs>
void expect_as_jets(const std::array<Inputs<Functor>, autodiff::pack_size>& points, double tolerance = 1e-13) {
  using autodiff::Pack;
  using Code = autodiff::Compiled<Functor>;
  using Jet = ceres::Jet<double, Functor::n_active>;
  constexpr int n_active = Functor::n_active, n_passive = Functor::n_passive;

  // Lane by lane in one go: g++ 12 takes writes to single lanes for uses of uninitialised values.
  const auto pack = [](auto&& lane) {
    return Pack{lane(0), lane(1), lane(2), lane(3), lane(4), lane(5), lane(6), lane(7)};
  };
  std::array<Pack, n_active> active, pack_gradient;
  std::array<Pack, n_passive> passive;
  for (int i = 0; i < n_active; ++i) active[i] = pack([&](int lane) { return points[lane].active[i]; });
  for (int i = 0; i < n_passive; ++i) passive[i] = pack([&](int lane) { return points[lane].passive[i]; });
  const Pack seed = {1, 2, 3, 4, 5, 6, 7, 8};
  const Pack pack_value = Code::value(active.data(), passive.data());
  const Pack pack_again = Code::gradient(active.data(), passive.data(), seed, pack_gradient.data());

  for (int lane = 0; lane < autodiff::pack_size; ++lane) {
    const auto& in = points[lane];
    std::array<Jet, n_active> jets;
    for (int i = 0; i < n_active; ++i) jets[i] = Jet(in.active[i], i);
    const Jet expected = Functor::template evaluate<Jet, double>(jets.data(), in.passive.data());
    const double error = tolerance * (1 + std::abs(expected.a));
    const double gradient_error = tolerance * (1 + expected.v.norm());
    const auto compare = [&](double value, double again, auto&& derivative) {
      for (const double v : {value, again})
        if (std::isfinite(expected.a)) EXPECT_NEAR(v, expected.a, error);
        else EXPECT_FALSE(std::isfinite(v));
      for (int i = 0; i < n_active && std::isfinite(expected.a); ++i)
        EXPECT_NEAR(derivative(i), expected.v[i], gradient_error) << "input " << i;
    };
    compare(pack_value[lane], pack_again[lane], [&](int i) { return pack_gradient[i][lane] / seed[lane]; });
    if constexpr (made_for == MadeFor::numbers_and_packs) {
      std::array<double, n_active> gradient;
      const double value = Code::value(in.active.data(), in.passive.data());
      const double again = Code::gradient(in.active.data(), in.passive.data(), 3.0, gradient.data());
      compare(value, again, [&](int i) { return gradient[i] / 3; });
    }
  }
}

/// All outputs and their derivatives at eight points, as numbers and as a pack, against Ceres; and what the code says
/// of the outputs' dependences. \pre the outputs are finite there
template <class Functor, MadeFor made_for = MadeFor::numbers_and_packs>
void expect_jacobian_as_jets(const std::array<Inputs<Functor>, autodiff::pack_size>& points, double tolerance = 1e-13) {
  using autodiff::Pack;
  using Code = autodiff::Compiled<Functor>;
  using Jet = ceres::Jet<double, Functor::n_active>;
  constexpr int n_active = Functor::n_active, n_passive = Functor::n_passive, n = Functor::n_outputs;
  static_assert(Code::n_outputs == n);
  std::array<Pack, n_active> active{};
  std::array<Pack, n_passive> passive{};
  for (int lane = 0; lane < autodiff::pack_size; ++lane) {
    for (int i = 0; i < n_active; ++i) active[i][lane] = points[lane].active[i];
    for (int i = 0; i < n_passive; ++i) passive[i][lane] = points[lane].passive[i];
  }
  const double unset = std::numeric_limits<double>::quiet_NaN();
  std::array<Pack, n> pack_values;
  std::array<Pack, n * n_active> pack_derivative;
  for (Pack& d : pack_derivative) d = Pack{} + unset;
  Code::jacobian(active.data(), passive.data(), pack_values.data(), pack_derivative.data());
  for (int lane = 0; lane < autodiff::pack_size; ++lane) {
    const auto& in = points[lane];
    std::array<Jet, n_active> jets;
    for (int i = 0; i < n_active; ++i) jets[i] = Jet(in.active[i], i);
    const std::array<Jet, n> expected = Functor::template evaluate<Jet, double>(jets.data(), in.passive.data());
    const auto compare = [&](auto&& value, auto&& derivative) {
      for (int o = 0; o < n; ++o) {
        EXPECT_NEAR(value(o), expected[o].a, tolerance * (1 + std::abs(expected[o].a))) << "output " << o;
        const double error = tolerance * (1 + expected[o].v.norm());
        for (int i = 0; i < n_active; ++i)
          EXPECT_NEAR(derivative(o * n_active + i), expected[o].v[i], error) << "output " << o << ", input " << i;
      }
    };
    compare([&](int o) { return pack_values[o][lane]; }, [&](int oi) { return pack_derivative[oi][lane]; });
    if constexpr (made_for == MadeFor::numbers_and_packs) {
      std::array<double, n> values;
      std::array<double, n * n_active> derivative;
      derivative.fill(unset);
      Code::jacobian(in.active.data(), in.passive.data(), values.data(), derivative.data());
      compare([&](int o) { return values[o]; }, [&](int oi) { return derivative[oi]; });
    }
  }
}

template <class Functor>
inline constexpr auto tape_of = autodiff::record<Functor>();

/// Operands come first, every node is used or a result, and none stands twice.
template <class Functor>
void expect_good_tape() {
  const auto& tape = tape_of<Functor>;
  using autodiff::Op;
  std::vector<char> used(tape.size, 0);
  for (const int output : tape.outputs) used[static_cast<std::size_t>(output)] = 1;
  for (std::size_t i = 0; i < tape.size; ++i) {
    const autodiff::Node& n = tape.nodes[i];
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(tape.nodes[j].same_as(n)) << j << " and " << i;
    if (n.op == Op::constant || n.op == Op::active || n.op == Op::passive) continue;
    for (const int operand : {n.a, n.b}) {
      ASSERT_TRUE(operand >= 0 && operand < static_cast<int>(i));
      used[static_cast<std::size_t>(operand)] = 1;
    }
    // What is computed from constants alone should have been computed while recording.
    EXPECT_FALSE(tape.nodes[n.a].op == Op::constant && tape.nodes[n.b].op == Op::constant) << i;
  }
  for (std::size_t i = 0; i < tape.size; ++i) EXPECT_TRUE(used[i]) << "node " << i << " is dead";
}

}  // namespace shellmatch::test
