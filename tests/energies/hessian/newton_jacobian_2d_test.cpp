#include "tests/energies/hessian/newton_jacobian_tests.h"

namespace shellmatch {
namespace {
SHELLMATCH_NEWTON_JACOBIAN_TESTS(2)
}  // namespace
}  // namespace shellmatch
