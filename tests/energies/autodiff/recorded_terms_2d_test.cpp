#include "tests/energies/autodiff/recorded_terms.h"

namespace shellmatch {
namespace {

using namespace test;

TEST(RecordedTerms2d, Match) { check_band_term<Match<2>>(); }
TEST(RecordedTerms2d, Membrane) { check_band_term<Membrane<2>>(); }
TEST(RecordedTerms2d, Bending) { check_band_term<Bending<2>>(); }
TEST(RecordedTerms2d, MembraneWithoutP2) { check_band_term<MembraneWithoutP2<2>>(); }
TEST(RecordedTerms2d, CauchyGreenMembrane) { check_band_term<CauchyGreenMembrane<2>>(); }
TEST(RecordedTerms2d, BendingWithoutP2) { check_band_term<BendingWithoutP2<2>>(); }
TEST(RecordedTerms2d, QuadraticBending) { check_band_term<QuadraticBending<2>>(); }
TEST(RecordedTerms2d, SimplifiedVolume) { check_volume_term<SimplifiedVolume<2>>(); }
TEST(RecordedTerms2d, FullVolume) { check_volume_term<FullVolume<2>>(); }
TEST(RecordedTerms2d, SymmetricDirichletVolume) { check_volume_term<SymmetricDirichletVolume<2>>(); }
TEST(RecordedTerms2d, FoldBarrier) { check_barrier<2>(); }

}  // namespace
}  // namespace shellmatch
