#include "tests/energies/assembly/newton_jacobian_tests.h"

namespace shellmatch {
namespace {
SHELLMATCH_NEWTON_JACOBIAN_TESTS(3)
}  // namespace
}  // namespace shellmatch
