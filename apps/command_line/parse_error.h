#pragma once
/// \file
/// What is wrong with a command line, with the word that was meant.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace shellmatch {

/// CLI11's complaint names the words that it could not use; the suggestion is made from the words themselves.
/// \throws InputError always
[[noreturn]] void explain_parse_error(const CLI::App& app, const std::vector<std::string>& words,
                                      const std::string& complaint);

}  // namespace shellmatch
