#include "energies/terms/term_names.h"

namespace shellmatch {

TermValues::TermValues() : TermValues(n_all_terms) {}

}  // namespace shellmatch
