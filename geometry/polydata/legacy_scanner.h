#pragma once
/// \file
/// Words, counts and values of a file in VTK's legacy format, with the place of what is wrong.

#include "base/error.h"
#include "geometry/bytes/value_type.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

class LegacyScanner {
 public:
  LegacyScanner(const std::string& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

  void set_binary(bool is_binary) { is_binary_ = is_binary; }
  bool is_binary() const { return is_binary_; }
  /// The next line, without blanks at its ends.
  std::string_view line();
  /// The next word; empty at the end of the file.
  std::string_view word();
  /// The next word as the name of an array, in which VTK writes blanks and the like as %20.
  std::string name();
  /// Takes the next word only where it is this one, in letters of either case.
  bool take(std::string_view lower_case_word);
  /// A count, which the rest of the file limits. \throws InputError
  std::size_t count(std::string_view what);
  ValueType type();
  /// n numbers of the type, as text or, from the next line on, big-endian. \throws InputError where the file is too
  /// short
  std::vector<double> values(ValueType type, std::size_t n, std::string_view what);
  /// Passes over n strings.
  void skip_strings(std::size_t n);

  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> text, Args&&... args) const {
    throw_input_error("{}, {}: {}", path_, place(), fmt::format(text, std::forward<Args>(args)...));
  }

 private:
  std::string place() const;  // "line 12"
  void end_line();            // of the words before binary values
  std::string_view left() const { return bytes_.substr(position_); }

  const std::string& path_;
  std::string_view bytes_;
  std::size_t position_ = 0;
  bool is_binary_ = false;
};

}  // namespace shellmatch
