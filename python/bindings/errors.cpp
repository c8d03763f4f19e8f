#include "python/bindings/errors.h"

#include "base/error.h"
#include "base/stop.h"
#include "python/bindings/arrays.h"

#include <pybind11/pybind11.h>

#include <exception>
#include <new>
#include <stdexcept>

namespace shellmatch::python {

namespace py = pybind11;

namespace {

void raise(const char* type, const char* text) {
  const py::object error = py::module_::import("shellmatch.errors").attr(type);
  PyErr_SetObject(error.ptr(), text_of(text).ptr());
}

// The innermost of the classes that fits.
void translate(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(std::move(thrown));
  } catch (const py::error_already_set&) {
    throw;  // Python's own
  } catch (const py::builtin_exception&) {
    throw;
  } catch (const InputError& error) {
    raise("InputError", error.what());
  } catch (const MemoryError& error) {
    raise("OutOfMemoryError", error.what());
  } catch (const std::bad_alloc&) {
    raise("OutOfMemoryError", "not enough memory");
  } catch (const EnvironmentError& error) {
    raise("ResourceError", error.what());
  } catch (const Stopped& error) {
    raise("Error", error.what());
  } catch (const std::logic_error& error) {
    raise("InternalError", error.what());
  } catch (const std::exception& error) {
    raise("Error", error.what());
  }
}

}  // namespace

void translate_errors() { py::register_local_exception_translator(translate); }

}  // namespace shellmatch::python
