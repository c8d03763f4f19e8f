#include "docs/examples/normal_alignment.h"
#include "tests/energies/autodiff/recorded_terms.h"

namespace shellmatch {
namespace {

using namespace test;

// All of the list, and one from elsewhere whose argument reads an option of its own.
template <class Term>
struct RecordedTerms2d : ::testing::Test {};
using Types2d = TermTypes<2, example::NormalAlignment<2>>;
TYPED_TEST_SUITE(RecordedTerms2d, Types2d, TermTestNames);
TYPED_TEST(RecordedTerms2d, AreTheirFunctors) { check_recorded<TypeParam>(); }

}  // namespace
}  // namespace shellmatch
