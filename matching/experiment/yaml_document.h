#pragma once
/// \file
/// The one door to yaml-cpp: a YAML document that fills an option tree and forgives nothing.

#include "matching/experiment/option_tree.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

/// A value of a YAML document as it stands there, without types.
struct YamlValue {
  enum class Kind { nothing, scalar, list, map };
  Kind kind = Kind::nothing;
  std::string text;     ///< of a scalar
  bool quoted = false;  ///< the scalar stood in quotes
  int line = 0;         ///< counted from 1
  std::vector<YamlValue> items;                            ///< of a list
  std::vector<std::pair<std::string, YamlValue>> entries;  ///< of a map, in their order; no key stands twice

  /// The same value on one line, as parse_value reads it: "0.5", "[1, 2]", "\"5\"".
  std::string flow_text() const;
};

/// A document whose top is a map. Every message begins with its name and the line.
class YamlDocument {
 public:
  /// \throws InputError where the file is missing, unreadable, empty or larger than 1 MB, where its syntax is
  /// wrong, where it holds several documents or where its top is no map
  static YamlDocument from_file(const std::string& path);
  /// The same from a text; `name` stands for the file in messages.
  static YamlDocument from_text(const std::string& text, const std::string& name);

  YamlDocument(YamlDocument&&) noexcept;
  ~YamlDocument();

  /// Sets the one option at the top that is called `key`, if the document has it; looks at nothing else.
  void fill_one(const OptionNode& root, const std::string& key);

  /// Sets every option that the document names. \throws InputError at the first unknown or double key, missing
  /// value, wrong type or value out of range.
  void fill(const OptionNode& root);

  /// The whole document. \throws InputError where a key stands twice or is no word, and at tags
  YamlValue tree() const;

  /// "name:12: path" for an option that the document set, "name: path" for another one.
  std::string place(const std::string& path) const;

 private:
  struct Content;
  explicit YamlDocument(std::unique_ptr<Content> content);
  std::unique_ptr<Content> content_;
};

/// The values that `text` stands for as the value of `option`: a YAML scalar or list; taken to the letter
/// where the option is free text. \throws InputError beginning with `where`
std::vector<OptionScalar> parse_value(const OptionNode& option, const std::string& text, const std::string& where);

}  // namespace shellmatch
