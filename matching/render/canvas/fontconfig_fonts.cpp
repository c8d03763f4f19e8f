#include "matching/render/canvas/fontconfig_fonts.h"

#include <dlfcn.h>
#include <fontconfig/fontconfig.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace shellmatch {

namespace {

std::filesystem::path folder_of_fonts() {
  Dl_info library;
  if (dladdr(reinterpret_cast<const void*>(&use_fonts_beside_the_program), &library) == 0 || !library.dli_fname)
    return {};
  std::error_code error;
  // Folders of the processor's, as glibc-hwcaps/x86-64-v3/, are between.
  std::filesystem::path folder = std::filesystem::path(library.dli_fname).parent_path();
  for (int up = 0; up <= 3; ++up, folder = folder.parent_path())
    if (std::filesystem::is_regular_file(folder / "fonts/DejaVuSans.ttf", error)) return folder / "fonts";
  return {};
}

bool add_fonts() {
  const std::filesystem::path folder = folder_of_fonts();
  if (folder.empty()) return false;
  // A machine without a configuration of fonts gets an empty one: the library would print an error that it has none.
  std::error_code error;
  const bool is_configured = std::getenv("FONTCONFIG_FILE") || std::filesystem::exists("/etc/fonts/fonts.conf", error);
  if (!is_configured) FcConfigSetCurrent(FcConfigCreate());
  // File by file: for a folder the library wants to write a cache.
  for (const char* file : {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"})
    FcConfigAppFontAddFile(nullptr, reinterpret_cast<const FcChar8*>((folder / file).c_str()));
  return true;
}

}  // namespace

void use_fonts_beside_the_program() { [[maybe_unused]] static const bool done = add_fonts(); }

}  // namespace shellmatch
