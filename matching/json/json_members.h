#pragma once
/// \file
/// Conversion between structs and JSON objects. One description of a struct serves both directions: SHELLMATCH_JSON in
/// the source that needs it, which lists the members, or a function template describe(s, member), which calls
/// member(key, s.value) for each. For the sources that write JSON; it exposes types of the JSON library. Types that are
/// many numbers may have packed(value), a list of them, and unpack(numbers, value) instead.

#include "matching/json/json_text.h"

#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace shellmatch {

namespace json_detail {

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_same_v<T, std::string>;
using NamedNumbers = std::vector<std::pair<std::string, double>>;

}  // namespace json_detail

/// Converts to JSON. Optional members without a value are omitted; a list of named numbers becomes an object.
template <class T>
Json json_of(const T& value) {
  if constexpr (requires { packed(value); }) {
    return packed(value);
  } else if constexpr (json_detail::Plain<T>) {
    return value;  // the library writes numbers that are not finite as null
  } else if constexpr (std::is_same_v<T, json_detail::NamedNumbers>) {
    Json object = Json::object();
    for (const auto& [name, number] : value) object[name] = number;
    return object;
  } else if constexpr (json_detail::IsVector<T>::value) {
    Json array = Json::array();
    for (const auto& entry : value) array.push_back(json_of(entry));
    return array;
  } else {
    Json object = Json::object();
    describe(value, [&object]<class M>(const char* key, const M& member) {
      if constexpr (json_detail::IsOptional<M>::value) {
        if (member) object[key] = json_of(*member);
      } else {
        object[key] = json_of(member);
      }
    });
    return object;
  }
}

/// Sets a value from JSON; null becomes NaN. \throws Json::exception for a missing key, a value of another type or an
/// integer that is out of its type's range
template <class T>
void set_from_json(const Json& json, T& value) {
  if constexpr (requires(std::vector<double> numbers) { unpack(numbers, value); }) {
    unpack(json.get<std::vector<double>>(), value);
  } else if constexpr (std::is_same_v<T, double>) {
    value = json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
  } else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
    // The library would cast any number, also one that no integer of the type can have.
    const bool fits = json.is_number_unsigned()
                          ? std::in_range<T>(json.get<std::uint64_t>())
                          : json.is_number_integer() && std::in_range<T>(json.get<std::int64_t>());
    if (!fits) throw Json::out_of_range::create(406, "an integer is missing or out of range", &json);
    value = json.get<T>();
  } else if constexpr (json_detail::Plain<T>) {
    value = json.get<T>();
  } else if constexpr (std::is_same_v<T, json_detail::NamedNumbers>) {
    value.clear();
    for (const auto& [name, number] : json.items()) set_from_json(number, value.emplace_back(name, 0.0).second);
  } else if constexpr (json_detail::IsVector<T>::value) {
    if (!json.is_array()) throw Json::type_error::create(302, "a list is missing", &json);
    value.clear();
    for (const Json& entry : json) {
      typename T::value_type item{};
      set_from_json(entry, item);
      value.push_back(std::move(item));
    }
  } else {
    describe(value, [&json]<class M>(const char* key, M& member) {
      if constexpr (json_detail::IsOptional<M>::value) {
        if (json.contains(key)) set_from_json(json.at(key), member.emplace());
      } else {
        set_from_json(json.at(key), member);
      }
    });
  }
}

/// What a file holds; nothing where it is missing or damaged.
template <class T>
std::optional<T> read_json(const std::string& path) {
  std::ifstream in(path);
  if (!in) return std::nullopt;
  try {
    T value;
    set_from_json(parse_json(in), value);
    return value;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace shellmatch

/// SHELLMATCH_JSON(Spread, n, (p95, percentile)): describes a struct by its members in the order in which they are
/// written. The key of a member is its name, or stands behind it in brackets.
#define SHELLMATCH_JSON(Type, ...) SHELLMATCH_JSON_IF((std::is_same_v<std::remove_const_t<S>, Type>), __VA_ARGS__)
/// The same of a template over the dimension.
#define SHELLMATCH_JSON_2D_3D(Template, ...)                                                                        \
  SHELLMATCH_JSON_IF(                                                                                               \
      (std::is_same_v<std::remove_const_t<S>, Template<2>> || std::is_same_v<std::remove_const_t<S>, Template<3>>), \
      __VA_ARGS__)

#define SHELLMATCH_JSON_IF(is_type, ...)                                           \
  template <class S, class Member>                                                 \
  requires is_type [[maybe_unused]] static void describe(S& s, Member&& member) {  \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(SHELLMATCH_JSON_MEMBER, __VA_ARGS__)) \
  }
// Of an entry in brackets SHELLMATCH_JSON_KEYED is chosen, of others SHELLMATCH_JSON_NAMED.
#define SHELLMATCH_JSON_MEMBER(entry) \
  SHELLMATCH_JSON_SECOND(SHELLMATCH_JSON_BRACKETS entry, SHELLMATCH_JSON_NAMED, )(entry)
#define SHELLMATCH_JSON_SECOND(...) SHELLMATCH_JSON_SECOND_OF(__VA_ARGS__)
#define SHELLMATCH_JSON_SECOND_OF(first, second, ...) second
#define SHELLMATCH_JSON_BRACKETS(...) , SHELLMATCH_JSON_KEYED
#define SHELLMATCH_JSON_NAMED(name) member(#name, s.name);
#define SHELLMATCH_JSON_KEYED(entry) SHELLMATCH_JSON_ENTRY entry
#define SHELLMATCH_JSON_ENTRY(name, key) member(#key, s.name);
