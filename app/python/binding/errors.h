#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace scb::python {

namespace py = pybind11;

/// Translates the library's exceptions to those in scb/errors.py, with the same sentences.
void add_errors();

/// Throws InputError with "NAME: WHAT".
[[noreturn]] void refuse(const std::string& name, const std::string& what);

}  // namespace scb::python
