#include "energies/energy_options.h"

#include "base/error.h"
#include "energies/terms/term_names.h"

#include <array>
#include <span>
#include <type_traits>

namespace shellmatch {

namespace {

// Of the list, by place in it: what the terms of both dimensions share.
struct Listed {
  std::span<const TermOption> own;
  bool reads_shape_operators;
};

template <class... T>
std::array<Listed, sizeof...(T)> listed(TermList<T...>) {
  const auto reads = []<class One>(std::type_identity<One>) {
    if constexpr (requires { typename One::Reads; }) return One::Reads::has_shape_operators;
    else return false;
  };
  return {Listed{T::own, reads(std::type_identity<T>{})}...};
}

const auto& all_listed() {
  static const auto all = listed(AllTerms<3>{});
  return all;
}

// Place of the first term of a name.
std::size_t first_of(std::size_t t) {
  std::size_t place = 0;
  while (all_term_infos[place].name != all_term_names[t]) ++place;
  return place;
}

}  // namespace

const std::vector<std::string_view>& term_names() {
  static const std::vector<std::string_view> names(all_term_names.begin(), all_term_names.end());
  return names;
}

TermOptions::TermOptions() {
  for (std::size_t t = 0; t < n_all_terms; ++t) {
    factors_.push_back(all_term_infos[first_of(t)].weight.value);
    std::vector<std::string_view> names;
    for (const TermInfo& info : all_term_infos)
      if (info.name == all_term_names[t]) names.push_back(info.model);
    models_.emplace_back(names);
  }
  for (const Listed& term : all_listed())
    for (const TermOption& option : term.own) own_.push_back(option.value);
}

double& TermOptions::own(std::string_view name) {
  for (std::size_t i = 0; i < own_.size(); ++i)
    if (own_option(i).name == name) return own_[i];
  SHELLMATCH_CHECK(false, "no term has an option of this name");
  return own_.front();
}
double TermOptions::own(std::string_view name) const { return const_cast<TermOptions&>(*this).own(name); }

std::size_t TermOptions::chosen(Term t) const { return first_of(static_cast<std::size_t>(t)) + model(t).index(); }

TermOptions::Described TermOptions::factor_option(std::size_t t) {
  const TermOption& option = all_term_infos[first_of(t)].weight;
  return {option.name, option.info};
}

std::string_view TermOptions::model_meaning(std::size_t t) {
  static const std::array<std::string, n_all_terms> meanings = [] {
    std::array<std::string, n_all_terms> texts;
    for (std::size_t i = 0; i < n_all_terms; ++i)
      for (const TermInfo& info : all_term_infos)
        if (info.name == all_term_names[i]) {
          if (!texts[i].empty()) texts[i] += "; ";
          texts[i] += std::string(info.model) + ": " + std::string(info.meaning);
        }
    return texts;
  }();
  return meanings[t];
}

TermOptions::Described TermOptions::own_option(std::size_t i) {
  for (const Listed& term : all_listed()) {
    if (i < term.own.size()) return {term.own[i].name, term.own[i].info};
    i -= term.own.size();
  }
  return {};
}

std::size_t TermOptions::first_own(std::size_t place) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < place; ++i) n += all_listed()[i].own.size();
  return n;
}

TermValues term_weights(const EnergyOptions& o, double nu, double volume_weight) {
  const TermScales scales{.nu = nu, .volume = volume_weight, .delta = o.delta};
  TermValues weights;
  for (std::size_t t = 0; t < n_all_terms; ++t)
    weights[t] = all_term_infos[o.terms.chosen(Term{t})].scaled(o.terms.factor(Term{t}), scales);
  return weights;
}

bool reads_shape_operators(const EnergyOptions& options) {
  for (std::size_t t = 0; t < n_all_terms; ++t)
    if (all_listed()[options.terms.chosen(Term{t})].reads_shape_operators) return true;
  return false;
}

}  // namespace shellmatch
