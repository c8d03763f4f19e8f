#pragma once
/// \file
/// VTK in the thread that calls it.

namespace shellmatch {

/// From now on VTK starts no threads of its own. Those of VTK 9.3 are oneTBB's, which with oneTBB 2022.1 (Debian 13)
/// wait for ever where memory is wanting.
void keep_vtk_in_one_thread();

}  // namespace shellmatch
