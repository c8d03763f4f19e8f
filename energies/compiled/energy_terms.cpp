#include "energies/compiled/energy_terms.h"

#include "base/error.h"
#include "energies/compiled/term_share.h"
#include "energies/terms/term_names.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <type_traits>
#include <utility>

namespace shellmatch {

namespace {

// Of one term, if it is integrated over the band.
template <int Dim>
const BandCode<Dim>* band_code_of(const CompiledTerm<Dim>& term) {
  return std::get_if<BandCode<Dim>>(&term.code);
}

std::string name_of(const TermInfo& info) {
  return info.model.empty() ? std::string(info.name) : fmt::format("{} ({})", info.name, info.model);
}

void check_number(std::string_view name, double value, const OptionInfo& info) {
  if (!std::isfinite(value) || !in_range(value, info))
    throw_input_error("energy.{}: {} is out of range; expected a finite number, {}", name, value, range_text(info));
}

// Of every term, whatever its weight, which may become positive later.
template <int Dim>
void check_options(const CompiledTerm<Dim>& term, const Material<double>& material) {
  for (std::size_t i = 0; i < term.own.size(); ++i) check_number(term.own[i].name, material.own[i], term.own[i].info);
  if (const double modulus = term.modulus(material); !std::isfinite(modulus))
    throw_input_error(
        "energy: the stiffness of the term {} is {} with lambda = {} and mu = {}; expected a finite number",
        name_of(term.info), modulus, material.lambda, material.mu);
}

}  // namespace

template <int Dim>
EnergyTerms<Dim>::EnergyTerms(const EnergyOptions& options)
    : lambda_(options.lambda), mu_(options.mu), evaluator_(options.evaluator) {
  const auto check = [](std::string_view name, const auto& value, const OptionInfo& info) {
    if constexpr (std::is_same_v<decltype(value), const double&>) check_number(name, value, info);
  };
  EnergyOptions::describe(options, check);
  for (std::size_t t = 0; t < term_names().size(); ++t) {
    const std::size_t place = options.terms.chosen(Term{t});
    const CompiledTerm<Dim>& term = all_compiled_terms<Dim>()[place];
    const double* own = options.terms.own_of(place);
    add(term, {own, own + term.own.size()});
    entries_.back().weight = [scaled = term.info.scaled, factor = options.terms.factor(Term{t})](const TermScales& s) {
      return scaled(factor, s);
    };
  }
}

template <int Dim>
Term EnergyTerms<Dim>::add(const CompiledTerm<Dim>& term, std::vector<double> own,
                           std::vector<std::shared_ptr<const UserField>> fields) {
  if (own.empty())
    for (const TermOption& option : term.own) own.push_back(option.value);
  SHELLMATCH_CHECK(own.size() == term.own.size(), "one value for each option of the term");
  if (const auto* band = band_code_of(term); band && band->reads_curvature)
    for (const Entry& other : entries_)
      if (const auto* that = band_code_of(other.term); that && that->reads_curvature)
        SHELLMATCH_CHECK(band->reads_shape_operators == that->reads_shape_operators,
                         "one term reads roots of shape operators and another the shape operators themselves");
  check_options(term, {lambda_, mu_, own.data()});
  Entry& entry = entries_.emplace_back(
      Entry{std::string(term.info.name), term, std::move(own), {}, UserFields<Dim>(std::move(fields)), {}});
  entry.weight = [scaled = term.info.scaled, factor = term.info.weight.value](const TermScales& s) {
    return scaled(factor, s);
  };
  SHELLMATCH_CHECK(entry.own_fields.n_components() == term.n_own_fields,
                   "the term's own fields have as many components as it reads");
  entry.material = {lambda_, mu_, entry.own.data()};
  return Term{entries_.size() - 1};
}

template <int Dim>
Term EnergyTerms<Dim>::add(std::string name, PairTerm<Dim> pairs, std::function<double(const TermScales&)> weight,
                           Renewal renewal) {
  CompiledTerm<Dim> term;
  term.code = PointCode<Dim>{std::move(pairs)};
  entries_.push_back({std::move(name), std::move(term), {}, {}, {}, std::move(weight), std::move(renewal)});
  return Term{entries_.size() - 1};
}

template <int Dim>
void EnergyTerms<Dim>::refresh(const std::vector<Vec<Dim>>& phi) {
  for (Entry& entry : entries_)
    if (entry.renewal) std::get<PointCode<Dim>>(entry.term.code).pairs = entry.renewal(phi);
}

template <int Dim>
bool EnergyTerms<Dim>::follow_phi() const {
  return std::ranges::any_of(entries_, [](const Entry& entry) { return entry.renewal != nullptr; });
}

template <int Dim>
std::vector<std::string> EnergyTerms<Dim>::names() const {
  std::vector<std::string> names;
  for (const Entry& entry : entries_) names.push_back(entry.name);
  return names;
}

template <int Dim>
TermValues EnergyTerms<Dim>::weights(const TermScales& scales) const {
  TermValues weights(entries_.size());
  for (std::size_t t = 0; t < entries_.size(); ++t) weights[t] = entries_[t].weight(scales);
  return weights;
}

template <int Dim>
bool EnergyTerms<Dim>::forbid_folds(const TermValues& weights) const {
  for (std::size_t t = 0; t < entries_.size(); ++t)
    if (weights[t] > 0 && entries_[t].term.info.forbids_folds) return true;
  return false;
}

template <int Dim>
bool EnergyTerms<Dim>::read_target(const TermValues& weights) const {
  for (std::size_t t = 0; t < entries_.size(); ++t)
    if (const auto* band = band_code_of(entries_[t].term); band && weights[t] > 0 && band->reads_target) return true;
  return false;
}

template <int Dim>
bool EnergyTerms<Dim>::fit_tangent(const TermValues& weights) const {
  for (std::size_t t = 0; t < entries_.size(); ++t)
    if (const auto* band = band_code_of(entries_[t].term); band && weights[t] > 0 && !band->add_in_tangent)
      return false;
  return true;
}

template <int Dim>
const std::vector<CompiledTerm<Dim>>& all_compiled_terms() {
  static const std::vector<CompiledTerm<Dim>> all = [] {
    std::vector<CompiledTerm<Dim>> terms(all_term_infos.size());
    [&]<std::size_t... Share>(std::index_sequence<Share...>) { (compile_share<Dim, Share>(terms), ...); }
    (std::make_index_sequence<n_term_shares>{});
    return terms;
  }();
  return all;
}

template class EnergyTerms<2>;
template class EnergyTerms<3>;
SHELLMATCH_2D_3D(all_compiled_terms);

}  // namespace shellmatch
