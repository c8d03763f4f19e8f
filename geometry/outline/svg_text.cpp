#include "geometry/outline/svg_text.h"

#include "base/error.h"
#include "base/printable.h"
#include "geometry/mesh_text/read_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace shellmatch {

namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace

void SvgNumbers::fail(std::string_view expected) const {
  throw_input_error("{}: at byte {} of '{}' expected {}; correct it or save the drawing again", source_.place,
                    source_.text.size() - rest_.size() + 1, printable(source_.text, 60), expected);
}

void SvgNumbers::drop(std::size_t n) {
  rest_.remove_prefix(n);
  skip();
}

// Blanks and one comma.
void SvgNumbers::skip() {
  bool had_comma = false;
  while (!rest_.empty() && (is_blank(rest_.front()) || (rest_.front() == ',' && !had_comma))) {
    had_comma = had_comma || rest_.front() == ',';
    rest_.remove_prefix(1);
  }
}

std::size_t SvgNumbers::number_length() const {
  std::size_t i = 0;
  const auto digits = [&] {
    const std::size_t from = i;
    while (i < rest_.size() && is_digit(rest_[i])) ++i;
    return i - from;
  };
  const auto sign = [&] { i += i < rest_.size() && (rest_[i] == '+' || rest_[i] == '-'); };
  sign();
  std::size_t n = digits();
  if (i < rest_.size() && rest_[i] == '.') ++i, n += digits();
  if (n == 0) return 0;
  if (i < rest_.size() && (rest_[i] == 'e' || rest_[i] == 'E')) {
    const std::size_t before = i++;
    sign();
    if (digits() == 0) i = before;
  }
  return i;
}

bool SvgNumbers::has_number() const { return number_length() > 0; }

double SvgNumbers::next() {
  const std::size_t n = number_length();
  const std::optional<double> value = to_double(rest_.substr(0, n));
  if (!value) fail("a number");
  drop(n);
  return *value;
}

Vec<2> SvgNumbers::next_point() {
  const double x = next();
  return {x, next()};
}

bool SvgNumbers::next_flag() {
  const char c = peek();
  if (c != '0' && c != '1') fail("0 or 1");
  drop(1);
  return c == '1';
}

SvgLength svg_length(const SvgText& text, double whole) {
  SvgNumbers numbers(text);
  const double value = numbers.next();
  std::string_view unit = numbers.rest();
  while (!unit.empty() && is_blank(unit.back())) unit.remove_suffix(1);
  if (unit.empty() || unit == "px") return {value};
  if (unit == "%") return {value / 100 * whole};
  for (const auto& [name, length] : {std::pair<std::string_view, double>{"mm", 1},
                                     {"cm", 10},
                                     {"in", 25.4},
                                     {"pt", 25.4 / 72},
                                     {"pc", 25.4 / 6},
                                     {"Q", 0.25}})
    if (unit == name) return {value * length / millimetres_per_user_unit, value * length};
  throw_input_error("{}: the unit '{}' of '{}' cannot be used; expected px, mm, cm, in, pt, pc, Q or %", text.place,
                    printable(unit, 20), printable(text.text, 30));
}

PlaneMap svg_transform(const SvgText& text) {
  PlaneMap map;
  for (SvgNumbers numbers(text); !numbers.at_end();) {
    std::size_t n = 0;
    while (n < numbers.rest().size() && is_letter(numbers.rest()[n])) ++n;
    const std::string_view name = numbers.rest().substr(0, n);
    numbers.drop(n);
    if (numbers.peek() != '(') numbers.fail("a transformation such as translate(1, 2)");
    numbers.drop(1);
    std::vector<double> v;
    while (numbers.has_number() && v.size() < 7) v.push_back(numbers.next());
    if (numbers.peek() != ')') numbers.fail("a number or ')'");
    numbers.drop(1);
    const double angle = v.empty() ? 0 : v[0] * std::numbers::pi / 180;
    PlaneMap step;
    if (name == "matrix" && v.size() == 6) {
      step.linear << v[0], v[2], v[1], v[3];
      step.offset << v[4], v[5];
    } else if (name == "translate" && (v.size() == 1 || v.size() == 2)) {
      step.offset << v[0], v.size() == 2 ? v[1] : 0;
    } else if (name == "scale" && (v.size() == 1 || v.size() == 2)) {
      step.linear << v[0], 0, 0, v.back();
    } else if (name == "rotate" && (v.size() == 1 || v.size() == 3)) {
      step.linear << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
      if (v.size() == 3) step.offset = Vec<2>(v[1], v[2]) - step.linear * Vec<2>(v[1], v[2]);
    } else if (name == "skewX" && v.size() == 1) {
      step.linear(0, 1) = std::tan(angle);
    } else if (name == "skewY" && v.size() == 1) {
      step.linear(1, 0) = std::tan(angle);
    } else {
      throw_input_error("{}: the transformation '{}' with {} numbers is unknown", text.place, printable(name, 30),
                        v.size());
    }
    map = map * step;
  }
  return map;
}

std::vector<Vec<2>> svg_points(const SvgText& text) {
  std::vector<Vec<2>> points;
  for (SvgNumbers numbers(text); !numbers.at_end();) points.push_back(numbers.next_point());
  return points;
}

std::vector<DrawnPath> svg_paths(const SvgText& text) {
  PathPen pen;
  char command = '\0', before = '\0';
  Vec<2> control = Vec<2>::Zero();  // the last one of a curve
  for (SvgNumbers numbers(text); !numbers.at_end(); before = command) {
    if (is_letter(numbers.peek())) {
      command = numbers.peek();
      if (before == '\0' && command != 'M' && command != 'm') numbers.fail("'M' or 'm', with which a path begins");
      numbers.drop(1);
    } else if (command == '\0' || command == 'Z' || command == 'z') {
      numbers.fail("a letter such as M, L or Z");
    } else if (command == 'M' || command == 'm') {
      command = command == 'M' ? 'L' : 'l';  // further points of a move are lines
    }
    const Vec<2> from = pen.position(), base = command >= 'a' ? from : Vec<2>(Vec<2>::Zero());
    const char kind = command >= 'a' ? static_cast<char>(command - 'a' + 'A') : command,
               last = before >= 'a' ? static_cast<char>(before - 'a' + 'A') : before;
    const auto point = [&]() -> Vec<2> { return base + numbers.next_point(); };
    const auto reflected = [&](char a, char b) -> Vec<2> {
      return last == a || last == b ? Vec<2>(2 * from - control) : from;
    };
    switch (kind) {
      case 'M': pen.move_to(point()); break;
      case 'L': pen.line_to(point()); break;
      case 'H': pen.line_to({base.x() + numbers.next(), from.y()}); break;
      case 'V': pen.line_to({from.x(), base.y() + numbers.next()}); break;
      case 'C':
      case 'S': {
        const Vec<2> first = kind == 'C' ? point() : reflected('C', 'S');
        control = point();
        pen.cubic_to(first, control, point());
        break;
      }
      case 'Q':
      case 'T':
        control = kind == 'Q' ? point() : reflected('Q', 'T');
        pen.quadratic_to(control, point());
        break;
      case 'A': {
        const Vec<2> radii = numbers.next_point();
        const double degrees = numbers.next();
        const bool is_large = numbers.next_flag(), is_positive = numbers.next_flag();
        pen.arc_to(radii, degrees, is_large, is_positive, point());
        break;
      }
      case 'Z': pen.close(); break;
      default: numbers.fail("after it one of M, L, H, V, C, S, Q, T, A and Z");
    }
  }
  return pen.take();
}

}  // namespace shellmatch
