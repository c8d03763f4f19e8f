// One share of the list of terms, SHELLMATCH_TERM_SHARE, in SHELLMATCH_TERM_DIM dimensions
// (energies/compiled/term_share.h).

#include "energies/compiled/term_share.h"

#include "energies/compiled/compile_term.h"
#include "energies/terms/list.h"

#include <utility>

namespace shellmatch {

namespace {

template <std::size_t Share, int Dim, class... T>
void compile_listed(TermList<T...>, std::vector<CompiledTerm<Dim>>& terms) {
  std::size_t place = 0;
  const auto one = [&]<std::size_t Place, class TheTerm>() {
    if constexpr (Place % n_term_shares == Share) terms[place] = compile_term<TheTerm>();
    ++place;
  };
  [&]<std::size_t... Place>(std::index_sequence<Place...>) { (one.template operator()<Place, T>(), ...); }
  (std::make_index_sequence<sizeof...(T)>{});
}

}  // namespace

template <int Dim, std::size_t Share>
void compile_share(std::vector<CompiledTerm<Dim>>& terms) {
  compile_listed<Share>(AllTerms<Dim>{}, terms);
}

#ifdef SHELLMATCH_TERM_DIM
template void compile_share<SHELLMATCH_TERM_DIM, SHELLMATCH_TERM_SHARE>(
    std::vector<CompiledTerm<SHELLMATCH_TERM_DIM>>&);
#else
template void compile_share<2, SHELLMATCH_TERM_SHARE>(std::vector<CompiledTerm<2>>&);
template void compile_share<3, SHELLMATCH_TERM_SHARE>(std::vector<CompiledTerm<3>>&);
#endif

}  // namespace shellmatch
