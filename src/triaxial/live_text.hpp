// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/triaxial/live_account.hpp"

namespace triax::src {

/// What was said when, as a table of at most text_width() columns, and how that compares with the
/// result.
std::string live_text(const db::StoredTest& test, const study::LiveAccount& account);

}  // namespace triax::src
