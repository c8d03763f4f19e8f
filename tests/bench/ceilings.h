#pragma once
/// \file
/// What one core of the machine can do at most, measured: the ceilings of the roofline in
/// docs/performance.md.

namespace shellmatch::bench {

/// Registers the benchmarks ceiling_clock, ceiling_fma, ceiling_fma_and_add, ceiling_read and ceiling_triad.
void register_ceilings();

}  // namespace shellmatch::bench
