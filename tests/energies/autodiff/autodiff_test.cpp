// The recording scalar and the code made from it, on small functors that each stress one thing.

#include "tests/energies/autodiff/compiled_against_jets.h"

#include <random>
#include <set>

namespace shellmatch {
namespace {

using namespace test;
using autodiff::Op;

// Random inputs in [-1, 1].
template <class Functor>
std::array<Inputs<Functor>, autodiff::pack_size> random_inputs(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::array<Inputs<Functor>, autodiff::pack_size> points;
  for (auto& p : points) {
    for (double& x : p.active) x = uniform(random);
    for (double& x : p.passive) x = uniform(random);
  }
  return points;
}

template <class Functor>
void check(double tolerance = 1e-14) {
  for (unsigned seed = 0; seed < 10; ++seed) expect_as_jets<Functor>(random_inputs<Functor>(seed), tolerance);
  expect_good_tape<Functor>();
}

// Every operation there is, operands shared, and two inputs that nobody reads.
struct Everything {
  static constexpr int n_active = 4, n_passive = 3;
  template <class T, class P>
  static constexpr T evaluate(const T* x, const P* p) {
    using autodiff::max_of;
    using std::exp;
    using std::log;
    using std::pow;
    using std::sqrt;
    const T shared = x[0] * x[2] + p[0];
    const T square = shared * shared + 2.0;
    const T root = sqrt(square);
    const T quotient = exp(-x[0]) / root;
    return max_of(quotient - x[2], shared / 3.0) + (p[0] - p[1]) * quotient / (2.0 - x[0]) + log(square) * x[2] -
           pow(square, -0.7) * pow(x[0], 3.0);
  }
};

TEST(Autodiff, EveryOperation) {
  check<Everything>();
  std::set<Op> seen;
  for (std::size_t i = 0; i < tape_of<Everything>.size; ++i) seen.insert(tape_of<Everything>.nodes[i].op);
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(Op::max) + 1);
  using Code = autodiff::Compiled<Everything>;
  EXPECT_TRUE(Code::reads_active(0) && Code::reads_active(2));
  EXPECT_FALSE(Code::reads_active(1) || Code::reads_active(3));
}

// The functions of one variable, each by itself.
struct Log {
  static constexpr int n_active = 1, n_passive = 0;
  template <class T, class P>
  static constexpr T evaluate(const T* x, const P*) {
    using std::log;
    return log(x[0]);
  }
};
template <int Numerator, int Denominator>
struct Power {
  static constexpr int n_active = 1, n_passive = 0;
  template <class T, class P>
  static constexpr T evaluate(const T* x, const P*) {
    using std::pow;
    return pow(x[0], Numerator / double(Denominator));
  }
};

// One of them twice.
struct TwoPowers {
  static constexpr int n_active = 1, n_passive = 0;
  template <class T, class P>
  static constexpr T evaluate(const T* x, const P*) {
    using std::pow;
    return pow(x[0], 2.0) + pow(x[0], 2.0) * pow(x[0], 3.0);
  }
};

// Against ceres::Jet, and the derivative against differences of the standard library's function.
template <class Functor, class F>
void check_at(const std::array<double, autodiff::pack_size>& at, const F& f) {
  std::array<Inputs<Functor>, autodiff::pack_size> points;
  for (std::size_t lane = 0; lane < at.size(); ++lane) points[lane].active[0] = at[lane];
  expect_as_jets<Functor>(points);
  for (const double x : at) {
    const double h = 1e-5 * std::abs(x), seed = 1;
    double derivative = 0;
    const double value = autodiff::Compiled<Functor>::gradient(&x, &x, seed, &derivative);
    if (!std::isfinite(value)) continue;
    EXPECT_DOUBLE_EQ(value, f(x));
    const double expected = x == 0 ? 0 : (f(x + h) - f(x - h)) / (2 * h);
    EXPECT_NEAR(derivative, expected, 1e-8 * (1 + std::abs(derivative))) << "at " << x;
  }
}

TEST(Autodiff, LogarithmAndPowersHaveTheirDerivatives) {
  const auto power = [](double c) { return [c](double x) { return std::pow(x, c); }; };
  // Logarithm and root of a negative number are not finite.
  check_at<Log>({1e-3, 0.5, 1, 2, 30, 1e4, -1, -0.1}, [](double x) { return std::log(x); });
  check_at<Power<5, 2>>({0, 1e-3, 0.5, 1, 2, 30, -1, -0.1}, power(2.5));
  check_at<Power<-1, 3>>({1e-3, 0.5, 1, 2, 30, 1e4, -1, -0.1}, power(-1.0 / 3));
  // Whole exponents are for negative numbers, too, and at 0 the derivative is 0.
  check_at<Power<3, 1>>({0, 1e-3, 0.5, -0.5, 2, -2, 30, -30}, power(3));
  check_at<Power<-2, 1>>({1e-3, -1e-3, 0.5, -0.5, 2, -2, 30, -30}, power(-2));
  EXPECT_EQ(tape_of<Log>.size, 2u);
  EXPECT_EQ(tape_of<TwoPowers>.size, 5u) << "x, x^2, x^3, their product and the sum";
  check<TwoPowers>();
}

// One node as both operands, for every operation of two.
struct Twice {
  static constexpr int n_active = 2, n_passive = 1;
  template <class T, class P>
  static constexpr T evaluate(const T* x, const P* p) {
    using autodiff::max_of;
    const T u = x[0] + 2.0 * x[1];
    return u * u + (u + u) * x[0] + (u - u) + u / u + max_of(u, u) * p[0];
  }
};

TEST(Autodiff, SameOperandTwice) { check<Twice>(); }

struct Square {
  static constexpr int n_active = 1, n_passive = 0;
  template <class T, class P>
  static constexpr T evaluate(const T* x, const P*) {
    return x[0] * x[0];
  }
};

TEST(Autodiff, SquareOfTheOnlyInput) { check<Square>(); }

// The result is an input; the products of zero and one leave nothing to compute.
struct AnInput {
  static constexpr int n_active = 3, n_passive = 1;
  template <class T, class P>
  static constexpr T evaluate(const T* x, const P* p) {
    const T nothing = (2.0 * T(3.0) - 6.0) * x[0];
    return 1.0 * x[1] + nothing * p[0] + (nothing - 0.0) / 2.0;
  }
};

TEST(Autodiff, ConstantsAreFoldedUntilOnlyAnInputIsLeft) {
  check<AnInput>();
  EXPECT_EQ(tape_of<AnInput>.size, 1u);
  EXPECT_EQ(tape_of<AnInput>.nodes[0].op, Op::active);
  EXPECT_EQ(tape_of<AnInput>.nodes[0].a, 1);
}

// No active input is read at all.
struct PassiveOnly {
  static constexpr int n_active = 2, n_passive = 2;
  template <class T, class P>
  static constexpr T evaluate(const T*, const P* p) {
    return T(p[0] * p[0] - p[1]);
  }
};

// A large passive part, which needs no adjoint.
struct PassivePart {
  static constexpr int n_active = 2, n_passive = 2;
  template <class T, class P>
  static constexpr T evaluate(const T* x, const P* p) {
    using std::exp;
    const P factor = exp(p[0] * p[1]) / (2.0 + p[0]);
    return factor * x[0] - x[1] * (factor * factor);
  }
};

TEST(Autodiff, PassivePartsNeedNoAdjoint) {
  check<PassiveOnly>();
  check<PassivePart>();
  const auto& tape = tape_of<PassivePart>;
  const auto n_active = std::count_if(tape.nodes.begin(), tape.nodes.begin() + tape.size,
                                      [](const autodiff::Node& n) { return n.is_active; });
  EXPECT_EQ(n_active, 5);  // two inputs, two products, one difference
}

struct Common {
  static constexpr int n_active = 2, n_passive = 0;
  template <class T, class P>
  static constexpr T evaluate(const T* x, const P*) {
    const T unused = x[0] / x[1];
    static_cast<void>(unused);
    return (x[0] * x[1] + 0.5) * (0.5 + x[1] * x[0]);
  }
};

TEST(Autodiff, CommonSubexpressionsAreShared) {
  check<Common>();
  EXPECT_EQ(tape_of<Common>.size, 6u);  // two inputs, 0.5, product, sum, square
}

// Many users of one node, before and after each other in the tape.
struct ManyUsers {
  static constexpr int n_active = 3, n_passive = 0;
  template <class T, class P>
  static constexpr T evaluate(const T* x, const P*) {
    T sum = x[0], power = x[1];
    for (int i = 1; i <= 12; ++i) {
      power = power * x[1] + x[2] * x[0];
      sum = sum + power * (1.0 / i) - x[0] * x[0];
    }
    return sum * x[2];
  }
};

TEST(Autodiff, ManyUsersOfOneNode) { check<ManyUsers>(1e-13); }

// Outputs that share parts of each other: every one of them has adjoints of its own.
struct Several {
  static constexpr int n_active = 4, n_passive = 2, n_outputs = 8;
  template <class T, class P>
  static constexpr std::array<T, n_outputs> evaluate(const T* x, const P* p) {
    using autodiff::max_of;
    using std::exp;
    using std::sqrt;
    const T s = x[0] * x[1] + p[0];
    const T root = sqrt(s * s + 2.0);
    return {root * x[2],  // three of the inputs
            T(3.0),       // a constant
            s,
            x[1] * x[0] + p[0],            // twice the same
            exp(-x[3]) / root + s * x[3],  // all but x[2]
            x[2],                          // an input
            T(p[0] * p[1]),                // nothing active
            max_of(s, x[3]) * root - s / 3.0};
  }
};

TEST(Autodiff, JacobianOfSeveralOutputs) {
  for (unsigned seed = 0; seed < 10; ++seed) expect_jacobian_as_jets<Several>(random_inputs<Several>(seed), 1e-14);
  expect_good_tape<Several>();
  EXPECT_EQ(tape_of<Several>.outputs[2], tape_of<Several>.outputs[3]);
}

TEST(Autodiff, EveryOutputKnowsTheInputsThatItDependsOn) {
  using Code = autodiff::Compiled<Several>;
  constexpr bool expected[Several::n_outputs][Several::n_active] = {
      {true, true, true, false}, {false, false, false, false}, {true, true, false, false},   {true, true, false, false},
      {true, true, false, true}, {false, false, true, false},  {false, false, false, false}, {true, true, false, true}};
  [&]<int... OI>(std::integer_sequence<int, OI...>) {
    constexpr bool found[] = {Code::depends(OI / 4, OI % 4)...};
    for (int oi = 0; oi < Several::n_outputs * 4; ++oi)
      EXPECT_EQ(found[oi], expected[oi / 4][oi % 4]) << "output " << oi / 4 << ", input " << oi % 4;
  }
  (std::make_integer_sequence<int, Several::n_outputs * 4>{});
}

// Without a value there is no derivative to speak of, but zeros: the caller's memory is not read.
struct Constants {
  static constexpr int n_active = 2, n_passive = 0, n_outputs = 2;
  template <class T, class P>
  static constexpr std::array<T, n_outputs> evaluate(const T*, const P*) {
    return {T(1.5), T(-2.0)};
  }
};

TEST(Autodiff, JacobianOfConstantsIsZero) {
  expect_jacobian_as_jets<Constants>(random_inputs<Constants>(1));
  expect_good_tape<Constants>();
}

}  // namespace
}  // namespace shellmatch
