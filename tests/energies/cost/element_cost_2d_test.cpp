#include "tests/energies/cost/element_costs.h"

namespace shellmatch {
namespace {
SHELLMATCH_ELEMENT_COST_TESTS(2)
}  // namespace
}  // namespace shellmatch
