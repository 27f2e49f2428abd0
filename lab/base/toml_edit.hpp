// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// For toml_reader.cpp: the one other place that sees toml++.
#include <toml++/toml.h>

#include <string>

#include "lab/base/toml_reader.hpp"

namespace triax::lab {

/// Puts the value of `edit` into the document; tables on the way that are missing are made, so that
/// a key that only has a default can be given. Throws BadInput "FILE: KEY = VALUE: ..." for a
/// number beyond its list, a way through a value, and a table or list in the place of the value.
void apply_edit(toml::table& document, const TomlEdit& edit, const std::string& file);

}  // namespace triax::lab
