// The strict reader on a struct of its own that has every kind of option.

#include "matching/experiment/several_errors.h"
#include "matching/experiment/option_text.h"
#include "matching/experiment/yaml_document.h"
#include "tests/support/expect_input_error.h"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace shellmatch {

enum class Colour { red, green };
template <>
struct EnumNames<Colour> {
  static constexpr std::pair<Colour, std::string_view> names[] = {{Colour::red, "red"}, {Colour::green, "green"}};
};

namespace {

struct Inner {
  bool flag = false;
  std::vector<int> counts = {1, 2};
  std::vector<Colour> colours;
  static void describe(auto& self, auto& visit) {
    visit("flag", self.flag, {.meaning = "a flag"});
    visit("counts", self.counts, {.min = 0, .max = 9, .meaning = "some counts"});
    visit("colours", self.colours, {.meaning = "some colours"});
  }
};

struct Outer {
  int count = 3;
  double length = 0.5;
  std::string file;
  Colour colour = Colour::red;
  Inner inner;
  static void describe(auto& self, auto& visit) {
    visit("count", self.count, {.unit = "things", .min = 1, .max = 5, .meaning = "a count"});
    visit("length", self.length, {.unit = "length", .min = 0, .min_excluded = true, .meaning = "a length"});
    visit("file", self.file, {.meaning = "a file"});
    visit("colour", self.colour, {.meaning = "a colour"});
    visit("inner", self.inner, {.meaning = "more"});
  }
};

Outer read(const std::string& text) {
  Outer options;
  YamlDocument::from_text(text, "test.yaml").fill(option_tree(options));
  return options;
}

void expect_refused(const std::string& text, std::initializer_list<std::string> parts) {
  SCOPED_TRACE(text.substr(0, 100));
  expect_input_error([&] { read(text); }, parts);
}

TEST(YamlDocument, SetsEveryKindOfOption) {
  const Outer options = read(
      "count: 4\nlength: 1e-3\nfile: 'a b#c.ply'\ncolour: green\n"
      "inner:\n  flag: true\n  counts: [7, 8, 9]\n  colours:\n  - green\n  - red\n");
  EXPECT_EQ(options.count, 4);
  EXPECT_EQ(options.length, 1e-3);
  EXPECT_EQ(options.file, "a b#c.ply");
  EXPECT_EQ(options.colour, Colour::green);
  EXPECT_TRUE(options.inner.flag);
  EXPECT_EQ(options.inner.counts, (std::vector<int>{7, 8, 9}));
  EXPECT_EQ(options.inner.colours, (std::vector<Colour>{Colour::green, Colour::red}));
}

TEST(YamlDocument, LeavesWhatIsNotNamed) {
  const Outer options = read("inner: {flag: true}");
  EXPECT_EQ(options.count, 3);
  EXPECT_EQ(options.inner.counts, (std::vector<int>{1, 2}));
}

TEST(YamlDocument, EmptyListIsAValue) { EXPECT_TRUE(read("inner: {counts: []}").inner.counts.empty()); }

TEST(YamlDocument, UnknownKeyNamesLineAndNeighbour) {
  expect_refused("length: 1\ncuont: 2\n", {"test.yaml:2:", "cuont", "did you mean count?", "allowed at the top",
                                           "count, length, file, colour, inner"});
  expect_refused("inner:\n  flga: true\n",
                 {"test.yaml:2:", "inner", "flga", "did you mean inner.flag?", "flag, counts"});
  expect_refused("flag: true\n", {"test.yaml:1:", "did you mean inner.flag?"});
  expect_refused("<<: {count: 2}\n", {"test.yaml:1:", "unknown key"});
}

// Of one file: whoever mends it needs not run again to learn of the next.
TEST(YamlDocument, AllMistakesAreTold) {
  try {
    read("count: many\ninner: {flag: perhaps, cuonts: [1]}\nlength: 2\nlenght: 1\n");
    FAIL() << "accepted";
  } catch (const SeveralInputErrors& errors) {
    const std::vector<std::string>& texts = errors.texts();
    ASSERT_EQ(texts.size(), 4u) << errors.what();
    EXPECT_NE(texts[0].find(":1: count"), std::string::npos) << texts[0];
    EXPECT_NE(texts[1].find(":2: inner.flag"), std::string::npos) << texts[1];
    EXPECT_NE(texts[2].find("did you mean inner.counts?"), std::string::npos) << texts[2];
    EXPECT_NE(texts[3].find("did you mean length?"), std::string::npos) << texts[3];
  }
  std::string many;
  for (int i = 0; i < 25; ++i) many += fmt::format("unknown_{}: 1\n", i);
  try {
    read(many);
    FAIL() << "accepted";
  } catch (const SeveralInputErrors& errors) {
    ASSERT_EQ(errors.texts().size(), 11u);
    EXPECT_NE(errors.texts().back().find("15 mistakes more"), std::string::npos) << errors.texts().back();
  }
}

TEST(YamlDocument, DoubleKeyNamesBothLines) {
  expect_refused("count: 2\nlength: 1\ncount: 2\n", {"test.yaml:3:", "count", "line 1"});
  expect_refused("inner:\n  flag: true\ninner:\n  flag: true\n", {"test.yaml:3:", "inner", "line 1"});
}

TEST(YamlDocument, IntegersAreIntegers) {
  for (const char* value : {"3.5", "3.0", "three", "'3'", "1e0", "0x3", "true", "3 4", "+-3", "[3]", "{a: 3}"})
    expect_refused(std::string("\ncount: ") + value, {"test.yaml:2: count", "an integer, 1 <= x <= 5"});
  for (const char* value : {"0", "6", "-1", "99999999999999999999"})
    expect_refused(std::string("count: ") + value, {"test.yaml:1: count", "out of range", "1 <= x <= 5"});
  EXPECT_EQ(read("count: +3").count, 3);
}

TEST(YamlDocument, NumbersAreFinite) {
  for (const char* value : {"long", "nan", ".nan", "inf", ".inf", "-inf", "1.0.0", "1,5", "'1.5'", "1 m", "0x1p3"})
    expect_refused(std::string("length: ") + value, {"test.yaml:1: length", "a finite number, x > 0"});
  for (const char* value : {"0", "-1", "-0.0"})
    expect_refused(std::string("length: ") + value, {"test.yaml:1: length", "out of range", "x > 0"});
  for (const char* value : {"1e999", "1e-999"})
    expect_refused(std::string("length: ") + value, {"too large or too small"});
  for (const char* value : {"2", "2.", "+2", "2e0", ".2e1"})
    EXPECT_EQ(read(std::string("length: ") + value).length, 2) << value;
}

TEST(YamlDocument, TruthIsSpeltOneWay) {
  for (const char* value : {"yes", "on", "True", "TRUE", "y", "1"})
    expect_refused(std::string("inner: {flag: ") + value + "}", {"inner.flag", "true or false", "did you mean true?"});
  for (const char* value : {"no", "off", "False", "N", "0"})
    expect_refused(std::string("inner: {flag: ") + value + "}", {"inner.flag", "did you mean false?"});
  expect_refused("inner: {flag: flase}", {"did you mean false?"});
}

TEST(YamlDocument, ChoicesNameTheirNeighbours) {
  expect_refused("colour: gren", {"test.yaml:1: colour", "one of red, green", "did you mean green?"});
  expect_refused("colour: Red", {"did you mean red?"});
  expect_refused("inner:\n  colours: [red, 'green']", {"test.yaml:2: inner.colours", "without quotes"});
}

TEST(YamlDocument, ListsAreLists) {
  expect_refused("inner: {counts: 3}", {"inner.counts", "a list"});
  expect_refused("inner: {counts: [3, 10]}", {"inner.counts", "out of range", "0 <= x <= 9"});
  expect_refused("inner: {counts: [3, [4]]}", {"inner.counts"});
}

TEST(YamlDocument, ValuesMayNotBeMissing) {
  for (const char* text : {"count:", "count: ~", "count: null", "file:"}) expect_refused(text, {"has no value"});
  expect_refused("inner:\ncount: 2", {"test.yaml:1: inner", "the section is empty", "flag, counts, colours"});
  expect_refused("inner: 7", {"test.yaml:1: inner", "no section"});
  expect_refused("inner: [flag]", {"test.yaml:1: inner", "no section"});
  expect_refused("count: !!int 3", {"tag"});
}

TEST(YamlDocument, OneMapPerFile) {
  expect_refused("", {"test.yaml:", "empty"});
  expect_refused("# only a comment\n", {"test.yaml:", "empty"});
  expect_refused("- a\n- b\n", {"test.yaml:1:", "a list"});
  expect_refused("just text\n", {"test.yaml:1:", "a single value"});
  expect_refused("count: 2\n---\ncount: 3\n", {"test.yaml:3:", "second YAML document"});
  expect_refused(std::string("count: 2\0", 9), {"zero bytes"});
  expect_refused("? [a]\n: 2\n", {"test.yaml:1:", "a key must be a word"});
}

TEST(YamlDocument, SyntaxErrorsNameTheLine) {
  expect_refused("count: 2\nlength: [1,\n", {"test.yaml:", "syntax"});
  expect_refused("count: 2\nlength: \"\\q\"\n", {"test.yaml:2:", "syntax"});
  expect_refused("count: 2\n\tlength: 1\n", {"test.yaml:2:", "syntax"});
  expect_refused("count: *nowhere\n", {"test.yaml:1:", "syntax"});
}

TEST(YamlDocument, HostileDocumentsEndInAMessage) {
  for (const char* piece : {"[", "{a: ", "- ", "? ", "a:\n ", "&a [", "!t "}) {
    std::string text;
    for (int i = 0; i < 20000; ++i) text += piece;
    SCOPED_TRACE(piece);
    EXPECT_THROW(read(text), InputError);
  }
  // Every line doubles what the one before stands for.
  std::string bomb = "a0: &a0 [x, x]\n";
  for (int i = 1; i < 60; ++i) bomb += fmt::format("a{0}: &a{0} [*a{1}, *a{1}]\n", i, i - 1);
  EXPECT_THROW(read(bomb), InputError);
  EXPECT_THROW(read("inner: &i\n  counts: *i\n"), InputError);
  EXPECT_THROW(read("inner: &i {inner: *i}\n"), InputError);
}

TEST(YamlDocument, FilesThatCannotBeRead) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "shellmatch_yaml_files";
  fs::create_directories(folder);
  const std::string big = (folder / "big.yaml").string();
  std::ofstream(big) << std::string((1 << 20) + 1, '#');
  expect_input_error([&] { YamlDocument::from_file((folder / "none.yaml").string()); }, {"none.yaml", "no such file"});
  expect_input_error([&] { YamlDocument::from_file(folder.string()); }, {"is a folder"});
  expect_input_error([&] { YamlDocument::from_file(big); }, {"big.yaml", "larger than 1 MB"});
  fs::remove_all(folder);
}

TEST(OptionText, RealsRoundTripExactly) {
  Outer options;
  const OptionNode root = option_tree(options);
  const OptionNode& length = *find_option(root, "length");
  double mantissa = 1.0 / 3;
  for (int i = 0; i < 2000; ++i) {
    mantissa = std::fmod(mantissa * 7919.123 + 0.137, 1.0);
    const double value = mantissa * std::pow(10.0, i % 600 - 300);
    const std::string text = scalar_text(value, OptionKind::real);
    EXPECT_EQ(std::get<double>(parse_scalar(length, text, false, "test")), value) << text;
  }
}

TEST(OptionText, AnyTextRoundTripsThroughYaml) {
  for (const char* text :
       {"", "a b", "true", "3", "~", "c:\\d\\", "say \"it\"", "#no comment", "a: b", "line\nbreak\ttab", "bell\a",
        "é漢", "generate:hand/bent", " spaces ", "%@`", "-", "{x", "'"}) {
    Outer options;
    options.file = text;
    const OptionNode root = option_tree(options);
    EXPECT_EQ(read("file: " + value_text(*find_option(root, "file"))).file, text);
  }
}

}  // namespace
}  // namespace shellmatch
