#include "geometry/polydata/vtk_one_thread.h"

#include <vtkVersionMacros.h>

// The header of VTK 9.1 is no C++20; with the oneTBB 2021.8 of that Debian, want of memory ends in an exception.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
#include <vtkSMPTools.h>
#endif

namespace shellmatch {

void keep_vtk_in_one_thread() {
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  vtkSMPTools::SetBackend("Sequential");
#endif
}

}  // namespace shellmatch
