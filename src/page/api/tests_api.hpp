// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tests of the database, read only.
#include "src/page/api/laboratory.hpp"
#include "src/page/request/request.hpp"

namespace triax::src {

/// All tests in short, which of them run, and how long a record may be that is sent.
PageAnswer list_of_tests(PageLaboratory& laboratory);
/// The document of `report --json` with stages, facts, columns and whether this program runs it.
PageAnswer test_of(PageLaboratory& laboratory, std::int64_t id);
/// A hundred points of q and p′.
PageAnswer outline_of(PageLaboratory& laboratory, std::int64_t id);
PageAnswer window_of(PageLaboratory& laboratory, std::int64_t id, const Target& target);
/// csv, json, html or pdf as a file. Throws Refused once the request is cancelled.
PageAnswer export_of(PageLaboratory& laboratory, std::int64_t id, const PageRequest& request);
/// The report as a page of its own. Throws Refused once the request is cancelled.
PageAnswer sheet_of(PageLaboratory& laboratory, std::int64_t id, const PageRequest& request);

}  // namespace triax::src
