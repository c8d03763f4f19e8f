#include "matching/output/hidden_names.h"

#include "matching/output/checksum.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view lock_ending = ".lock", partial_infix = ".partial-";

// What the hidden names of an output folder have of its own: file systems take names of 255 bytes.
std::string stem_of(const std::string& name) {
  constexpr std::size_t most = 190, n_digits = 16;
  return name.size() <= most ? name : name.substr(0, most - n_digits - 1) + "~" + text_checksum(name);
}

std::string beside(const std::string& path, const std::string& ending) {
  const fs::path place = path;
  return (place.parent_path() / fmt::format(".{}{}", stem_of(place.filename().string()), ending)).string();
}

}  // namespace

std::string lock_name(const std::string& path) { return beside(path, std::string(lock_ending)); }

std::string partial_folder_name(const std::string& path) {
  return beside(path, fmt::format("{}{}", partial_infix, ::getpid()));
}

bool is_partial_folder_name(std::string_view entry, const std::string& name) {
  const std::string begin = fmt::format(".{}{}", stem_of(name), partial_infix);
  if (!entry.starts_with(begin)) return false;
  entry.remove_prefix(begin.size());
  if (entry.ends_with(set_aside)) entry.remove_suffix(set_aside.size());
  return !entry.empty() && entry.find_first_not_of("0123456789-") == entry.npos;
}

bool is_hidden_name(std::string_view entry, const std::string& name) {
  return entry == fmt::format(".{}{}", stem_of(name), lock_ending) || is_partial_folder_name(entry, name);
}

std::string name_of_output(std::string_view hidden) {
  if (!hidden.starts_with('.')) return "";
  std::size_t end = hidden.rfind(partial_infix);
  if (end == hidden.npos && hidden.ends_with(lock_ending)) end = hidden.size() - lock_ending.size();
  return end == hidden.npos || end < 2 ? "" : std::string(hidden.substr(1, end - 1));
}

}  // namespace shellmatch
