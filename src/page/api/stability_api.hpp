// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Studies of a law that the page asks for.
#include <atomic>
#include <string>

#include "src/page/request/request.hpp"

namespace triax::src {

PageAnswer list_of_materials();
/// {"material", "void_ratio", "p_kPa", "eta": [...] or "q_kPa": [...], "step_deg"}: the document of
/// `probe --json`.
PageAnswer probe(const std::string& body);
/// {"material", "void_ratio", "columns", "rows", "directions", "p_from_kPa", "p_to_kPa",
/// "q_from_kPa", "q_to_kPa"}: the document of `domain --json`. What is left out is what the set is
/// for. Throws lab::WorkFailed where the program is ending.
PageAnswer domain(const std::string& body, const std::atomic<bool>& ending);

}  // namespace triax::src
