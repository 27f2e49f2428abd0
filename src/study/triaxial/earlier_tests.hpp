// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "lab/warning/earlier_tests.hpp"

namespace triax::study {

/// What the tests of that name or number (db::Store::find) say of an onset to come; nothing
/// without names. Throws lab::BadInput where there is no such test, or where one says nothing.
lab::EarlierTests earlier_tests(const std::string& db, const std::vector<std::string>& names);

}  // namespace triax::study
