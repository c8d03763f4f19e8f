#include "base/replace_file.h"

#include "base/error.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace shellmatch {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw_environment_error("{}: cannot be written ({}); check the folder, its permissions and the free space", path, reason);
}

}  // namespace

std::string partial_file_name(const std::string& path) {
  const fs::path place = path;
  return (place.parent_path() / fmt::format("{}{}-{}", partial_file_prefix, ::getpid(), place.filename().string())).string();
}

void replace_file(const std::string& path, const std::function<void(const std::string&)>& write) {
  const std::string partial = partial_file_name(path);
  std::error_code error, ignored;
  try {
    write(partial);
    fs::rename(partial, path, error);
    if (error) fail(path, error.message());
  } catch (...) {
    fs::remove(partial, ignored);
    throw;
  }
}

void replace_file(const std::string& path, std::string_view bytes) {
  replace_file(path, [&](const std::string& partial) {
    errno = 0;
    std::ofstream stream(partial, std::ios::binary | std::ios::trunc);
    if (!stream) fail(path, std::strerror(errno));
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) fail(path, errno != 0 ? std::strerror(errno) : "writing failed");
  });
}

}  // namespace shellmatch
