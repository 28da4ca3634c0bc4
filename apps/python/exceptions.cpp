// SPDX-License-Identifier: BSD-3-Clause
#include "apps/python/bindings.h"
#include "apps/python/in_memory.h"
#include "io/error.h"
#include "reconstruct/geometry/interruption.h"

#include <exception>
#include <filesystem>
#include <system_error>

namespace ridgeline::python {
namespace py = pybind11;
namespace fs = std::filesystem;

namespace {

py::handle file_error;

/// ValueError for what is in memory.
PyObject* type_of(const io::IoError& error) {
  if (is_in_memory(error.path())) return PyExc_ValueError;
  std::error_code ignored;
  return fs::exists(error.path(), ignored) ? file_error.ptr() : PyExc_FileNotFoundError;
}

}  // namespace

/// A file's fault is an OSError, of a file that is not there FileNotFoundError. The caller's is a ValueError already.
void add_exceptions(py::module_& core) {
  file_error = py::exception<io::IoError>(core, "InputFileError", PyExc_OSError).release();
  file_error.attr("__doc__") =
      "A file is not what it should be; the message names it, what is wrong and the rule.";
  // NOLINTNEXTLINE(performance-unnecessary-value-param): the signature is pybind11's
  py::register_exception_translator([](std::exception_ptr thrown) {
    if (!thrown) return;
    try {
      std::rethrow_exception(thrown);
    } catch (const io::IoError& error) {
      PyErr_SetString(type_of(error), error.what());
    } catch (const Interrupted&) {
      PyErr_SetNone(PyExc_KeyboardInterrupt);
    } catch (const fs::filesystem_error& error) {
      PyErr_SetString(PyExc_OSError, error.what());
    }
  });
}

}  // namespace ridgeline::python
