#include "apps/runs/description_copy.h"

#include "base/error.h"
#include "base/replace_file.h"
#include "matching/output/checksum.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace shellmatch {

namespace {

constexpr std::string_view mark = "# Copy made by shellmatch; checksum of the lines above: ";

std::string marked(std::string text) {
  if (!text.ends_with('\n')) text += '\n';
  return text + std::string(mark) + text_checksum(text) + "\n";
}

bool is_marked(const std::string& contents) {
  const std::size_t at = contents.rfind(mark);
  return at != std::string::npos && contents == marked(contents.substr(0, at));
}

}  // namespace

std::string contents_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void check_copy_place(const std::string& path, const std::string& text) {
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path, error))) return;
  const std::string contents = contents_of(path);
  if (contents != text && !is_marked(contents))
    throw_input_error(
        "{}: is not replaced, since it has been written or edited by somebody; move it, or choose another folder with "
        "-o",
        path);
}

void keep_copy(const std::string& path, const std::string& text) {
  check_copy_place(path, text);
  if (const std::string contents = contents_of(path); contents != text && contents != marked(text))
    replace_file(path, marked(text));
}

}  // namespace shellmatch
