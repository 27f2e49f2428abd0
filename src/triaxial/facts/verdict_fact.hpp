// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

#include "db/store.hpp"

namespace triax::src {

/// What a test came to in one sentence: "flow: strength is lost and does not return; ...".
std::string verdict_line(const db::StoredTest& test);

/// "flow", "not judged", "interrupted"...: for tables. `kind` is empty without a verdict.
std::string verdict_word(db::TestStatus status, std::optional<lab::CollapseKind> kind);

}  // namespace triax::src
