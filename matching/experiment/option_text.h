#pragma once
/// \file
/// Conversion between options and text: values, descriptions of types, and suggestions for misspelt keys.

#include "matching/experiment/option_tree.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// The value that `text` denotes for this option.
/// \param quoted whether the text was quoted; then it is neither a number, a truth value nor a choice
/// \param where the beginning of messages: "hand.yaml:12: cascade.nu"
/// \throws InputError that says what was expected, what was found and the nearest valid spelling
OptionScalar parse_scalar(const OptionNode& option, std::string_view text, bool quoted, const std::string& where);

/// Text that parse_scalar reads back as exactly the same value: doubles with the fewest digits that do so, free text in
/// double quotes with YAML's escapes.
std::string scalar_text(const OptionScalar& value, OptionKind kind);

/// The present value of the option as such a text: a scalar, or a list in brackets.
std::string value_text(const OptionNode& option);

/// The overrides by level of the options of `section` as such a text: "{3-5: {name: "lbfgs"}}".
std::string level_overrides_text(const OptionNode& section, const LevelOverrides& levels);

/// The type of the option: "integer", "list of real numbers", "neumann | dirichlet".
std::string type_text(const OptionNode& option);

/// The allowed values, for messages: "an integer, 1 <= x <= 12", "one of neumann, dirichlet".
std::string allowed_text(const OptionNode& option);

/// The option at this path, or null.
const OptionNode* find_option(const OptionNode& root, std::string_view path);

/// The option or section at a path relative to `section` that level overrides refer to. \throws InputError, beginning
/// with `where`, if there is none or it is the overrides themselves
const OptionNode* overridable_option(const OptionNode& section, std::string_view path, const std::string& where);

/// A message about a key that `section` does not have: the nearest spelling, the section with a key of that name, and
/// the allowed keys.
std::string unknown_key_text(const OptionNode& root, const OptionNode& section, const std::string& key);

/// All options below `root` as YAML, with their meanings as comments if wanted.
std::string yaml_text(const OptionNode& root, bool with_comments);

/// Those whose values differ from the same options of `defaults`, as YAML indented by 2 `depth`; empty if there are
/// none. \pre both are trees of one struct
std::string changed_yaml_text(const OptionNode& root, const OptionNode& defaults, int depth);

}  // namespace shellmatch
