#pragma once
/// \file
/// The list of terms is compiled in shares, each by a translation unit of its own (energies/CMakeLists.txt): no one
/// of them takes long, however many terms there are.

#include "energies/compiled/compiled_term.h"

#include <cstddef>
#include <vector>

namespace shellmatch {

/// Number of shares.
inline constexpr std::size_t n_term_shares = SHELLMATCH_TERM_SHARES;

/// Compiles the terms whose place in the list is `Share` modulo n_term_shares, into `terms` at their place.
template <int Dim, std::size_t Share>
void compile_share(std::vector<CompiledTerm<Dim>>& terms);

}  // namespace shellmatch
