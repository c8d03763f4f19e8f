#include "tests/energies/autodiff/recorded_terms.h"

namespace shellmatch {
namespace {

using namespace test;

TEST(RecordedTerms3d, Match) { check_band_term<Match<3>>(); }
TEST(RecordedTerms3d, Membrane) { check_band_term<Membrane<3>>(); }
TEST(RecordedTerms3d, Bending) { check_band_term<Bending<3>>(); }
TEST(RecordedTerms3d, MembraneWithoutP2) { check_band_term<MembraneWithoutP2<3>>(); }
TEST(RecordedTerms3d, CauchyGreenMembrane) { check_band_term<CauchyGreenMembrane<3>>(); }
TEST(RecordedTerms3d, BendingWithoutP2) { check_band_term<BendingWithoutP2<3>>(); }
TEST(RecordedTerms3d, QuadraticBending) { check_band_term<QuadraticBending<3>>(); }
TEST(RecordedTerms3d, SimplifiedVolume) { check_volume_term<SimplifiedVolume<3>>(); }
TEST(RecordedTerms3d, FullVolume) { check_volume_term<FullVolume<3>>(); }
TEST(RecordedTerms3d, SymmetricDirichletVolume) { check_volume_term<SymmetricDirichletVolume<3>>(); }
TEST(RecordedTerms3d, FoldBarrier) { check_barrier<3>(); }

// Sharing and folding pay off: bending in space is the longest of the band terms.
TEST(RecordedTerms3d, TapesAreShort) {
  const auto n = []<class Term>() { return autodiff::Compiled<BandFunctor<Term>>::n_operations; };
  EXPECT_EQ(n.operator()<Match<3>>(), 4u);  // two inputs, difference, square
  EXPECT_LT(n.operator()<Membrane<3>>(), 200u);
  EXPECT_LT(n.operator()<Bending<3>>(), 300u);
  EXPECT_FALSE((autodiff::Compiled<BandFunctor<Membrane<3>>>::reads_active(0)));
}

}  // namespace
}  // namespace shellmatch
