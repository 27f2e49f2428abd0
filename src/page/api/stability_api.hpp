// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Studies of a law that the page asks for. Those that compute throw lab::WorkFailed once the
// program is ending, and Refused once the request is cancelled.
#include <atomic>

#include "src/page/request/request.hpp"

namespace triax::src {

PageAnswer list_of_materials();
/// {"material", "void_ratio", "p_kPa", "eta": [...] or "q_kPa": [...], "step_deg"}: the document of
/// `probe --json`.
PageAnswer probe(const PageRequest& request, const std::atomic<bool>& ending);
/// {"material", "void_ratio", "columns", "rows", "directions", "p_from_kPa", "p_to_kPa",
/// "q_from_kPa", "q_to_kPa"}: the document of `domain --json`. What is left out is what the set is
/// for.
PageAnswer domain(const PageRequest& request, const std::atomic<bool>& ending);

}  // namespace triax::src
