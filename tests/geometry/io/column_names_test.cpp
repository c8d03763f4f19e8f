// Names of columns that are no words, or mean something to a format: what is written is read back.
#include "geometry/io/read_shape.h"
#include "geometry/mesh_text/read_text.h"
#include "geometry/io/write_shape.h"
#include "tests/geometry/io/files.h"

namespace shellmatch::testing {
namespace {

OriginalShape<3> cube_with_columns(const std::vector<std::string>& names) {
  OriginalShape<3> shape = cube();
  for (const std::string& name : names)
    shape.attributes.push_back(
        {name, "double", std::vector<double>(8, static_cast<double>(shape.attributes.size()) + 0.5)});
  return shape;
}

std::vector<std::string> names_of(const OriginalShape<3>& shape) {
  std::vector<std::string> names;
  for (const VertexAttribute& a : shape.attributes) names.push_back(a.name);
  return names;
}

TEST(ColumnNames, OfPlyAreDifferentWordsAndNoCoordinates) {
  const TempFolder folder;
  const OriginalShape<3> shape =
      cube_with_columns({"x", "y", "z", "nx", "ny", "nz", "a b", "a_b", "a\tb", "x_2", "", "n", "nxy"});
  write_ply(folder.path("a.ply"), shape);
  std::vector<std::string> notes;
  const OriginalShape<3> read = read_points_or_mesh_3d(folder.path("a.ply"), &notes);
  EXPECT_TRUE(notes.empty()) << "no column is taken for a normal";
  EXPECT_EQ(read.vertices, shape.vertices);
  EXPECT_EQ(names_of(read), (std::vector<std::string>{"x_2", "y_2", "z_2", "nx_2", "ny_2", "nz_2", "a_b", "a_b_2",
                                                      "a_b_3", "x_2_2", "unnamed", "n", "nxy"}));
  for (std::size_t k = 0; k < shape.attributes.size(); ++k)
    EXPECT_EQ(read.attributes[k].values, shape.attributes[k].values);
  EXPECT_TRUE(left_out("b.ply", read).empty());
  const std::vector<std::string> lost = left_out("b.ply", cube_with_columns({"quality", "x", "a b"}));
  EXPECT_EQ(lost, (std::vector<std::string>{"the name of the column 'x' ('x_2' instead)",
                                            "the name of the column 'a b' ('a_b' instead)"}));
}

TEST(ColumnNames, OfTablesMayHoldBlanksCommasAndQuotes) {
  const TempFolder folder;
  const std::vector<std::string> names{"Mean Curvature", "a, b", "12 \"inches\"", "no. #1", "x", ","};
  write_shape(folder.path("a.csv"), cube_with_columns(names));
  const OriginalShape<3> read = read_points_or_mesh_3d(folder.path("a.csv"));
  EXPECT_EQ(read.vertices, cube().vertices);
  EXPECT_EQ(names_of(read), names);
  for (std::size_t k = 0; k < names.size(); ++k) EXPECT_EQ(read.attributes[k].values[7], static_cast<double>(k) + 0.5);
}

TEST(ColumnNames, InTablesOfOthers) {
  const TempFolder folder;
  const auto names = [&](const std::string& text) {
    return names_of(read_points_or_mesh_3d(folder.write("a.csv", text)));
  };
  EXPECT_EQ(names("x, y, z, shell thickness (mm)\n1,2,3,4\n"), std::vector<std::string>{"shell thickness (mm)"});
  EXPECT_EQ(names("x,y,z,w,\n1,2,3,4,\n"), std::vector<std::string>{"w"});
  EXPECT_EQ(names("x y z w\n1 2 3 4\n"), std::vector<std::string>{"w"});
  EXPECT_EQ(names("x;y;z;w\n1;2;3;4\n"), std::vector<std::string>{"w"});
  EXPECT_TRUE(contains(input_error_of([&] { names("x,y,,z\n1,2,3,4\n"); }), "line 1: a column is empty"));
  EXPECT_TRUE(contains(input_error_of([&] { names(",\n"); }), "separators, but no numbers"));
}

TEST(ColumnNames, AFurtherColumnThatBeginsWithATextHoldsTexts) {
  const TempFolder folder;
  const std::string table = "id,x,y,z,side,depth\n7,1,2,3,\"left, upper\",0.5\n8,4,5,6,right,1.5\n9,7,8,9,,2\n";
  const OriginalShape<3> read = read_points_or_mesh_3d(folder.write("a.csv", table));
  EXPECT_EQ(names_of(read), (std::vector<std::string>{"id", "side", "depth"}));
  EXPECT_EQ(read.attributes[1].texts, (std::vector<std::string>{"left, upper", "right", ""}));
  EXPECT_EQ(read.attributes[2].values, (std::vector<double>{0.5, 1.5, 2}));
  write_shape(folder.path("b.csv"), read);
  EXPECT_EQ(read_points_or_mesh_3d(folder.path("b.csv")).attributes[1].texts, read.attributes[1].texts);
  const auto message = [&](const std::string& text) {
    return input_error_of([&] { read_points_or_mesh_3d(folder.write("a.csv", text)); });
  };
  EXPECT_TRUE(contains(message("x,y,z,depth\n1,2,3,4\n1,2,3,deep\n"), "should be a number, not 'deep'"));
  EXPECT_TRUE(contains(message("x;y;z\n1,5;2;3\n"), "if commas are decimal, as in 1,5, write points"));
  EXPECT_TRUE(contains(message("1,5;2;3\n"), "if commas are decimal, as in 1,5, write points"));
}

TEST(ColumnNames, AHashInQuotesBeginsNoComment) {
  const TempFolder folder;
  OriginalShape<3> shape = cube();
  shape.attributes.push_back({"name", "text", {}, {"#1", "a #2", "\"#\"", "plain", "5\" # 6\"", ",#", "#", "\""}});
  write_shape(folder.path("a.csv"), shape);
  const OriginalShape<3> read = read_points_or_mesh_3d(folder.path("a.csv"));
  ASSERT_EQ(read.attributes.size(), 1u);
  EXPECT_EQ(read.attributes[0].texts, shape.attributes[0].texts);
  const auto line_of = [](std::string_view text) {
    LineReader lines("a", text);
    lines.next();
    return std::string(lines.line());
  };
  EXPECT_EQ(line_of("1 2 # comment"), "1 2");
  EXPECT_EQ(line_of("\"a # b\", 2 # \"comment\""), "\"a # b\", 2");
  EXPECT_EQ(line_of("\"a \"\"#\"\" b\" # c"), "\"a \"\"#\"\" b\"");
  EXPECT_EQ(line_of("5\" # 6\""), "5\"") << "a quote within a word opens nothing";
  EXPECT_EQ(line_of("\"open # never closed"), "\"open");
}

}  // namespace
}  // namespace shellmatch::testing
