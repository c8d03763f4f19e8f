#pragma once
/// \file
/// Feeds a target with one input under a limit of memory.

#include "tests/fuzz/target.h"

#include <string>
#include <string_view>

namespace shellmatch::fuzz {

/// Reads a copy of exactly these bytes, so that the address sanitizer sees a step beyond their end. Aborts where the
/// reader breaks a promise, throws anything but an InputError or holds more memory than its limit. Returns why the
/// input was refused; empty where it was read.
std::string run_input(const Target& target, std::string_view bytes);

}  // namespace shellmatch::fuzz
