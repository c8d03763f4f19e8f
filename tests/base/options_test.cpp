#include "base/options.h"

#include "base/types.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace shellmatch {

enum class Fruit { apple, pear };
template <>
struct EnumNames<Fruit> {
  static constexpr std::pair<Fruit, std::string_view> names[] = {{Fruit::apple, "apple"}, {Fruit::pear, "pear"}};
};

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
const std::vector<std::string> words = {"sigma", "nu", "volume", "max_level", "min_level"};

TEST(NearestWord, FindsTheWordBehindASlip) {
  EXPECT_EQ(nearest_word("sigma", words), "sigma");
  EXPECT_EQ(nearest_word("sigm", words), "sigma");    // one letter missing
  EXPECT_EQ(nearest_word("siggma", words), "sigma");  // one too many
  EXPECT_EQ(nearest_word("sugma", words), "sigma");   // one wrong
  EXPECT_EQ(nearest_word("simga", words), "sigma");   // two swapped
  EXPECT_EQ(nearest_word("maxlevel", words), "max_level");
}

TEST(NearestWord, TakesTheNearerOfTwo) {
  EXPECT_EQ(nearest_word("mim_level", words), "min_level");
  EXPECT_EQ(nearest_word("mxa_level", words), "max_level");
}

// A swap is one slip, not two: without that "abdc" would be as near to "abcd" as to "axdy".
TEST(NearestWord, ASwapIsOneSlip) { EXPECT_EQ(nearest_word("abdc", {"xbdy", "abcd"}), "abcd"); }

TEST(NearestWord, IsEmptyWhereNothingIsNear) {
  EXPECT_EQ(nearest_word("temperature", words), "");
  EXPECT_EQ(nearest_word("sigma", {}), "");
}

// A long word may differ in a third of its letters, a short one in two.
TEST(NearestWord, ForgivesMoreInLongWords) {
  EXPECT_EQ(nearest_word("abcdefghijkl", {"abcdefghwxyz"}), "abcdefghwxyz");
  EXPECT_EQ(nearest_word("abcdefghijkl", {"abcdefgvwxyz"}), "");
  EXPECT_EQ(nearest_word("abc", {"axy"}), "axy");
  EXPECT_EQ(nearest_word("abc", {"wxy"}), "");
}

TEST(Range, IncludesItsEndsUnlessTheyAreExcluded) {
  const OptionInfo closed{.min = 0, .max = 1};
  EXPECT_TRUE(in_range(0, closed));
  EXPECT_TRUE(in_range(1, closed));
  EXPECT_FALSE(in_range(-1e-300, closed));
  EXPECT_FALSE(in_range(1 + 1e-15, closed));
  const OptionInfo open{.min = 0, .max = 1, .min_excluded = true};
  EXPECT_FALSE(in_range(0, open));
  EXPECT_TRUE(in_range(1e-300, open));
}

TEST(Range, NeverHoldsNotANumber) {
  EXPECT_FALSE(in_range(nan_value, {}));
  EXPECT_FALSE(in_range(nan_value, {.min = 0, .max = 1}));
  EXPECT_TRUE(in_range(1e300, {}));
  EXPECT_FALSE(in_range(infinity, {.max = 1}));
}

TEST(Range, IsSaidInWords) {
  EXPECT_EQ(range_text({.min = 0, .max = 1}), "0 <= x <= 1");
  EXPECT_EQ(range_text({.min = 0, .max = 0.5, .min_excluded = true}), "0 < x <= 0.5");
  EXPECT_EQ(range_text({.min = 3}), "x >= 3");
  EXPECT_EQ(range_text({.min = 0, .min_excluded = true}), "x > 0");
  EXPECT_EQ(range_text({.max = 12}), "x <= 12");
  EXPECT_EQ(range_text({}), "any");
}

TEST(Enum, NamesItsValues) {
  EXPECT_EQ(enum_name(Fruit::apple), "apple");
  EXPECT_EQ(enum_name(Fruit::pear), "pear");
  EXPECT_EQ(enum_name(static_cast<Fruit>(7)), "?");
}

}  // namespace
}  // namespace shellmatch
