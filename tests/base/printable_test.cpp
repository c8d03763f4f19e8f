#include "base/printable.h"

#include <gtest/gtest.h>

namespace shellmatch {
namespace {

TEST(Printable, TextStaysAndControlCharactersAreWrittenOut) {
  EXPECT_EQ(printable("hand.ply: größer, 形状, 🙂"), "hand.ply: größer, 形状, 🙂");
  EXPECT_EQ(printable("a\x1b[31mb\n\tc\x7f"), "a\\x1b[31mb\\n\\tc\\x7f");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J"),
            "\\xc2\\x9b2J")
      << "a control sequence of one character";
  EXPECT_EQ(printable("a\u202egnp.exe"), "a\\xe2\\x80\\xaegnp.exe") << "a mark that turns what follows";
}

TEST(Printable, BytesThatAreNoUtf8AreWrittenOut) {
  EXPECT_EQ(printable("\x80"), "\\x80");
  EXPECT_EQ(printable("\xc3"), "\\xc3") << "cut off";
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf") << "longer than needed";
  EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a pair";
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond the last character";
  EXPECT_EQ(printable("\xff\xfe"), "\\xff\\xfe");
}

TEST(Printable, OfALongTextTheMiddleIsLeftOut) {
  const std::string text = "begin " + std::string(1000000, 'x') + " end";
  const std::string shown = printable(text, 100);
  EXPECT_EQ(shown.size(), 100u);
  EXPECT_TRUE(shown.starts_with("begin xxx") && shown.ends_with("xxx end")) << shown;
  EXPECT_NE(shown.find(" ... "), std::string::npos);
  EXPECT_EQ(printable(std::string(100, 'x'), 100), std::string(100, 'x'));
  EXPECT_LE(printable(std::string(101, '\x1b'), 100).size(), 100u);
  // No character is cut in two.
  for (std::size_t most = 20; most < 40; ++most) {
    std::string many;
    for (int i = 0; i < 50; ++i) many += "形";
    EXPECT_EQ(printable(printable(many, most)), printable(many, most));
    EXPECT_EQ(printable(many, most).find("\\x"), std::string::npos);
  }
}

}  // namespace
}  // namespace shellmatch
