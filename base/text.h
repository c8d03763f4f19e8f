#pragma once
/// \file
/// Wording of messages.

#include <cstddef>
#include <string>
#include <string_view>

namespace shellmatch {

/// "1 vertex", "12 vertices": a count with its noun.
std::string counted(std::size_t n, std::string_view singular, std::string_view plural);

}  // namespace shellmatch
