#pragma once
/// \file
/// What every reader of a text format needs: lines with their numbers, words and numbers, and errors that say
/// where they are.

#include "base/error.h"
#include "base/stop.h"
#include "base/text.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// The whole word as a number; "nan", "inf" and a leading plus are understood. Nothing where it is not one.
std::optional<double> to_double(std::string_view word);
/// The whole word as an integer. Nothing where it is not one or does not fit.
std::optional<std::int64_t> to_integer(std::string_view word);

/// Does `text` equal `lower_case_word` but for upper and lower case?
bool equals_ignoring_case(std::string_view text, std::string_view lower_case_word);

/// Cuts the next word off the front of `rest`; empty where there is none.
std::string_view next_word(std::string_view& rest, std::string_view separators = " \t");

/// The fields of a line between commas, without blanks at their ends; a field in quotes may hold commas, and quotes as
/// "".
std::vector<std::string_view> csv_fields(std::string_view line);
/// The text of such a field, without its quotes.
std::string csv_text(std::string_view field);

/// The lines of a text one by one; ends of line may be LF, CR LF or CR. Keeps a view of the text.
class LineReader {
 public:
  /// `comment`: from this character on the rest of a line is ignored, unless it stands in quotes around a field; 0:
  /// nothing is.
  LineReader(std::string path, std::string_view text, char comment = '#');

  /// Goes to the next line that is not blank; false at the end of the text.
  bool next();
  /// Goes to the next line, which may be blank; false at the end of the text.
  bool next_line();
  /// The line without comment and without blanks at both ends.
  std::string_view line() const { return line_; }
  /// True where the line consists of a comment and nothing else.
  bool only_comment() const { return only_comment_; }
  /// Counted from 1.
  std::size_t number() const { return number_; }
  /// Bytes of the text that have not been read.
  std::size_t n_left() const { return text_.size() - position_; }
  /// Everything that has not been read.
  std::string_view rest() const { return text_.substr(position_); }
  const std::string& path() const { return path_; }

  /// Takes the next word of the line as a number. \throws InputError with `what`, where it is none.
  double number_of(std::string_view& rest, std::string_view what) const;
  /// The same for a count or an index.
  std::int64_t integer_of(std::string_view& rest, std::string_view what) const;

  /// Throws InputError: "path, line n: text".
  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> text, Args&&... args) const {
    throw_input_error("{}, line {}: {}", path_, number_, fmt::format(text, std::forward<Args>(args)...));
  }

 private:
  std::string path_;
  std::string_view text_, line_;
  std::size_t position_ = 0, number_ = 0;
  char comment_;
  bool only_comment_ = false;
  StopCheck stop_check_;
};

}  // namespace shellmatch
