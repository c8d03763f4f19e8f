#pragma once

namespace shellmatch {

/// Makes the fonts known that lie beside the program where it was brought without a package manager (scripts/package
/// --tarball and --wheel): in fonts/, beside the library with this code or up to three folders above. Elsewhere the
/// system's are used. Only the first call looks.
void use_fonts_beside_the_program();

}  // namespace shellmatch
