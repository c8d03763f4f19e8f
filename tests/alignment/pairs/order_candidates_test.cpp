// Which of several candidates comes first.

#include "alignment/pairs/order_candidates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace shellmatch {
namespace {

struct Candidate {
  char name;
  double score, angle = 0;
  bool is_identity = false, is_mirrored = false, is_symmetry = false;
  std::vector<int> pairs = {1};
};

std::string ordered(std::vector<Candidate> candidates) {
  order_candidates(candidates, {1.1, 0.01}, [](const Candidate& c) { return c.angle; });
  std::string names;
  for (const Candidate& c : candidates) names += c.name;
  return names;
}

TEST(OrderCandidates, TheBestFirstAndTheOthersByScore) { EXPECT_EQ(ordered({{'a', 3}, {'b', 1}, {'c', 2}}), "bca"); }

TEST(OrderCandidates, OfThoseThatScoreAlikeTheOneThatTurnsLeast) {
  EXPECT_EQ(ordered({{'a', 1.00, 2}, {'b', 1.05, -1}, {'c', 1.10, -1.5}, {'d', 2, 0}}), "bacd");
  EXPECT_EQ(ordered({{'a', 1.00, 2}, {'b', 1.05, 0, false, true}}), "ab");
  // Mirrored ones have to be clearly better.
  EXPECT_EQ(ordered({{'a', 1.00, 2}, {'b', 0.95, 0, false, true}}), "ab");
  EXPECT_EQ(ordered({{'a', 1.00, 2}, {'b', 0.70, 0, false, true}}), "ba");
}

TEST(OrderCandidates, OfThoseThatScoreAlikeTheIdentity) {
  EXPECT_EQ(ordered({{'a', 1.00, 0}, {'b', 1.10, 1, true}}), "ba");
  EXPECT_EQ(ordered({{'a', 1.00, 0}, {'b', 1.12, 1, true}}), "ab");
  // Scores of zero differ by noise.
  EXPECT_EQ(ordered({{'a', 0, 0}, {'b', 0.009, 1, true}}), "ba");
}

TEST(OrderCandidates, OneWithoutPairsIsNotTheBest) {
  EXPECT_EQ(ordered({{'a', 0.1, 0, true, false, false, {}}, {'b', 2, 1}, {'c', 1, 1}}), "cba");
}

TEST(MarginOfFirst, LeavesSymmetriesOut) {
  std::vector<Candidate> candidates{{'a', 1}, {'b', 1.2}, {'c', 1.5}};
  const auto symmetric_to_b = [](const Candidate& a, const Candidate& b) { return a.name == 'a' && b.name == 'b'; };
  EXPECT_DOUBLE_EQ(margin_of_first(candidates, 0.01, symmetric_to_b), 1.5);
  EXPECT_TRUE(candidates[1].is_symmetry);
  EXPECT_FALSE(candidates[2].is_symmetry);
  candidates.resize(2);
  EXPECT_TRUE(std::isinf(margin_of_first(candidates, 0.01, symmetric_to_b)));
  // On a shape that is its own mirror image the other handedness is as good, and as right.
  candidates = {{'a', 1}, {'c', 1.1, 0, false, true}, {'d', 3}};
  EXPECT_DOUBLE_EQ(margin_of_first(candidates, 0.01, symmetric_to_b), 3);
  candidates = {{'a', 0}, {'c', 0.02}};
  EXPECT_DOUBLE_EQ(margin_of_first(candidates, 0.01, symmetric_to_b), 2);
}

}  // namespace
}  // namespace shellmatch
