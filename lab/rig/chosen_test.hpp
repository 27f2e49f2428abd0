// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/base/byte_source.hpp"
#include "lab/records/tables/table_tests.hpp"
#include "lab/rig/recorded.hpp"

namespace triax::lab {

/// The test of a table that options.test names; all rows for 0 and for a DIGGS file, whose source
/// is one test already. Throws BadInput if there is no such test.
TableTest chosen_test(ByteSource& source, const RecordOptions& options);

}  // namespace triax::lab
