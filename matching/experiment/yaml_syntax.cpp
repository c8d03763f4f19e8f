#include "matching/experiment/yaml_syntax.h"

#include "base/error.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace shellmatch {

namespace {

// Limits the cost of reading a wrong file; no experiment needs more.
constexpr std::size_t max_bytes = 1 << 20;

// Notes where a document and its first value begin, and keeps nothing of it.
struct DocumentStart final : YAML::EventHandler {
  YAML::Mark mark;
  std::optional<YAML::Mark> value;
  void OnDocumentStart(const YAML::Mark& at) override { mark = at; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark& at, YAML::anchor_t) override { begin(at); }
  void OnScalar(const YAML::Mark& at, const std::string&, YAML::anchor_t, const std::string&) override { begin(at); }
  void OnSequenceStart(const YAML::Mark& at, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
    begin(at);
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& at, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
    begin(at);
  }
  void OnMapEnd() override {}
  void begin(const YAML::Mark& at) {
    if (!value) value = at;
  }
};

// Where anything follows the first document. The parser takes stray characters, as the comma in "{a: 1},", for an empty
// document without moving on, so that no more than two documents may be asked for: YAML::LoadAll would go on for ever.
std::optional<DocumentStart> second_document(const std::string& text) {
  std::istringstream in(text);
  YAML::Parser parser(in);
  DocumentStart first, second;
  if (!parser.HandleNextDocument(first) || !parser.HandleNextDocument(second)) return std::nullopt;
  return second;
}

std::string line_of(const std::string& text, int number) {
  std::istringstream lines(text);
  std::string line;
  for (int i = 0; i <= number && std::getline(lines, line); ++i) {
  }
  return line;
}

}  // namespace

std::string read_yaml_file(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw_input_error("{}: no such file", path);
  if (std::filesystem::is_directory(path, error)) throw_input_error("{}: is a folder; expected a YAML file", path);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw_input_error("{}: cannot be opened: {}", path, std::strerror(errno));
  std::string text(max_bytes + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) throw_input_error("{}: cannot be read: {}", path, std::strerror(errno));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > max_bytes) throw_input_error("{}: larger than 1 MB; expected a YAML file of options", path);
  return text;
}

YAML::Node parse_yaml_map(const std::string& text, const std::string& name) {
  if (text.find('\0') != std::string::npos)
    throw_input_error("{}: holds zero bytes; expected a YAML file of options, as text", name);
  YAML::Node document;
  std::optional<DocumentStart> second;
  try {
    second = second_document(text);
    document = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw_input_error("{}:{}: YAML syntax error in column {}: {}", name, error.mark.line + 1, error.mark.column + 1,
                      error.msg);
  }
  if (document.IsNull() && !second)
    throw_input_error("{}: the file is empty; expected options as 'key: value' (`shellmatch config` prints all)", name);
  if (second) {
    if (line_of(text, second->mark.line).starts_with("---"))
      throw_input_error("{}:{}: a second YAML document begins; expected one per file", name,
                        second->value.value_or(second->mark).line + 1);
    throw_input_error("{}:{}: the options end before column {}, and something follows; remove it", name,
                      second->mark.line + 1, second->mark.column + 1);
  }
  if (!document.IsMap())
    throw_input_error("{}:{}: expected a map of options, as 'key: value', but found {}", name, document.Mark().line + 1,
                      document.IsSequence() ? "a list" : "a single value");
  return document;
}

std::optional<int> column_after_value(const std::string& text) {
  const std::optional<DocumentStart> second = second_document(text);
  return second ? std::optional(second->mark.column + 1) : std::nullopt;
}

}  // namespace shellmatch
