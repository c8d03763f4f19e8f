#pragma once
/// \file
/// A scalar that records, at compile time, the expression that a functor computes. The record (a Tape) is compiled into
/// straight-line code for value and gradient by energies/autodiff/compiled.h. Recording folds constants and shares
/// common subexpressions; afterwards, nodes that no result depends on are removed.
///
/// A recorded functor must not branch on data, other than by max_of. It may use + - * /, unary minus, sqrt, exp, log,
/// pow with a constant exponent, max_of, and constants of type double. To add a function: docs/autodiff.md.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shellmatch::autodiff {

enum class Op : unsigned char {
  constant,
  active,
  passive,
  add,
  subtract,
  multiply,
  divide,
  negate,
  sqrt,
  exp,
  log,
  pow,
  max
};

/// One operation. `a` and `b` are the node numbers of its operands; for an input, `a` is its position.
struct Node {
  Op op = Op::constant;
  int a = -1, b = -1;
  double value = 0;        ///< value of a constant; of pow the exponent
  bool is_active = false;  ///< depends on an active input, hence has an adjoint
  constexpr bool same_as(const Node& o) const { return op == o.op && a == o.a && b == o.b && value == o.value; }
};

/// The expression being recorded. A hash table finds subexpressions that have been recorded before.
class Record {
 public:
  constexpr Record() : slots_(n_slots, -1) {}
  constexpr const std::vector<Node>& nodes() const { return nodes_; }
  constexpr int find_or_add(const Node& n) {
    std::size_t slot = hash(n);
    for (; slots_[slot] >= 0; slot = (slot + 1) % n_slots)
      if (nodes_[static_cast<std::size_t>(slots_[slot])].same_as(n)) return slots_[slot];
    slots_[slot] = static_cast<int>(nodes_.size());
    nodes_.push_back(n);
    return slots_[slot];
  }

 private:
  static constexpr std::size_t n_slots = 8192;  // more than twice the capacity of a tape
  static constexpr std::size_t hash(const Node& n) {
    std::uint64_t h = std::bit_cast<std::uint64_t>(n.value) + static_cast<std::uint64_t>(n.op);
    h = h * 31 + static_cast<std::uint64_t>(n.a + 1);
    h = h * 8191 + static_cast<std::uint64_t>(n.b + 1);
    return static_cast<std::size_t>((h * 0x9E3779B97F4A7C15u) >> 51);
  }
  std::vector<Node> nodes_;
  std::vector<int> slots_;
};

/// The recording scalar: a constant, or the number of a node of the current record.
class Expression {
 public:
  constexpr Expression() = default;
  // Implicit, so that functors can write 0.5 * x with a plain double.
  constexpr Expression(double c) : value_(c) {}  // NOLINT(google-explicit-constructor)
  constexpr Expression(Record* record, int node) : record_(record), node_(node) {}

  constexpr bool is_constant() const { return record_ == nullptr; }
  constexpr bool is(double c) const { return is_constant() && value_ == c; }
  constexpr int node() const { return node_; }
  constexpr double value() const { return value_; }

  friend constexpr Expression operator+(const Expression& x, const Expression& y) {
    if (x.is_constant() && y.is_constant()) return x.value_ + y.value_;
    if (x.is(0)) return y;
    if (y.is(0)) return x;
    return append(Op::add, x, y);
  }
  friend constexpr Expression operator-(const Expression& x, const Expression& y) {
    if (x.is_constant() && y.is_constant()) return x.value_ - y.value_;
    if (y.is(0)) return x;
    if (x.is(0)) return -y;
    return append(Op::subtract, x, y);
  }
  friend constexpr Expression operator*(const Expression& x, const Expression& y) {
    if (x.is_constant() && y.is_constant()) return x.value_ * y.value_;
    if (x.is(0) || y.is(0)) return 0.0;
    if (x.is(1)) return y;
    if (y.is(1)) return x;
    return append(Op::multiply, x, y);
  }
  friend constexpr Expression operator/(const Expression& x, const Expression& y) {
    if (x.is_constant() && y.is_constant()) return x.value_ / y.value_;
    if (x.is(0)) return 0.0;
    if (y.is(1)) return x;
    return append(Op::divide, x, y);
  }
  friend constexpr Expression operator-(const Expression& x) {
    if (x.is_constant()) return -x.value_;
    return append(Op::negate, x, x);
  }
  // Functions of constants are not folded, because those of the standard library are not constexpr.
  friend constexpr Expression sqrt(const Expression& x) { return append(Op::sqrt, x, x); }
  friend constexpr Expression exp(const Expression& x) { return append(Op::exp, x, x); }
  friend constexpr Expression log(const Expression& x) { return append(Op::log, x, x); }
  /// x^exponent. The exponent is a number, so that one derivative does.
  friend constexpr Expression pow(const Expression& x, double exponent) { return append(Op::pow, x, x, exponent); }
  friend constexpr Expression max_of(const Expression& x, const Expression& y) { return append(Op::max, x, y); }

