#pragma once
/// \file
/// Values and derivatives of a recorded functor as straight-line code. Every node of the tape becomes one statement on
/// a local variable: forward for the values, and backward (reverse mode) for the adjoints, once for each output. All
/// operations are known at compile time, so that the compiler keeps the variables in registers and on the stack.
///
/// `V` is double or Pack. The first contribution to a node's adjoint, in the order of the backward sweep, assigns it
/// and later ones add to it, so that no adjoint needs to be cleared.

#include "energies/autodiff/expression.h"
#include "energies/autodiff/pack.h"

#include <utility>

namespace shellmatch::autodiff {

template <class Functor>
class Compiled {
  static constexpr auto full_ = record<Functor>();
  static constexpr std::size_t n_ = full_.size;
  static constexpr std::array<Node, n_> nodes_ = [] {
    std::array<Node, n_> r{};
    for (std::size_t i = 0; i < n_; ++i) r[i] = full_.nodes[i];
    return r;
  }();

  static constexpr bool has_operands(Op op) { return op != Op::constant && op != Op::active && op != Op::passive; }

  static constexpr std::size_t n_outputs_ = n_outputs_of<Functor>;
  static constexpr auto outputs_ = full_.outputs;

  // For each output the active nodes on which it depends, the output's node included.
  static constexpr auto reached_ = [] {
    std::array<std::array<bool, n_>, n_outputs_> r{};
    for (std::size_t o = 0; o < n_outputs_; ++o) {
      r[o][outputs_[o]] = nodes_[outputs_[o]].is_active;
      for (std::size_t i = n_; i-- > 0;)
        if (r[o][i] && has_operands(nodes_[i].op)) {
          if (nodes_[nodes_[i].a].is_active) r[o][nodes_[i].a] = true;
          if (nodes_[nodes_[i].b].is_active) r[o][nodes_[i].b] = true;
        }
    }
    return r;
  }();

  // For each output the last reached node that uses a node. The backward sweep visits users from last to first: this
  // one assigns the adjoint, the others add to it.
  static constexpr auto last_user_ = [] {
    std::array<std::array<int, n_>, n_outputs_> r{};
    for (std::size_t o = 0; o < n_outputs_; ++o) {
      for (int& user : r[o]) user = -1;
      for (std::size_t i = 0; i < n_; ++i)
        if (reached_[o][i] && has_operands(nodes_[i].op)) {
          r[o][nodes_[i].a] = static_cast<int>(i);
          r[o][nodes_[i].b] = static_cast<int>(i);
        }
    }
    return r;
  }();

  template <std::size_t I, class V>
  [[gnu::always_inline]] static void forward(V* v, const V* active, const V* passive) {
    constexpr Node n = nodes_[I];
    if constexpr (n.op == Op::constant) v[I] = broadcast(V{}, n.value);
    else if constexpr (n.op == Op::active) v[I] = active[n.a];
    else if constexpr (n.op == Op::passive) v[I] = passive[n.a];
    else if constexpr (n.op == Op::add) v[I] = v[n.a] + v[n.b];
    else if constexpr (n.op == Op::subtract) v[I] = v[n.a] - v[n.b];
    else if constexpr (n.op == Op::multiply) v[I] = v[n.a] * v[n.b];
    else if constexpr (n.op == Op::divide) v[I] = v[n.a] / v[n.b];
    else if constexpr (n.op == Op::negate) v[I] = -v[n.a];
    else if constexpr (n.op == Op::sqrt) v[I] = root_of(v[n.a]);
    else if constexpr (n.op == Op::exp) v[I] = exp_of(v[n.a]);
    else if constexpr (n.op == Op::log) v[I] = log_of(v[n.a]);
    else if constexpr (n.op == Op::pow) v[I] = pow_of(v[n.a], n.value);
    else if constexpr (n.op == Op::max) v[I] = max_of(v[n.a], v[n.b]);
  }

  template <std::size_t Output, std::size_t User, int Operand, bool Second, class V>
  [[gnu::always_inline]] static void add_adjoint(V* a, V d) {
    if constexpr (nodes_[Operand].is_active) {
      // x * x contributes twice from one user; only the first contribution may assign.
      constexpr bool repeated = Second && nodes_[User].a == nodes_[User].b;
      if constexpr (last_user_[Output][Operand] == static_cast<int>(User) && !repeated) a[Operand] = d;
      else a[Operand] = a[Operand] + d;
    }
  }

