#include "apps/output_file.h"

#include "apps/terminal/words.h"
#include "base/error.h"
#include "geometry/io/write_shape.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <vector>

namespace shellmatch {

void check_report_file(const std::string& path, bool force) {
  namespace fs = std::filesystem;
  if (fs::is_directory(path)) throw_input_error("{}: is a folder; expected the name of a file", path);
  // A pipe or device is no file that could be replaced as a whole.
  if (fs::exists(path) && !fs::is_regular_file(path))
    throw_input_error("{}: is a pipe or device; expected the name of a file", path);
  // A link that leads nowhere is a name that is taken, too.
  if (fs::exists(fs::symlink_status(path)) && !force)
    throw_input_error("{}: exists already; choose another name or give --force", path);
  const fs::path folder = fs::absolute(path).parent_path();
  if (!fs::is_directory(folder)) throw_input_error("{}: there is no folder {}", path, folder.string());
}

void check_output_file(const std::string& path, int dimension, bool force) {
  namespace fs = std::filesystem;
  const std::vector<std::string> endings =
      dimension == 2 ? std::vector<std::string>{".csv"}
                     : std::vector<std::string>{".ply", ".obj", ".off", ".stl", ".vtk", ".vtp", ".csv"};
  std::string ending = fs::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  if (std::find(endings.begin(), endings.end(), ending) == endings.end())
    throw_input_error("{}: {} written as {}", path, dimension == 2 ? "contours are" : "surfaces are",
                      fmt::join(endings, ", "));
  check_report_file(path, force);
}

static Existing existing_file(bool force) { return force ? Existing::is_replaced : Existing::is_kept; }

void write_output_file(const std::string& path, const OriginalShape<2>& shape, bool force) {
  write_outline_csv(path, shape, existing_file(force));
}

void write_output_file(const std::string& path, const OriginalShape<3>& shape, bool force) {
  write_shape(path, shape, existing_file(force));
}

void say_what_is_left_out(const std::string& path, const OriginalShape<3>& shape) {
  if (const std::vector<std::string> lost = left_out(path, shape); !lost.empty())
    say_line(fmt::format("{}: without {}, which this format does not hold", path, fmt::join(lost, ", ")));
}

void write_report_file(const std::string& path, const std::string& text, bool force) {
  publish_file(path, existing_file(force), text);
}

}  // namespace shellmatch
