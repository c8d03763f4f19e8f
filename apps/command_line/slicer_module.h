#pragma once
/// \file
/// A command as a command line module of 3D Slicer: its description as Slicer's Execution Model wants it
/// (https://slicer.readthedocs.io/en/latest/developer_guide/modules/slicer_execution_model.html), made from the
/// command's options.

#include <string>

namespace CLI {
class App;
}

namespace shellmatch {

/// The XML that Slicer reads from `PROGRAM --xml`. Flags have '_' where the options have '-', as names in it are those
/// of variables; the program understands both. \param command of shellmatch, with its options
std::string slicer_module_xml(const CLI::App& command);

}  // namespace shellmatch
