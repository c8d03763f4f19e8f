#pragma once
/// \file
/// Texts of the library's as Python's. They may name files and columns, whose bytes are of any encoding.

#include <pybind11/pybind11.h>

#include <string>
#include <string_view>
#include <vector>

namespace shellmatch::python {

/// Bytes that are no UTF-8 become \xNN, so that the text can be printed. \pre the interpreter's lock is held
pybind11::str text_of(std::string_view bytes);

/// The same of several, as a list.
pybind11::list texts_of(const std::vector<std::string>& texts);

}  // namespace shellmatch::python
