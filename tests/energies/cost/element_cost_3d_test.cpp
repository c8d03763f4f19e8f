#include "tests/energies/cost/element_costs.h"

namespace shellmatch {
namespace {
SHELLMATCH_ELEMENT_COST_TESTS(3)
}  // namespace
}  // namespace shellmatch
