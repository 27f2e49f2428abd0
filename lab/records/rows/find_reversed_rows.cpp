// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/find_reversed_rows.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lab/base/bad_input.hpp"
#include "lab/records/rows/reversed_rows.hpp"
#include "lab/records/rows/row_order.hpp"
#include "lab/records/rows/sample_rows.hpp"
#include "lab/records/table_reader.hpp"

namespace triax::lab {
namespace {

/// Rows of a source, up to a number of them.
class FirstRows {
 public:
  FirstRows(ByteSource& source, const TableLayout& layout, std::size_t count)
      : findings_(warnings_), order_(layout.file) {
    try {
      TableReader reader(source, layout, findings_);
      Row row;
      while (count_ < count && reader.next(row)) {
        order_.add(row, count_ == 0, findings_);
        ++count_;
        if (count_ == 1) first_ = strain_of(row);
        last_ = strain_of(row);
        last_line_ = row.line;
      }
    } catch (const BadInput&) {
      count_ = 0;  // reported when the record is read
    }
  }
  bool is_usable() const { return count_ > 0; }
  std::string reversed() const { return order_.reversed(); }
  bool runs_to_zero() const { return std::fabs(last_) < std::fabs(first_); }
  std::int64_t last_line() const { return last_line_; }

 private:
  static double strain_of(const Row& row) {
    const double strain = row.si[index(Quantity::axial_strain)];
    return std::isnan(strain) ? row.si[index(Quantity::axial_displacement)] : strain;
  }

  std::vector<Warning> warnings_;
  Findings findings_;
  RowOrder order_;
  std::size_t count_ = 0;
  double first_ = 0, last_ = 0;
  std::int64_t last_line_ = 0;
};

}  // namespace

void find_reversed_rows(ByteSource& source, TableLayout& layout, Findings& findings) {
  constexpr std::size_t kRows = 200;
  const FirstRows first(source, layout, kRows);
  source.rewind();
  if (!first.is_usable() || (first.reversed().empty() && !first.runs_to_zero())) return;
  const TableSample sample = read_sample(source);
  source.rewind();
  const SampleRows ends = sample_rows(sample, layout);
  const FirstRows rows(*ends.text, ends.layout, sample.size());
  const std::string found = rows.reversed();
  if (found.empty()) return;
  layout.is_reversed = true;
  if (layout.last_row_line == 0) layout.last_row_line = sample.number(sample.size() - 1);
  findings.note(
      "reversed rows", layout.first_row_line,
      "the rows are in reverse order: " + found + "; they are read from the last one to the first");
}

std::unique_ptr<ByteSource> in_order(std::unique_ptr<ByteSource> text, const TableLayout& layout) {
  if (!layout.is_reversed) return text;
  return std::make_unique<ReversedRows>(std::move(text), layout.first_row_line,
                                        layout.last_row_line);
}

}  // namespace triax::lab
