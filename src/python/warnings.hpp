// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace triax::python {

/// Gives a RuntimeWarning of Python, from any thread; a filter that makes it an error has no
/// effect. Pre-condition: the GIL is not held.
void warn(const std::string& sentence);

/// Gives a RuntimeWarning of every test whose readings are missing from the database
/// (db/missing_readings.hpp); an exception where a filter makes it one. Pre-condition: the GIL is
/// not held.
void warn_of_missing_readings(const std::string& db);

}  // namespace triax::python
