// 3D Slicer's list of points as text: comments that name the frame and the columns, then one point in a line.

#include "base/error.h"
#include "base/printable.h"
#include "base/stop.h"
#include "geometry/mesh_text/read_text.h"
#include "matching/pairs/slicer_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace shellmatch {

namespace {

// What a comment "# key = value" says; nothing where it is about another key.
std::optional<std::string_view> value_of(std::string_view comment, std::string_view key) {
  comment.remove_prefix(1);
  const std::size_t equals = comment.find('=');
  if (equals == comment.npos) return std::nullopt;
  std::string_view left = comment.substr(0, equals), right = comment.substr(equals + 1);
  left.remove_prefix(std::min(left.find_first_not_of(" \t"), left.size()));
  if (left.substr(0, left.find_last_not_of(" \t") + 1) != key) return std::nullopt;
  right.remove_prefix(std::min(right.find_first_not_of(" \t"), right.size()));
  return right.substr(0, right.find_last_not_of(" \t") + 1);
}

// Slicer before 4.11 wrote numbers.
Space fcsv_space(const LineReader& lines, std::string_view name) {
  if (name == "RAS" || name == "0") return Space::ras;
  if (name == "LPS" || name == "1") return Space::lps;
  lines.fail("the coordinate system is '{}'; expected RAS or LPS (0 or 1 in old files)", printable(name));
}

constexpr std::array<std::string_view, 3> fcsv_axes = {"x", "y", "z"};

struct FcsvColumns {
  std::array<std::size_t, 3> axes = {1, 2, 3};
  std::size_t label = 11, status = 14;  // Slicer 5 writes the latter and does not list it
};

FcsvColumns fcsv_columns(const LineReader& lines, std::string_view list) {
  const std::vector<std::string_view> names = csv_fields(list);
  const auto column = [&](std::string_view name) {
    const auto at = std::ranges::find(names, name);
    if (at == names.end())
      lines.fail("the columns have no '{}'; expected a list such as id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc",
                 name);
    return static_cast<std::size_t>(at - names.begin());
  };
  FcsvColumns columns;
  if (const auto at = std::ranges::find(names, "positionStatus"); at != names.end())
    columns.status = static_cast<std::size_t>(at - names.begin());
  // A list of other columns than Slicer's says what there is.
  else if (names.size() < columns.status || names[columns.status - 1] != "associatedNodeID")
    columns.status = std::string_view::npos;
  for (std::size_t k = 0; k < 3; ++k) columns.axes[k] = column(fcsv_axes[k]);
  columns.label = column("label");
  return columns;
}

// Of a file that names none: Slicer before 4.11 wrote RAS without saying so, and takes files that name no version for
// those of Slicer 3.
Space space_of_version(std::string_view version) {
  const std::size_t dot = version.find('.');
  const auto major = to_integer(version.substr(0, dot));
  const auto minor =
      dot == version.npos
          ? std::nullopt
          : to_integer(version.substr(dot + 1, version.find_first_not_of("0123456789", dot + 1) - dot - 1));
  return major && (*major > 4 || (*major == 4 && minor && *minor >= 11)) ? Space::lps : Space::ras;
}

// 0 undefined, 1 a preview while it is being placed, 2 defined, 3 missing.
bool is_placed(const LineReader& lines, const std::vector<std::string_view>& fields, const FcsvColumns& columns) {
  if (columns.status >= fields.size() || fields[columns.status].empty()) return true;
  const std::string_view status = fields[columns.status];
  if (status.size() != 1 || status[0] < '0' || status[0] > '3')
    lines.fail("the status of the position is '{}'; expected 0 (undefined), 1 (preview), 2 (defined) or 3 (missing)",
               printable(status));
  return status == "2";
}

/// Calls point(lines, fields, columns, space) for each point.
void for_each_fcsv_point(const std::string& path, const std::string& text,
                         const std::function<void(const LineReader&, const std::vector<std::string_view>&,
                                                  const FcsvColumns&, Space)>& point) {
  LineReader lines(path, text, '\0');
  FcsvColumns columns;
  Space space = Space::ras;
  bool says_space = false;
  while (lines.next()) {
    if (lines.number() % 1024 == 0) stop_if_wanted();
    if (lines.line().starts_with('#')) {
      if (const auto version = value_of(lines.line(), "Markups fiducial file version"); version && !says_space)
        space = space_of_version(*version);
      if (const auto name = value_of(lines.line(), "CoordinateSystem")) {
        space = fcsv_space(lines, *name);
        says_space = true;
      }
      if (const auto list = value_of(lines.line(), "columns")) columns = fcsv_columns(lines, *list);
      continue;
    }
    const std::vector<std::string_view> fields = csv_fields(lines.line());
    const std::size_t last = std::max(columns.label, *std::ranges::max_element(columns.axes));
    if (fields.size() <= last) lines.fail("{} values where the columns want {}", fields.size(), last + 1);
    point(lines, fields, columns, space);
  }
}

}  // namespace

std::vector<SlicerPoint> parse_fcsv(const std::string& path, const std::string& text) {
  std::vector<SlicerPoint> points;
  for_each_fcsv_point(
      path, text, [&](const LineReader& lines, const auto& fields, const FcsvColumns& columns, Space space) {
        SlicerPoint point{csv_text(fields[columns.label]), Vec<3>::Zero(), space, is_placed(lines, fields, columns),
                          fmt::format("{}, line {}", path, lines.number())};
        for (std::size_t k = 0; k < 3 && point.has_position; ++k) {
          const auto value = to_double(fields[columns.axes[k]]);
          if (!value || !std::isfinite(*value))
            lines.fail("{} is '{}'; expected a number", fcsv_axes[k], printable(fields[columns.axes[k]]));
          point.position[static_cast<int>(k)] = *value;
        }
        points.push_back(std::move(point));
      });
  return points;
}

std::string fcsv_with_positions(const SlicerPoints& file, const std::vector<Vec<3>>& positions) {
  struct Change {
    std::size_t begin, length;
    double value;
  };
  std::vector<Change> changes;
  std::size_t i = 0;
  for_each_fcsv_point(file.path, file.text,
                      [&](const LineReader& lines, const auto& fields, const FcsvColumns& columns, Space) {
                        for (std::size_t k = 0; k < 3 && is_placed(lines, fields, columns); ++k) {
                          const std::string_view field = fields[columns.axes[k]];
                          changes.push_back({static_cast<std::size_t>(field.data() - file.text.data()), field.size(),
                                             positions[i][static_cast<int>(k)]});
                        }
                        ++i;
                      });
  std::ranges::sort(changes, {}, &Change::begin);
  std::string text;
  std::size_t taken = 0;
  for (const Change& change : changes) {
    text.append(file.text, taken, change.begin - taken).append(fmt::format("{}", change.value));
    taken = change.begin + change.length;
  }
  return text.append(file.text, taken);
}

}  // namespace shellmatch
