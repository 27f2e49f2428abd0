// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the page changes: records that are taken in, tests that are run.
#include "src/page/api/laboratory.hpp"
#include "src/page/request/request.hpp"

namespace triax::src {

/// Replays the record that was sent; or says what it does not hold.
PageAnswer take_record(PageLaboratory& laboratory, const PageRequest& request);
/// Begins a test of a programme; its number.
PageAnswer begin_run(PageLaboratory& laboratory, const std::string& body);
PageAnswer order_run(PageLaboratory& laboratory, std::int64_t test, RunOrder::Kind kind,
                     const std::string& body);
/// An address that lets one more browser in.
PageAnswer another_browser(PageLaboratory& laboratory);
/// Samples with the fields of their forms.
PageAnswer list_of_programmes();

}  // namespace triax::src
