#pragma once
/// \file
/// The library's exceptions as those of Python's module shellmatch.errors.

namespace shellmatch::python {

void translate_errors();

}  // namespace shellmatch::python
