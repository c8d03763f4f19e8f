#pragma once
/// \file
/// The kept corpus, tests/fuzz/corpus/TARGET.txt: one input on each line, in which \n, \r, \t, \\ and \z (the zero
/// byte) stand for characters and \xNN for bytes that are not printed. Lines that begin with '#' are comments.

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch::fuzz {

/// Of a file of the kept corpus; none where there is no such file. Aborts where a line is damaged.
std::vector<std::string> kept_inputs(const std::string& path);

}  // namespace shellmatch::fuzz
