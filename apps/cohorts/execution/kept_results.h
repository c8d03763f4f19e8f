#pragma once
/// \file
/// What a cohort that is stopped between its matchings says.

#include "base/stop.h"

#include <string>

namespace shellmatch {

/// The message of a cohort that is stopped.
inline std::string matchings_are_kept(const std::string& folder) {
  return "stopped; the matchings that have finished are kept in " + folder +
         ", and the same command goes on from there";
}

/// Calls `work`. A parallel loop that is stopped in it says that nothing was written (base/stop.h), which is not so in
/// a cohort's folder. \throws Stopped with what is kept, and whatever else `work` throws
template <class Work>
auto saying_what_is_kept(const std::string& folder, Work&& work) {
  try {
    return work();
  } catch (const Stopped& stopped) {
    throw Stopped(matchings_are_kept(folder), stopped.cause());
  }
}

}  // namespace shellmatch
