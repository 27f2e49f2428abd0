// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>

#include "lab/base/byte_source.hpp"
#include "lab/intake/text/table_sample.hpp"
#include "lab/records/table_layout.hpp"

namespace triax::lab {

/// The first and the last lines of a file as a table of its own.
struct SampleRows {
  std::unique_ptr<ByteSource> text;
  TableLayout layout;  ///< with the line numbers of `text`
};
SampleRows sample_rows(const TableSample& sample, const TableLayout& layout);

}  // namespace triax::lab