 private:
  constexpr int materialise(Record& record) const {
    if (!is_constant()) return node_;
    return record.find_or_add(Node{.op = Op::constant, .value = value_});
  }
  static constexpr Expression append(Op op, const Expression& x, const Expression& y, double value = 0) {
    Record& record = x.record_ ? *x.record_ : *y.record_;
    Node n{.op = op, .a = x.materialise(record), .b = y.materialise(record), .value = value};
    const bool commutes = op == Op::add || op == Op::multiply || op == Op::max;
    if (commutes && n.b < n.a) {
      const int t = n.a;
      n.a = n.b;
      n.b = t;
    }
    n.is_active = record.nodes()[n.a].is_active || record.nodes()[n.b].is_active;
    return {&record, record.find_or_add(n)};
  }

  Record* record_ = nullptr;
  int node_ = -1;
  double value_ = 0;
};

/// Number of outputs of a functor: Functor::n_outputs where it is declared, else 1.
template <class Functor>
inline constexpr int n_outputs_of = 1;
template <class Functor>
requires requires { Functor::n_outputs; }
inline constexpr int n_outputs_of<Functor> = Functor::n_outputs;

/// A finished record: `size` nodes, operands before their users, and the numbers of the results' nodes.
template <std::size_t Capacity, int NOutputs>
struct Tape {
  std::array<Node, Capacity> nodes{};
  std::size_t size = 0;
  std::array<int, NOutputs> outputs{};
};

/// Records Functor::evaluate(active, passive) on arrays of Expression of sizes Functor::n_active and n_passive. The
/// functor returns a scalar, or a std::array of n_outputs scalars.
template <class Functor, std::size_t Capacity = 2048>
consteval Tape<Capacity, n_outputs_of<Functor>> record() {
  constexpr int n_outputs = n_outputs_of<Functor>;
  Record recorded;
  std::array<Expression, Functor::n_active> active;
  std::array<Expression, Functor::n_passive> passive;
  for (int i = 0; i < Functor::n_active; ++i)
    active[i] = {&recorded, recorded.find_or_add({.op = Op::active, .a = i, .is_active = true})};
  for (int i = 0; i < Functor::n_passive; ++i)
    passive[i] = {&recorded, recorded.find_or_add({.op = Op::passive, .a = i})};
  std::array<Expression, n_outputs> results;
  if constexpr (requires { Functor::n_outputs; })
    results = Functor::template evaluate<Expression, Expression>(active.data(), passive.data());
  else results[0] = Functor::template evaluate<Expression, Expression>(active.data(), passive.data());
  Tape<Capacity, n_outputs> tape;
  for (int o = 0; o < n_outputs; ++o)
    tape.outputs[o] = results[o].is_constant()
                          ? recorded.find_or_add(Node{.op = Op::constant, .value = results[o].value()})
                          : results[o].node();

  // Keep the nodes that the results depend on, in the same order.
  const std::vector<Node>& all = recorded.nodes();
  const auto is_input = [](const Node& n) { return n.op == Op::active || n.op == Op::passive || n.op == Op::constant; };
  std::vector<char> needed(all.size(), 0);
  for (const int output : tape.outputs) needed[output] = 1;
  for (int i = static_cast<int>(all.size()) - 1; i >= 0; --i)
    if (needed[i] && !is_input(all[i])) {
      needed[all[i].a] = 1;
      needed[all[i].b] = 1;
    }
  std::vector<int> moved(all.size(), -1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!needed[i]) continue;
    Node n = all[i];
    if (!is_input(n)) {
      n.a = moved[n.a];
      n.b = moved[n.b];
    }
    moved[i] = static_cast<int>(tape.size);
    tape.nodes[tape.size++] = n;
  }
  for (int& output : tape.outputs) output = moved[output];
  return tape;
}

}  // namespace shellmatch::autodiff
