#include "geometry/outline/tps_file.h"

#include "base/error.h"
#include "base/printable.h"
#include "geometry/mesh_text/read_text.h"
#include "geometry/outline/drawing.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

namespace shellmatch {

namespace {

class TpsReader {
 public:
  TpsReader(const std::string& path, std::string_view bytes) : lines_(path, bytes, '\0') {
    // Lines that belong to a key which is not read: of RADII= for instance.
    bool is_skipping = false;
    while (lines_.next()) {
      const std::size_t equals = lines_.line().find('=');
      if (equals == std::string_view::npos) {
        if (is_skipping) continue;
        if (specimens_.empty()) lines_.fail("no TPS file: expected LM=, OUTLINES= or another word with '='");
        lines_.fail("a line of numbers that no LM= or POINTS= announces: is a count too small?");
      }
      is_skipping = !read_key(lines_.line().substr(0, equals), lines_.line().substr(equals + 1));
    }
    if (specimens_.empty()) throw_input_error("{}: no specimen in it; expected LM=, CURVES= or OUTLINES=", path);
    check_number_of_curves();
  }

  std::vector<TpsSpecimen> take() { return std::move(specimens_); }

 private:
  bool read_key(std::string_view key, std::string_view value) {
    const auto is = [&](std::string_view name) { return equals_ignoring_case(key, name); };
    if (is("lm") || is("lm3")) {
      begin_specimen();
      read_landmarks(is("lm") ? 2 : 3, count(value, key));
    } else if (is("curves") || is("outlines")) {
      bool& is_there = is("curves") ? has_curves_ : has_outlines_;
      begin_unless(!is_there);
      is_there = true;
      check_number_of_curves();
      n_announced_ += count(value, key);
      is_closed_ = is("outlines");
    } else if (is("points")) {
      read_curve(count(value, key));
    } else if (is("image")) {
      begin_unless(!current().image);
      current().image = value;
    } else if (is("id")) {
      begin_unless(!current().id);
      current().id = value;
    } else if (is("scale")) {
      begin_unless(!current().scale);
      const std::optional<double> scale = to_double(value);
      if (!scale || !std::isfinite(*scale) || !(*scale > 0))
        lines_.fail("SCALE is '{}'; expected a number above 0", printable(value, 30));
      current().scale = scale;
    } else if (is("comment")) {
      if (const Space space = space_in_comment(value); space != Space::unsaid) current().space = space;
    } else {
      current();
      return false;
    }
    return true;
  }

  TpsSpecimen& current() {
    if (specimens_.empty()) specimens_.emplace_back();
    return specimens_.back();
  }
  void begin_specimen() {
    if (!specimens_.empty()) check_number_of_curves();
    specimens_.emplace_back();
    n_announced_ = 0;
    has_curves_ = has_outlines_ = false;
  }
  // A word that the specimen has already begins another one, which has no landmarks.
  void begin_unless(bool is_first) {
    if (!is_first) begin_specimen();
  }
  void check_number_of_curves() {
    if (const std::size_t n = current().curves.size(); n < n_announced_)
      lines_.fail("{} of {} announced curves are there: the file is cut off or a count is wrong", n, n_announced_);
  }

  std::size_t count(std::string_view value, std::string_view key) const {
    const std::optional<std::int64_t> n = to_integer(value);
    if (!n || *n < 0) lines_.fail("{} is '{}'; expected how many there are", printable(key, 30), printable(value, 30));
    return static_cast<std::size_t>(*n);
  }

  // The numbers of the next line; nothing where they are all missing.
  std::optional<Vec<3>> next_point(int dimension, std::size_t i, std::size_t n, std::string_view what) {
    if (!lines_.next() || lines_.line().find('=') != std::string_view::npos)
      lines_.fail("{} {} of {} is missing: the file is cut off or the count is wrong", what, i + 1, n);
    std::string_view rest = lines_.line();
    Vec<3> x = Vec<3>::Zero();
    int n_missing = 0;
    for (int k = 0; k < dimension; ++k) {
      const std::string_view word = next_word(rest, " \t");
      if (equals_ignoring_case(word, "na") || equals_ignoring_case(word, "nan")) {
        ++n_missing;
        continue;
      }
      const std::optional<double> value = to_double(word);
      if (!value || !std::isfinite(*value))
        lines_.fail("'{}' is no number; {} has {} with '.' as the decimal sign", printable(word, 30), what, dimension);
      x[k] = *value;
    }
    if (!next_word(rest, " \t").empty()) lines_.fail("more numbers than the {} of a {}", dimension, what);
    if (n_missing > 0 && n_missing < dimension) lines_.fail("one coordinate is missing and another is not");
    return n_missing > 0 ? std::nullopt : std::optional(x);
  }

  void read_landmarks(int dimension, std::size_t n) {
    current().dimension = dimension;
    for (std::size_t i = 0; i < n; ++i) current().landmarks.push_back(next_point(dimension, i, n, "landmark"));
  }

