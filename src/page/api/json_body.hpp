// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What stands in the JSON that a browser sends; all of them throw Refused with what was wanted.
#include <optional>
#include <string>
#include <vector>

#include "src/study/json_parts.hpp"

namespace triax::src {

/// An object.
study::Json json_body(const std::string& body);
std::string text_in(const study::Json& body, const char* key);
/// Nothing where it is not there, or null.
std::optional<double> number_in(const study::Json& body, const char* key);
/// False where it is not there, or null.
bool flag_in(const study::Json& body, const char* key);
/// One number or several; empty where it is not there.
std::vector<double> numbers_in(const study::Json& body, const char* key);

}  // namespace triax::src
