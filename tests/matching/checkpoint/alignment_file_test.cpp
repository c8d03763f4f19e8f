// What an alignment has found is read as it was written, to the bit.

#include "matching/checkpoint/alignment_file.h"

#include "base/error.h"
#include "matching/output/write_file.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace shellmatch {
namespace {

using testing::contents_of;
using testing::message_of;
using testing::put;
using testing::TemporaryFolder;

template <int Dim>
StartSearch<Dim> search() {
  StartSearch<Dim> s;
  s.margin = std::numeric_limits<double>::infinity();
  s.reference_share = 0.1;
  s.template_share = 0.2;
  s.n_landmarks = 5;
  s.notes = {"a note"};
  s.landmarks_are_spread = true;
  s.is_ambiguous = true;
  for (int i = 0; i < 2; ++i) {
    Start<Dim>& start = s.starts.emplace_back();
    start.alignment.pose = {1.0 / 3, Vec<Dim>::Constant(0.1 + i), -Mat<Dim>::Identity()};
    start.alignment.pose.rotation(0, 1) = 1e-300;
    start.alignment.spread = 1.7;
    if (i == 1) start.alignment.landmark_trust = 0.3;
    for (int k = 0; k < 11; ++k)
      start.alignment.pairs.push_back(
          {pair_name(start.alignment.pairs.size()), Vec<Dim>::Constant(std::sqrt(k)), Vec<Dim>::Constant(-k), 0.7});
    start.n_pairs = 10;
    if (i == 1) start.pair_share = 0.9;
    start.n_contradicting = 1;
    start.score = 0.2;
    start.order = 0.3;
    start.margin = 1.1;
    start.is_identity = i == 0;
    start.is_mirrored = i == 1;
  }
  return s;
}

template <int Dim>
AlignmentFindings<Dim> findings() {
  AlignmentFindings<Dim> f;
  f.by_pairs = {{search<Dim>()}, 3.5};
  f.by_poses = {{search<Dim>(), search<Dim>()}, 0.5};
  f.fits_mirrored = {{true}, 1};
  f.trials.starts = {{Trial{}, Trial{1, 2, 3, 0.4}}, 7};
  f.trials.directions = {{DirectionTrial{}, DirectionTrial{0.1, 0.2}}, 2};
  return f;
}

template <int Dim>
void expect_same(const StartSearch<Dim>& a, const StartSearch<Dim>& b) {
  EXPECT_EQ(a.margin, b.margin);
  EXPECT_EQ(a.reference_share, b.reference_share);
  EXPECT_EQ(a.template_share, b.template_share);
  EXPECT_EQ(a.n_landmarks, b.n_landmarks);
  EXPECT_EQ(a.notes, b.notes);
  EXPECT_EQ(a.landmarks_are_spread, b.landmarks_are_spread);
  EXPECT_EQ(a.is_of_part, b.is_of_part);
  EXPECT_EQ(a.is_ambiguous, b.is_ambiguous);
  ASSERT_EQ(a.starts.size(), b.starts.size());
  for (std::size_t i = 0; i < a.starts.size(); ++i) {
    const Start<Dim>&s = a.starts[i], &t = b.starts[i];
    EXPECT_EQ(s.n_pairs, t.n_pairs);
    EXPECT_EQ(s.pair_share, t.pair_share);
    EXPECT_EQ(s.n_contradicting, t.n_contradicting);
    EXPECT_EQ(s.score, t.score);
    EXPECT_EQ(s.order, t.order);
    EXPECT_EQ(s.margin, t.margin);
    EXPECT_EQ(s.landmark_distance, t.landmark_distance);
    EXPECT_EQ(s.is_identity, t.is_identity);
    EXPECT_EQ(s.is_mirrored, t.is_mirrored);
    EXPECT_EQ(s.alignment.spread, t.alignment.spread);
    EXPECT_EQ(s.alignment.landmark_trust, t.alignment.landmark_trust);
    EXPECT_EQ(s.alignment.pose.scale, t.alignment.pose.scale);
    EXPECT_EQ(s.alignment.pose.offset, t.alignment.pose.offset);
    EXPECT_EQ(s.alignment.pose.rotation, t.alignment.pose.rotation);
    ASSERT_EQ(s.alignment.pairs.size(), t.alignment.pairs.size());
    for (std::size_t k = 0; k < s.alignment.pairs.size(); ++k) {
      const Landmark<Dim>&p = s.alignment.pairs[k], &q = t.alignment.pairs[k];
      EXPECT_EQ(p.name, q.name);
      EXPECT_EQ(p.on_reference, q.on_reference);
      EXPECT_EQ(p.on_template, q.on_template);
      EXPECT_EQ(p.weight, q.weight);
    }
  }
}

template <int Dim>
void check_written_and_read() {
  const TemporaryFolder tmp;
  const AlignmentFindings<Dim> f = findings<Dim>();
  write_alignment(f, tmp / "a");
  const AlignmentFindings<Dim> g = read_alignment<Dim>(tmp / "a");
  EXPECT_EQ(g.size(), 8u);
  EXPECT_EQ(g.seconds(), f.seconds());
  expect_same(f.by_pairs.results[0], g.by_pairs.results[0]);
  expect_same(f.by_poses.results[1], g.by_poses.results[1]);
  EXPECT_EQ(g.fits_mirrored.results, std::vector<bool>{true});
  EXPECT_TRUE(std::isinf(g.trials.starts.results[0].energy));
  EXPECT_FALSE(g.trials.starts.results[0].spin_difference);
  EXPECT_EQ(g.trials.starts.results[1].with_pairs, 2);
  EXPECT_EQ(g.trials.starts.results[1].template_distance, 3);
  EXPECT_EQ(g.trials.starts.results[1].spin_difference, 0.4);
  EXPECT_TRUE(std::isinf(g.trials.directions.results[0].distance));
  EXPECT_EQ(g.trials.directions.results[1].energy, 0.2);
  // Of the other dimension it is none.
  EXPECT_NE(message_of<InputError>([&] { read_alignment<5 - Dim>(tmp / "a"); }).find("poses are not"),
            std::string::npos);
  const std::string bytes = contents_of(tmp / "a");
  put(tmp / "cut", bytes.substr(0, bytes.size() / 2));
  EXPECT_THROW(read_alignment<Dim>(tmp / "cut"), InputError);
  EXPECT_THROW(read_alignment<Dim>(tmp / "absent"), InputError);
}

TEST(AlignmentFile, IsReadAsItWasWritten) {
  check_written_and_read<2>();
  check_written_and_read<3>();
}

TEST(AlignmentFile, RefusesWhatNoAlignmentFinds) {
  const TemporaryFolder tmp;
  AlignmentFindings<3> f = findings<3>();
  f.by_pairs.results[0].starts[0].n_contradicting = 12;
  write_alignment(f, tmp / "a");
  EXPECT_THROW(read_alignment<3>(tmp / "a"), InputError);
  f = findings<3>();
  f.by_poses.results[1].starts.clear();
  write_alignment(f, tmp / "a");
  EXPECT_THROW(read_alignment<3>(tmp / "a"), InputError);
}

TEST(KeptResults, ComputesOnlyWhatNobodyHasFound) {
  KeptResults<int> found{{7, 8}, 1.0};
  int n = 0;
  const auto compute = [&] { return 10 + ++n; };
  EXPECT_EQ(found.next(compute), 7);
  EXPECT_EQ(found.next(compute), 8);
  EXPECT_EQ(n, 0);
  EXPECT_EQ(found.next(compute, [](int i) { return -i; }), 11);
  EXPECT_EQ(found.results, (std::vector{7, 8, -11}));
  EXPECT_GE(found.seconds, 1.0);
}

}  // namespace
}  // namespace shellmatch
