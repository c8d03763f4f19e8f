#pragma once
/// \file
/// What an alignment has found, in the file of a checkpoint.

#include "matching/alignment/alignment_findings.h"

#include <string>

namespace shellmatch {

inline constexpr const char* alignment_file_name = "alignment.cbor";

/// \throws EnvironmentError if the file cannot be written
template <int Dim>
void write_alignment(const AlignmentFindings<Dim>& findings, const std::string& path);

/// The same to the bit. \throws InputError if the file does not hold findings of this dimension
template <int Dim>
AlignmentFindings<Dim> read_alignment(const std::string& path);

}  // namespace shellmatch
