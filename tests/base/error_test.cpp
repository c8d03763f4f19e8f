#include "base/error.h"

#include <gtest/gtest.h>

#include <string>

namespace shellmatch {
namespace {

template <class Exception, class Body>
std::string text_of(Body&& body) {
  try {
    body();
  } catch (const Exception& e) {
    return e.what();
  }
  return "nothing was thrown";
}

TEST(Error, BadInputCarriesItsFormattedText) {
  EXPECT_EQ(text_of<InputError>([] { throw_input_error("{}: line {}: no faces", "a.obj", 7); }),
            "a.obj: line 7: no faces");
}

TEST(Error, TheEnvironmentCarriesItsFormattedText) {
  EXPECT_EQ(text_of<EnvironmentError>([] { throw_environment_error("{} of {} bytes", 1, 2); }), "1 of 2 bytes");
}

// The program chooses its exit code by the type.
TEST(Error, TheKindsAreNotEachOther) {
  EXPECT_FALSE((std::is_base_of_v<InputError, EnvironmentError>));
  EXPECT_FALSE((std::is_base_of_v<EnvironmentError, InputError>));
  EXPECT_FALSE((std::is_base_of_v<std::logic_error, InputError>));
}

TEST(Error, AnInvariantThatHoldsIsSilent) { EXPECT_NO_THROW(SHELLMATCH_CHECK(1 + 1 == 2, "sums")); }

TEST(Error, ABrokenInvariantNamesItselfInEveryBuild) {
  const std::string text = text_of<std::logic_error>([] { SHELLMATCH_CHECK(1 + 1 == 3, "sums are off"); });
  EXPECT_NE(text.find("sums are off"), std::string::npos) << text;
  EXPECT_NE(text.find("1 + 1 == 3"), std::string::npos) << text;
  EXPECT_NE(text.find("error_test.cpp"), std::string::npos) << text;
}

// Used as a statement it must not capture the else of the code around it.
TEST(Error, ACheckIsOneStatement) {
  bool other = false;
  if (other) SHELLMATCH_CHECK(false, "not reached");
  else other = true;
  EXPECT_TRUE(other);
}

}  // namespace
}  // namespace shellmatch
