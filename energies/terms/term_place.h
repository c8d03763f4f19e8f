#pragma once
/// \file
/// Terms of the energy by number.

#include <cstddef>

namespace shellmatch {

/// Place of a term in lists of term values; energies/terms/term_names.h knows the names.
enum class Term : std::size_t {};

}  // namespace shellmatch
