#pragma once
/// \file
/// The program as one function. The executable holds nothing else, so that a package can have all code in one shared
/// library, compiled for several vector units, of which the dynamic loader takes the right one (cmake/Package.cmake).

/// Parses the command line, executes the command and translates failures to exit codes. `argc` and `argv` as for
/// main().
extern "C" [[gnu::visibility("default")]] int shellmatch_main(int argc, char** argv);
