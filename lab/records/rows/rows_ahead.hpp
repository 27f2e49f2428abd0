// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "lab/records/findings.hpp"
#include "lab/records/rows/row_sequence.hpp"
#include "lab/records/table_reader.hpp"

namespace triax::lab {

/// The rows of a TableReader, checked by a RowSequence, read by a thread of its own some blocks
/// ahead: parsing a text, or unpacking a workbook, takes as long as a quarter of what is done with
/// its readings. Rows, findings and failures come in the order, and at the row, in which the reader
/// alone gives them.
class RowsAhead {
 public:
  /// All four must outlive this object; `source` and `layout` are the thread's until then.
  /// `findings` writes into `warnings`; both are touched in next() and finish() only.
  RowsAhead(ByteSource& source, const TableLayout& layout, const Findings& findings,
            std::vector<Warning>& warnings);
  ~RowsAhead();
  RowsAhead(const RowsAhead&) = delete;
  RowsAhead& operator=(const RowsAhead&) = delete;

  /// As TableReader::next. After a failure: false.
  bool next(Row& row);
  /// Bytes that were read, to the end of the present block.
  std::uint64_t position() const { return block_.position; }
  /// Adds the counts to the texts of what the reader found. Pre-condition: next() gave false.
  void finish();
  /// As those of the reader. Pre-condition: likewise.
  const std::string& trailer() const { return reader_.trailer(); }
  std::int64_t trailer_line() const { return reader_.trailer_line(); }

 private:
  struct Block {
    std::vector<Row> rows;
    std::vector<std::pair<std::size_t, Warning>> found;  ///< before the row of that number
    std::exception_ptr failure;                          ///< behind the rows
    std::uint64_t position = 0;
    bool is_last = false;
  };
  void read_blocks();
  Block read_block();
  bool take_block();
  void tell_until(std::size_t row);

  std::vector<Warning>& warnings_;
  Block block_;  ///< that next() is in
  std::size_t next_ = 0, told_ = 0;
  std::vector<std::size_t> places_;  ///< in `warnings_`, of those that the reader found

  // Of the thread, until it has ended.
  std::vector<Warning> found_;
  Findings findings_;
  TableReader reader_;
  RowSequence sequence_;
  Row row_;  ///< the last one: the reader needs it at the start of the next block

  std::mutex mutex_;
  std::condition_variable filled_, room_;
  std::deque<Block> blocks_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace triax::lab
