#include "matching/map_file/vtk_messages.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace shellmatch {

namespace {

struct Window : vtkOutputWindow {
  vtkTypeMacro(Window, vtkOutputWindow) static Window* New() {
    auto* window = new Window;
    window->InitializeObjectBase();
    return window;
  }
  void DisplayText(const char*) override { any = true; }
  void DisplayErrorText(const char*) override { any = true; }
  void DisplayWarningText(const char*) override { any = true; }
  void DisplayGenericWarningText(const char*) override { any = true; }
  void DisplayDebugText(const char*) override {}
  bool any = false;
};

}  // namespace

struct VtkMessages::State {
  vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  vtkLogger::Verbosity verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkNew<Window> window;
};

VtkMessages::VtkMessages() : state_(std::make_unique<State>()) {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(state_->window);
}

VtkMessages::~VtkMessages() {
  vtkOutputWindow::SetInstance(state_->before);
  vtkLogger::SetStderrVerbosity(state_->verbosity);
}

bool VtkMessages::any() const { return state_->window->any; }

}  // namespace shellmatch
