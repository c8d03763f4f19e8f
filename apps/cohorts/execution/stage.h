#pragma once
/// \file
/// A stage of a cohort: one matching of an atlas onto every subject.

#include <string>
#include <vector>

namespace shellmatch {

/// A round of the search for the atlas, or the last stage, whose matchings make the result, or the first part of it.
struct Stage {
  int round = 0;  ///< counted from 1; 0 is the last stage, and first_part that part of it which is done before

  /// The first subjects of the last stage, from which the poses of the others are predicted.
  static constexpr int first_part = -1;

  bool is_last() const { return round <= 0; }
  std::string name() const {
    return round == first_part ? "first subjects" : is_last() ? "last stage" : "round " + std::to_string(round);
  }
  /// Of the stage's own files, within the cohort's folder.
  std::string folder(const std::string& cohort) const {
    return is_last() ? cohort : cohort + "/atlas/round_" + std::to_string(round);
  }
  friend bool operator==(const Stage&, const Stage&) = default;
};

/// The files of an atlas.
struct AtlasFiles {
  std::string shape;
  std::string landmarks;  ///< CSV; may be empty
  /// Of the round whose mean it is: its runs have matched nearly the same shapes. Empty where it is none's.
  std::string runs = {};
  /// Results of the first subjects, from which the poses of the others are predicted.
  std::vector<std::string> images = {};
};

}  // namespace shellmatch
