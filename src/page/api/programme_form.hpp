// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The sample programmes that are inside the program, each with the keys that a form offers.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/programmes/programme.hpp"
#include "src/study/json_parts.hpp"

namespace triax::src {

/// Name, title, type, what its first lines say, and the fields of its form: each with its key, the
/// keys that take the same value, label, unit, value, and bounds or choices.
study::Json programme_forms();
/// The text of a sample; nothing where there is none of that name.
std::optional<std::string_view> sample_programme(std::string_view name);

/// A programme of the page: the name of a sample, or its text. It must not name files of this
/// machine. Throws Refused and lab::BadInput.
lab::Programme programme_of(const std::string& name_or_text,
                            const std::vector<lab::TomlEdit>& edits);

}  // namespace triax::src
