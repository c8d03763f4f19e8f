// Points in the formats of other programs: each text as those programs document it, and Slicer's read back.

#include "matching/pairs/point_formats.h"
#include "matching/pairs/slicer_points.h"
#include "tests/matching/output/temporary_folder.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

using testing::put;
using testing::TemporaryFolder;

PointSet<3> two_points() { return {"skull", {"nose, tip", "gone"}, {Vec<3>(1.5, -2, 0.1), std::nullopt}}; }

TEST(PointFormats, AreToldByTheEnding) {
  for (const auto& [name, format] : {std::pair{"a.fcsv", PointFormat::fcsv},
                                     {"a.MRK.json", PointFormat::markups},
                                     {"a.TPS", PointFormat::tps},
                                     {"a.txt", PointFormat::morphologika},
                                     {"a.csv", PointFormat::none},
                                     {"a.json", PointFormat::none},
                                     {"a.ply", PointFormat::none}})
    EXPECT_EQ(point_format(name), format) << name;
}

TEST(PointFormats, SlicersAreReadBack) {
  const TemporaryFolder folder;
  for (const auto& [name, format] : {std::pair{"a.fcsv", PointFormat::fcsv}, {"a.mrk.json", PointFormat::markups}})
    for (const Space space : {Space::ras, Space::lps}) {
      put(folder / name, point_sets_text<3>(format, {two_points()}, space));
      const SlicerPoints file = read_slicer_points(folder / name);
      ASSERT_EQ(file.points.size(), 2u) << name;
      EXPECT_EQ(file.points[0].name, "nose, tip");
      EXPECT_EQ(file.points[0].position, Vec<3>(1.5, -2, 0.1));
      EXPECT_EQ(file.points[0].space, space);
      EXPECT_TRUE(file.points[0].has_position);
      EXPECT_FALSE(file.points[1].has_position);
    }
}

TEST(PointFormats, TpsHasOneBlockForEachIndividual) {
  EXPECT_EQ(
      point_sets_text<3>(PointFormat::tps, {two_points(), {"b\nc", {"1", "2"}, {Vec<3>(1, 2, 3), Vec<3>(4, 5, 6)}}},
                         Space::lps),
      "LM3=2\n1.5 -2 0.1\nNA NA NA\nID=skull\nCOMMENT=SPACE=LPS\nLM3=2\n1 2 3\n4 5 6\nID=b c\nCOMMENT=SPACE=LPS\n");
  EXPECT_EQ(point_sets_text<2>(PointFormat::tps, {{"leaf", {"1"}, {Vec<2>(0.25, 3)}}}, Space::unsaid),
            "LM=1\n0.25 3\nID=leaf\n");
}

TEST(PointFormats, MorphologikaNamesTheFrameAsALabel) {
  EXPECT_EQ(point_sets_text<3>(PointFormat::morphologika, {two_points()}, Space::ras),
            "[individuals]\n1\n[landmarks]\n2\n[dimensions]\n3\n[names]\nskull\n[labels]\nSPACE\n[labelvalues]\nRAS\n["
            "rawpoints]\n'skull\n1.5 -2 0.1\nNA NA NA\n");
  EXPECT_EQ(point_sets_text<2>(PointFormat::morphologika, {{"a", {"1"}, {Vec<2>(1, 2)}}, {"b", {"1"}, {Vec<2>(3, 4)}}},
                               Space::unsaid),
            "[individuals]\n2\n[landmarks]\n1\n[dimensions]\n2\n[names]\na\nb\n[rawpoints]\n'a\n1 2\n'b\n3 4\n");
}

}  // namespace
}  // namespace shellmatch
