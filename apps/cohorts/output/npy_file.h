#pragma once
/// \file
/// Arrays in NumPy's format (https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html),
/// version 1.0, little-endian, in C order.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace shellmatch {

/// \param shape whose product is the number of values, the last index the fastest
/// \throws EnvironmentError if the file cannot be written
void write_npy(const std::string& path, const std::vector<std::size_t>& shape, std::span<const double> values);
void write_npy(const std::string& path, const std::vector<std::size_t>& shape, std::span<const std::int32_t> values);

}  // namespace shellmatch
