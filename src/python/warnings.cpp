// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/python/warnings.hpp"

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include "db/missing_readings.hpp"
#include "lab/base/text.hpp"

namespace triax::python {

namespace {

/// Throws the warning where a filter of the user's makes it an error.
void warn_or_throw(const std::string& sentence) {
  const pybind11::gil_scoped_acquire gil;
  if (PyErr_WarnEx(PyExc_RuntimeWarning, sentence.c_str(), 1) != 0)
    throw pybind11::error_already_set();
}

}  // namespace

void warn(const std::string& sentence) {
  const pybind11::gil_scoped_acquire gil;
  if (PyErr_WarnEx(PyExc_RuntimeWarning, sentence.c_str(), 1) != 0) PyErr_Clear();
}

void warn_of_missing_readings(const std::string& db) {
  for (const db::MissingReadings& missing : db::missing_readings(db))
    warn_or_throw(fmt::format("{}: test {} {}: {}", db, missing.test, lab::excerpt(missing.name),
                              in_words(missing)));
}

}  // namespace triax::python