  template <std::size_t Output, std::size_t I, class V>
  [[gnu::always_inline]] static void backward(const V* v, V* a) {
    constexpr Node n = nodes_[I];
    if constexpr (reached_[Output][I] && has_operands(n.op)) {
      const V g = a[I];
      if constexpr (n.op == Op::add) {
        add_adjoint<Output, I, n.a, false>(a, g);
        add_adjoint<Output, I, n.b, true>(a, g);
      } else if constexpr (n.op == Op::subtract) {
        add_adjoint<Output, I, n.a, false>(a, g);
        add_adjoint<Output, I, n.b, true>(a, V(-g));
      } else if constexpr (n.op == Op::multiply) {
        if constexpr (nodes_[n.a].is_active) add_adjoint<Output, I, n.a, false>(a, V(g * v[n.b]));
        if constexpr (nodes_[n.b].is_active) add_adjoint<Output, I, n.b, true>(a, V(g * v[n.a]));
      } else if constexpr (n.op == Op::divide) {
        const V q = g / v[n.b];
        add_adjoint<Output, I, n.a, false>(a, q);
        if constexpr (nodes_[n.b].is_active) add_adjoint<Output, I, n.b, true>(a, V(-q * v[I]));
      } else if constexpr (n.op == Op::negate) {
        add_adjoint<Output, I, n.a, false>(a, V(-g));
      } else if constexpr (n.op == Op::sqrt) {
        add_adjoint<Output, I, n.a, false>(a, V(0.5 * g / v[I]));
      } else if constexpr (n.op == Op::exp) {
        add_adjoint<Output, I, n.a, false>(a, V(g * v[I]));
      } else if constexpr (n.op == Op::log) {
        add_adjoint<Output, I, n.a, false>(a, V(g / v[n.a]));
      } else if constexpr (n.op == Op::pow) {
        // Not exponent v[I] / v[n.a], which is NaN at 0.
        add_adjoint<Output, I, n.a, false>(a, V(g * (n.value * pow_of(v[n.a], n.value - 1))));
      } else if constexpr (n.op == Op::max) {
        const V first = where_greater(v[n.a], v[n.b], g);
        add_adjoint<Output, I, n.a, false>(a, first);
        add_adjoint<Output, I, n.b, true>(a, V(g - first));
      }
    }
  }

  template <std::size_t Output, std::size_t I, class V>
  [[gnu::always_inline]] static void store_adjoint(const V* a, V* result) {
    if constexpr (nodes_[I].op == Op::active && reached_[Output][I]) result[nodes_[I].a] = a[I];
  }

  // Adjoints of one output by the active inputs, given the values of all nodes.
  template <std::size_t Output, class V>
  [[gnu::always_inline]] static void sweep(const V* v, V seed, V* adjoint) {
    V a[n_];
    [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
      a[outputs_[Output]] = seed;
      (backward<Output, n_ - 1 - I>(v, a), ...);
      for (int i = 0; i < Functor::n_active; ++i) adjoint[i] = broadcast(V{}, 0.0);
      (store_adjoint<Output, I>(a, adjoint), ...);
    }
    (std::make_index_sequence<n_>{});
  }

 public:
  static constexpr std::size_t n_operations = n_;
  static constexpr int n_active = Functor::n_active, n_outputs = static_cast<int>(n_outputs_);

  /// Whether the functor reads this active input. Searches all nodes, at compile time only.
  static consteval bool reads_active(int input) {
    for (const Node& n : nodes_)
      if (n.op == Op::active && n.a == input) return true;
    return false;
  }
  /// Whether the outputs are the first active inputs themselves.
  static consteval bool copies_inputs() {
    for (int o = 0; o < n_outputs; ++o)
      if (nodes_[outputs_[o]].op != Op::active || nodes_[outputs_[o]].a != o) return false;
    return true;
  }
  /// Whether this output depends on this active input.
  static consteval bool depends(int output, int input) {
    for (std::size_t i = 0; i < n_; ++i)
      if (reached_[output][i] && nodes_[i].op == Op::active && nodes_[i].a == input) return true;
    return false;
  }

  /// The functor's value. \pre it has one output
  template <class V>
  [[gnu::always_inline]] static V value(const V* active, const V* passive) {
    static_assert(n_outputs_ == 1);
    V v[n_];
    [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
      (forward<I>(v, active, passive), ...);
    }
    (std::make_index_sequence<n_>{});
    return v[outputs_[0]];
  }

  /// Value, and `seed` times its derivative by each active input in `adjoint` (size n_active; 0 for inputs that are not
  /// read). \pre the functor has one output
  template <class V>
  [[gnu::always_inline]] static V gradient(const V* active, const V* passive, V seed, V* adjoint) {
    static_assert(n_outputs_ == 1);
    V v[n_];
    return [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
      (forward<I>(v, active, passive), ...);
      sweep<0>(v, seed, adjoint);
      return v[outputs_[0]];
    }
    (std::make_index_sequence<n_>{});
  }

  /// All outputs, and the derivative of output o by active input i in derivative[o * n_active + i], 0 where o does not
  /// depend on i.
  template <class V>
  [[gnu::always_inline]] static void jacobian(const V* active, const V* passive, V* values, V* derivative) {
    V v[n_];
    [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
      (forward<I>(v, active, passive), ...);
    }
    (std::make_index_sequence<n_>{});
    [&]<std::size_t... O>(std::index_sequence<O...>) __attribute__((always_inline)) {
      ((values[O] = v[outputs_[O]], sweep<O>(v, broadcast(V{}, 1.0), derivative + O * Functor::n_active)), ...);
    }
    (std::make_index_sequence<n_outputs_>{});
  }
};

}  // namespace shellmatch::autodiff
