#pragma once
/// \file
/// levels.bin of a checkpoint: the deformed reference at the end of each level, for the report of the run that goes on.

#include "matching/result/match_result.h"

#include <span>
#include <string>
#include <vector>

namespace shellmatch {

inline constexpr const char* level_vertices_file_name = "levels.bin";

/// A line of text, then the coordinates of all vertices, level after level, as this machine keeps them in memory: only
/// the program that wrote it goes on from a checkpoint. \pre all levels have as many vertices \throws EnvironmentError
template <int Dim>
void write_level_vertices(std::span<const LevelVertices<Dim>> levels, const std::string& path);

/// The same values, bit for bit. \param n_vertices of each level
/// \throws InputError if the file is missing, has other levels than ascending ones of that many vertices, or values
/// that are no numbers
template <int Dim>
std::vector<LevelVertices<Dim>> read_level_vertices(const std::string& path, std::size_t n_vertices);

}  // namespace shellmatch
