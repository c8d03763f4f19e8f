#pragma once
/// \file
/// What a message must say.

#include "base/error.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace shellmatch {

/// Expects that `action` throws an InputError of one line whose text contains every one of `parts`.
template <class Action>
void expect_input_error(Action&& action, std::initializer_list<std::string> parts) {
  try {
    action();
    ADD_FAILURE() << "no error; expected one that says \"" << *parts.begin() << '"';
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    for (const std::string& part : parts)
      EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is missing in: " << text;
  }
}

}  // namespace shellmatch
