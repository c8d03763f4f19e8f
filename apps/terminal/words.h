#pragma once
/// \file
/// Numbers from words of the command line, lines for the terminal, and how much a command says.

#include <limits>
#include <string>
#include <string_view>

namespace shellmatch {

/// How many messages a command writes. Errors are always reported.
enum class Verbosity { quiet, normal, verbose };

/// \param option for the message, "--rings" \throws InputError for a word that is no whole number of the range
int whole_number(std::string_view word, std::string_view option, int least,
                 int greatest = std::numeric_limits<int>::max());

/// \throws InputError for a word that is no number of the range
double number(std::string_view word, std::string_view option, double least = std::numeric_limits<double>::lowest(),
              double greatest = std::numeric_limits<double>::max());

/// A line on stderr, control characters as escapes.
void say_line(std::string_view text);

}  // namespace shellmatch
