#pragma once
/// \file
/// The finest level that any option may ask for.

namespace shellmatch {

/// Its cells have the side 2^-15; about 10^9 of them would meet a surface, which no run gets to.
inline constexpr int finest_level = 15;

}  // namespace shellmatch
