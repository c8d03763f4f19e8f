#pragma once
/// \file
/// The adapter of yaml-cpp: a YAML document that sets the options of a tree and refuses everything unknown.

#include "matching/experiment/option_tree.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace shellmatch {

/// A value of a YAML document without type.
struct YamlValue {
  // Defined where the type is complete, which clang asks for in a type that holds pairs of itself.
  YamlValue();
  YamlValue(const YamlValue&);
  YamlValue(YamlValue&&) noexcept;
  YamlValue& operator=(const YamlValue&);
  YamlValue& operator=(YamlValue&&) noexcept;
  ~YamlValue();

  enum class Kind { nothing, scalar, list, map };
  Kind kind = Kind::nothing;
  std::string text;                                        ///< text of a scalar
  bool quoted = false;                                     ///< whether the scalar was quoted
  int line = 0;                                            ///< counted from 1
  std::vector<YamlValue> items;                            ///< items of a list
  std::vector<std::pair<std::string, YamlValue>> entries;  ///< entries of a map in their order, with distinct keys

  /// The value on one line, as parse_value reads it: "0.5", "[1, 2]", "\"5\"".
  std::string flow_text() const;
};

/// A document that is a map at the top. Every message begins with the document's name and the line.
class YamlDocument {
 public:
  /// \throws InputError where the file is missing, unreadable, empty or larger than 1 MB, has wrong syntax, holds
  /// several documents or is no map at the top
  static YamlDocument from_file(const std::string& path);
  /// A document from a text; messages name it `name`.
  static YamlDocument from_text(const std::string& text, const std::string& name);

  YamlDocument(YamlDocument&&) noexcept;
  ~YamlDocument();

  /// Sets the one top-level option `key` if the document has it, and checks nothing else.
  void fill_one(const OptionNode& root, const std::string& key);

  /// Sets every option that the document has. \throws InputError for unknown or repeated keys, missing values, wrong
  /// types and values out of range: a line for each, up to ten
  void fill(const OptionNode& root);

  /// The whole document. \throws InputError for repeated keys, keys that are no scalars, and tags
  YamlValue tree() const;

  /// The position of an option, for messages: "name:12: path" if the document set it, else "name: path".
  std::string place(const std::string& path) const;

 private:
  struct Content;
  explicit YamlDocument(std::unique_ptr<Content> content);
  std::unique_ptr<Content> content_;
};

/// The values that `text` denotes for `option`: a YAML scalar or list, or the text itself for an option of free text.
/// \throws InputError beginning with `where`
std::vector<OptionScalar> parse_value(const OptionNode& option, const std::string& text, const std::string& where);

}  // namespace shellmatch
