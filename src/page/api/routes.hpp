// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "src/page/api/laboratory.hpp"
#include "src/page/request/request.hpp"

namespace triax::src {

/// What the page is given (docs/how-to/browser.md). Throws Refused, lab::BadInput and
/// lab::WorkFailed.
PageAnswer answer(PageLaboratory& laboratory, const PageRequest& request);
/// The queue whose threads compute the answer.
WorkQueue queue_of(const PageRequest& request);

}  // namespace triax::src
