// SPDX-License-Identifier: BSD-3-Clause
#include "apps/python/bindings.h"
#include "apps/python/in_memory.h"
#include "io/error.h"
#include "reconstruct/geometry/interruption.h"

#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ridgeline::python {
namespace py = pybind11;
namespace fs = std::filesystem;

namespace {

py::handle file_error;

/// The Python type of an error: ValueError for invalid data in memory, otherwise a file error.
PyObject* type_of(const io::IoError& error) {
  if (is_in_memory(error.path())) return PyExc_ValueError;
  const bool is_missing = dynamic_cast<const io::MissingFileError*>(&error) != nullptr;
  return is_missing ? PyExc_FileNotFoundError : file_error.ptr();
}

/// `text` with the prefix `from`, if present, replaced by `to`.
std::string with_beginning(std::string text, std::string_view from, std::string_view to) {
  return text.starts_with(from) ? text.replace(0, from.size(), to) : text;
}

/// The message without line numbers if the data are in memory, where gates are written one per line
/// and a config on a single line.
std::string without_lines(const io::IoError& error) {
  if (error.path() == kGatesInMemory)
    return with_beginning(error.what(), "gates: line ", "gates: entry ");
  if (error.path() == apps::kConfigInMemory)
    return with_beginning(error.what(), "config: line 1: ", "");
  return error.what();
}

/// The message without the backticks around options, which are Python arguments of the same name.
std::string without_ticks(std::string message) {
  std::erase(message, '`');
  return message;
}

}  // namespace

/// Translates C++ exceptions to Python: a missing file raises FileNotFoundError, any other file
/// error InputFileError (an OSError), an invalid argument ValueError, and work interrupted because
/// Python is exiting SystemExit.
void add_exceptions(py::module_& core) {
  file_error = py::exception<io::IoError>(core, "InputFileError", PyExc_OSError).release();
  file_error.attr("__doc__") =
      "A file is invalid; the message names the file, the problem and the rule.";
  // NOLINTNEXTLINE(performance-unnecessary-value-param): the signature is pybind11's
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    if (!thrown) return;
    try {
      std::rethrow_exception(thrown);
    } catch (const Interrupted&) {
      PyErr_SetNone(PyExc_SystemExit);  // Python is exiting; this thread ends silently
    } catch (const io::IoError& error) {
      PyErr_SetString(type_of(error), without_ticks(without_lines(error)).c_str());
    } catch (const std::invalid_argument& error) {
      PyErr_SetString(PyExc_ValueError, without_ticks(error.what()).c_str());
    } catch (const fs::filesystem_error& error) {
      PyErr_SetString(PyExc_OSError, error.what());
    }
  });
}

}  // namespace ridgeline::python
