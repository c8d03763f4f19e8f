#pragma once
/// \file
/// A described option struct (base/options.h) as a tree of named values of run-time type. Reading, writing, documenting
/// and overriding are ordinary functions on the tree, compiled once.

#include "matching/experiment/level_overrides.h"
#include "base/options.h"

#include <functional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace shellmatch {

enum class OptionKind { section, boolean, integer, real, text, choice, level_overrides };

/// One value; for an enumeration the name of the enumerator.
using OptionScalar = LevelOverrides::Value;

/// One option or section, bound to a member of an option struct.
struct OptionNode {
  std::string name;  ///< "nu"; "" at the root
  std::string path;  ///< "cascade.nu"
  OptionInfo info;
  OptionKind kind = OptionKind::section;
  bool is_list = false;
  std::vector<std::string> choices;  ///< names of the enumerators, in their order
  std::vector<OptionNode> children;  ///< options and subsections of a section

  /// The member itself where the kind is level_overrides; its paths are relative to the section that holds the option.
  LevelOverrides* level_overrides = nullptr;

  /// The present value; a scalar option gives a list of one. Not set for sections and level overrides.
  std::function<std::vector<OptionScalar>()> get;
  /// Sets the value. \pre every scalar has the node's type and lies in its range
  std::function<void(const std::vector<OptionScalar>&)> set;
};

namespace detail {

template <class T>
concept DescribedEnum = std::is_enum_v<T> && requires {
  EnumNames<T>::names;
};

template <class T>
constexpr OptionKind scalar_kind() {
  if constexpr (std::is_same_v<T, bool>) return OptionKind::boolean;
  else if constexpr (std::is_same_v<T, int>) return OptionKind::integer;
  else if constexpr (std::is_same_v<T, double>) return OptionKind::real;
  else if constexpr (std::is_same_v<T, std::string>) return OptionKind::text;
  else if constexpr (DescribedEnum<T>) return OptionKind::choice;
  else return OptionKind::section;
}

template <class T>
OptionScalar to_scalar(const T& value) {
  if constexpr (DescribedEnum<T>) return std::string(enum_name(value));
  else return value;
}

template <class T>
T from_scalar(const OptionScalar& scalar) {
  if constexpr (DescribedEnum<T>) {
    for (const auto& [value, name] : EnumNames<T>::names)
      if (name == std::get<std::string>(scalar)) return value;
    return {};
  } else {
    return std::get<T>(scalar);
  }
}

template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {
  using Element = T;
};

template <class T>
void set_kind(OptionNode& node) {
  node.kind = scalar_kind<T>();
  static_assert(scalar_kind<T>() != OptionKind::section,
                "options are bool, int, double, string, enum or vectors of them");
  if constexpr (DescribedEnum<T>)
    for (const auto& [value, name] : EnumNames<T>::names) node.choices.emplace_back(name);
}

/// Visitor that adds one node below `parent` for every member.
struct TreeBuilder {
  OptionNode& parent;

  template <class T>
  void operator()(std::string_view name, T& member, OptionInfo info) {
    OptionNode node;
    node.name = name;
    node.path = parent.path.empty() ? node.name : parent.path + "." + node.name;
    node.info = info;
    if constexpr (std::is_same_v<T, LevelOverrides>) {
      node.kind = OptionKind::level_overrides;
      node.level_overrides = &member;
    } else if constexpr (std::is_same_v<T, Choice>) {
      node.kind = OptionKind::choice;
      node.choices.assign(member.names().begin(), member.names().end());
      node.get = [&member] { return std::vector<OptionScalar>{std::string(member.name())}; };
      node.set = [&member](const std::vector<OptionScalar>& values) { member = std::get<std::string>(values.front()); };
    } else if constexpr (IsVector<T>::value) {
      using Element = typename IsVector<T>::Element;
      set_kind<Element>(node);
      node.is_list = true;
      node.get = [&member] {
        std::vector<OptionScalar> values;
        for (const Element& value : member) values.push_back(to_scalar<Element>(value));
        return values;
      };
      node.set = [&member](const std::vector<OptionScalar>& values) {
        member.clear();
        for (const OptionScalar& value : values) member.push_back(from_scalar<Element>(value));
      };
    } else if constexpr (scalar_kind<T>() == OptionKind::section) {
      TreeBuilder builder{node};
      T::describe(member, builder);
    } else {
      set_kind<T>(node);
      node.get = [&member] { return std::vector<OptionScalar>{to_scalar(member)}; };
      node.set = [&member](const std::vector<OptionScalar>& values) { member = from_scalar<T>(values.front()); };
    }
    parent.children.push_back(std::move(node));
  }
};

}  // namespace detail

/// The tree of `options`. It refers to the members of `options`, which must outlive it and must not be moved.
template <class Options>
OptionNode option_tree(Options& options) {
  OptionNode root;
  detail::TreeBuilder builder{root};
  Options::describe(options, builder);
  return root;
}

}  // namespace shellmatch
