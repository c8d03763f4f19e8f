#pragma once
/// \file
/// How much a command says.

namespace shellmatch {

/// How many messages a command writes. Errors are always reported.
enum class Verbosity { quiet, normal, verbose };

}  // namespace shellmatch
