#pragma once
/// \file
/// The terms of one energy: those that the options choose from energies/terms/list.h, terms from elsewhere, and terms
/// of point pairs, such as landmarks.

#include "energies/compiled/compiled_term.h"
#include "energies/energy_options.h"

#include <deque>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace shellmatch {

template <int Dim>
class EnergyTerms {
 public:
  /// The pairs of a term for these positions of the nodes.
  using Renewal = std::function<PairTerm<Dim>(const std::vector<Vec<Dim>>& phi)>;

  /// One term with the values of its options.
  struct Entry {
    std::string name;  ///< in reports
    CompiledTerm<Dim> term;
    std::vector<double> own;
    Material<double> material;  ///< refers to `own`
    UserFields<Dim> own_fields;
    std::function<double(const TermScales&)> weight;  ///< at a step of the schedule
    Renewal renewal = {};                             ///< of a term of points that follow phi
  };

  /// \throws InputError if a number is out of its range, and as add()
  explicit EnergyTerms(const EnergyOptions& options);
  EnergyTerms(const EnergyTerms&) = delete;
  EnergyTerms& operator=(const EnergyTerms&) = delete;

  /// Adds a term that is not in the list, for instance compile_term<MyTerm<Dim>>(), and returns its place in
  /// TermValues.
  /// \param own values of its own options; their defaults where it is empty
  /// \param fields of the user's own that it reads, in the order of its Reads; values may change between evaluations
  /// \throws InputError if an option is out of its range, or the stiffness (CompiledTerm::modulus) is no finite number
  /// \pre terms that read curvature all read roots, or all read shape operators; the fields have the term's components
  Term add(const CompiledTerm<Dim>& term, std::vector<double> own = {},
           std::vector<std::shared_ptr<const UserField>> fields = {});

  /// Adds a term of point pairs, located on the grid of the energy.
  /// \param weight  at a step of the schedule
  /// \param renewal makes them anew in refresh(); empty: they stay
  Term add(std::string name, PairTerm<Dim> pairs, std::function<double(const TermScales&)> weight,
           Renewal renewal = {});
  /// What terms make anew as phi moves becomes that for this phi. Not during an evaluation.
  void refresh(const std::vector<Vec<Dim>>& phi);
  /// Does one of the terms?
  bool follow_phi() const;

  Evaluator evaluator() const { return evaluator_; }
  std::size_t size() const { return entries_.size(); }
  /// In the order of TermValues.
  const std::deque<Entry>& entries() const { return entries_; }
  const Entry& operator[](std::size_t i) const { return entries_[i]; }
  std::vector<std::string> names() const;
  /// The weights at a step of the schedule: those of the options for the terms of the list, and of others what they
  /// were added with.
  TermValues weights(const TermScales& scales) const;

  /// Is one of the terms with a positive weight infinite where det Dphi <= 0?
  bool forbid_folds(const TermValues& weights) const;
  /// Does one of them read the template?
  bool read_target(const TermValues& weights) const;
  /// Do the tangent variables (BandModelPoint) tell the derivatives of all of them?
  bool fit_tangent(const TermValues& weights) const;

 private:
  double lambda_, mu_;
  Evaluator evaluator_;
  std::deque<Entry> entries_;  // they do not move
};

/// One for each term of the list, in its order.
template <int Dim>
const std::vector<CompiledTerm<Dim>>& all_compiled_terms();

extern template class EnergyTerms<2>;
extern template class EnergyTerms<3>;

}  // namespace shellmatch