  void read_curve(std::size_t n) {
    if (current().curves.size() >= n_announced_) lines_.fail("POINTS= that neither CURVES= nor OUTLINES= announces");
    TpsCurve curve{{}, is_closed_};
    for (std::size_t i = 0; i < n; ++i) {
      const std::optional<Vec<3>> x = next_point(2, i, n, "point");
      if (!x) lines_.fail("a point of a curve is missing");
      curve.points.push_back(x->head<2>());
    }
    current().curves.push_back(std::move(curve));
  }

  LineReader lines_;
  std::vector<TpsSpecimen> specimens_;
  std::size_t n_announced_ = 0;  // curves of the specimen
  bool is_closed_ = false, has_curves_ = false, has_outlines_ = false;
};

std::string stem(const std::string& image) {
  const std::size_t slash = image.find_last_of("/\\");
  return std::filesystem::path(slash == image.npos ? image : image.substr(slash + 1)).stem().string();
}

}  // namespace

std::vector<TpsSpecimen> parse_tps(const std::string& path, std::string_view bytes) {
  return TpsReader(path, bytes).take();
}

const TpsSpecimen& chosen_specimen(const std::vector<TpsSpecimen>& specimens, const std::string& path,
                                   const std::string& part) {
  std::vector<std::string> names;
  for (const TpsSpecimen& s : specimens)
    if (s.id || s.image) names.push_back(s.id ? *s.id : stem(*s.image));
  if (part.empty()) {
    if (specimens.size() == 1) return specimens.front();
    throw_input_error("{}: {} specimens in it; {}", path, specimens.size(),
                      names.empty() ? "give each an ID=, by which one can be chosen"
                                    : fmt::format("choose one by its ID, as in \"{}:{}\": {}", path,
                                                  printable(names.front(), 60), some_names(names)));
  }
  const auto only = [&](auto is_it) -> const TpsSpecimen* {
    const auto found = std::ranges::find_if(specimens, is_it);
    if (found == specimens.end()) return nullptr;
    if (std::find_if(found + 1, specimens.end(), is_it) != specimens.end())
      throw_input_error("{}: several specimens are named '{}'; give each an ID= of its own", path, printable(part, 60));
    return &*found;
  };
  if (const TpsSpecimen* s = only([&](const TpsSpecimen& specimen) { return specimen.id == part; })) return *s;
  if (const TpsSpecimen* s = only([&](const TpsSpecimen& specimen) {
        return specimen.image && (*specimen.image == part || stem(*specimen.image) == part);
      }))
    return *s;
  throw_input_error("{}: no specimen has the ID '{}'; {}", path, printable(part, 60),
                    names.empty() ? "none has one" : "there are " + some_names(names));
}

std::string scale_note(const std::vector<TpsSpecimen>& specimens, const TpsSpecimen& chosen) {
  if (chosen.scale) return *chosen.scale == 1 ? "" : fmt::format("coordinates multiplied by SCALE={:g}", *chosen.scale);
  const bool others_have = std::ranges::any_of(specimens, [](const TpsSpecimen& s) { return s.scale.has_value(); });
  return others_have ? "no SCALE= where other specimens have one: its coordinates are pixels" : "";
}

template <int Dim>
std::vector<std::optional<Vec<Dim>>> scaled_landmarks(const TpsSpecimen& specimen, const std::string& path) {
  if (specimen.landmarks.empty()) throw_input_error("{}: no landmarks in it: LM= or LM3= is missing or 0", path);
  if (specimen.dimension != Dim)
    throw_input_error("{}: {}= holds points of {}, but the shapes are of {}", path,
                      specimen.dimension == 2 ? "LM" : "LM3", specimen.dimension == 2 ? "the plane" : "space",
                      Dim == 2 ? "the plane" : "space");
  std::vector<std::optional<Vec<Dim>>> points;
  for (const std::optional<Vec<3>>& x : specimen.landmarks) {
    points.push_back(x ? std::optional<Vec<Dim>>(specimen.factor() * x->head<Dim>()) : std::nullopt);
    if (x && !points.back()->allFinite())
      throw_input_error("{}: landmark {} is too large for its SCALE=", path, points.size());
  }
  return points;
}

SHELLMATCH_2D_3D(scaled_landmarks);

void append_tps_specimen(std::string& text, std::string_view name, std::span<const double> coordinates,
                         std::size_t dimension, Space space) {
  SHELLMATCH_CHECK((dimension == 2 || dimension == 3) && coordinates.size() % dimension == 0,
                   "points have 2 or 3 coordinates each");
  fmt::format_to(std::back_inserter(text), "LM{}={}\n", dimension == 3 ? "3" : "", coordinates.size() / dimension);
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (std::isnan(coordinates[i])) text += "NA";
    else fmt::format_to(std::back_inserter(text), "{}", coordinates[i]);
    text += (i + 1) % dimension == 0 ? '\n' : ' ';
  }
  // The format has no quotes.
  std::string line(name);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  fmt::format_to(std::back_inserter(text), "ID={}\n", line);
  if (space != Space::unsaid) fmt::format_to(std::back_inserter(text), "COMMENT=SPACE={}\n", space_name(space));
}

}  // namespace shellmatch
