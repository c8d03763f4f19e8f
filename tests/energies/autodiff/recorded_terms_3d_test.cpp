#include "docs/examples/normal_alignment.h"
#include "tests/energies/autodiff/recorded_terms.h"

namespace shellmatch {
namespace {

using namespace test;

// All of the list, and one from elsewhere whose argument reads an option of its own.
template <class Term>
struct RecordedTerms3d : ::testing::Test {};
using Types3d = TermTypes<3, example::NormalAlignment<3>>;
TYPED_TEST_SUITE(RecordedTerms3d, Types3d, TermTestNames);
TYPED_TEST(RecordedTerms3d, AreTheirFunctors) { check_recorded<TypeParam>(); }

// Sharing and folding pay off: bending in space is the longest of the band terms.
TEST(RecordedTapes3d, AreShort) {
  const auto n = []<class Term>() { return autodiff::Compiled<PointFunctor<Term>>::n_operations; };
  EXPECT_EQ(n.operator()<Match<3>>(), 4u);  // two inputs, difference, square
  EXPECT_LT(n.operator()<Membrane<3>>(), 200u);
  EXPECT_LT(n.operator()<Bending<3>>(), 300u);
  EXPECT_FALSE((autodiff::Compiled<PointFunctor<Membrane<3>>>::reads_active(0)));
}

}  // namespace
}  // namespace shellmatch
