#pragma once
/// \file
/// Options and text: single values, their types in words, and the misspelt key's nearest kin.

#include "matching/experiment/option_tree.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shellmatch {

/// The value that `text` stands for.
/// \param quoted the text stood in quotes, so that it is neither number nor truth value nor choice
/// \param where  what messages begin with: "hand.yaml:12: cascade.nu"
/// \throws InputError saying what was expected, what was found and the nearest valid spelling
OptionScalar parse_scalar(const OptionNode& option, std::string_view text, bool quoted, const std::string& where);

/// Text that parse_scalar reads back as exactly the same value: doubles with the fewest digits that do,
/// free text in double quotes with YAML's escapes.
std::string scalar_text(const OptionScalar& value, OptionKind kind);

/// The same for the option's present value: a scalar, or a list in brackets.
std::string value_text(const OptionNode& option);

/// The same for overrides of the options of `section` by level: "{3-5: {name: "lbfgs"}}".
std::string level_overrides_text(const OptionNode& section, const LevelOverrides& levels);

/// "integer", "list of real numbers", "neumann | dirichlet".
std::string type_text(const OptionNode& option);

/// "an integer, 1 <= x <= 12", "one of neumann, dirichlet": what messages say is allowed.
std::string allowed_text(const OptionNode& option);

/// The option of that path, or null.
const OptionNode* find_option(const OptionNode& root, std::string_view path);

/// The option or section of `section` that level overrides name by a path relative to it. \throws InputError, beginning
/// with `where`, if there is none or it is the overrides themselves
const OptionNode* overridable_option(const OptionNode& section, std::string_view path, const std::string& where);

/// What to say of a key that `section` does not have: the nearest spelling, the section where a key of that
/// name is, and the keys that are allowed.
std::string unknown_key_text(const OptionNode& root, const OptionNode& section, const std::string& key);

}  // namespace shellmatch
