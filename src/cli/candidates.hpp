// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace triax::src {

/// For shell completion: what `kind` may be called, a name a line: "tests" (those of the database
/// `db`, blanks as underscores, as `triax report` understands them), "ids" (their numbers),
/// "materials" or "queries".
/// Nothing where there is none, or on any trouble: a shell that completes must not be disturbed.
[[nodiscard]] std::string candidates(const std::string& kind, const std::string& db);

}  // namespace triax::src
