// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/rows_ahead.hpp"

#include <utility>

namespace triax::lab {
namespace {

constexpr std::size_t kRowsOfBlock = 512;  ///< in a block
constexpr std::size_t kBlocks = 8;         ///< that wait at most

}  // namespace

RowsAhead::RowsAhead(ByteSource& source, const TableLayout& layout, const Findings& findings,
                     std::vector<Warning>& warnings)
    : warnings_(warnings),
      places_(warnings.size()),
      found_(warnings),
      findings_(findings, found_),
      reader_(source, layout, findings_),
      sequence_(layout) {
  for (std::size_t i = 0; i < places_.size(); ++i) places_[i] = i;
  thread_ = std::thread([this] { read_blocks(); });
}

RowsAhead::~RowsAhead() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  room_.notify_one();
  thread_.join();
}

RowsAhead::Block RowsAhead::read_block() {
  Block block;
  block.rows.reserve(kRowsOfBlock);
  try {
    while (block.rows.size() < kRowsOfBlock && !block.is_last) {
      const std::size_t known = found_.size();
      block.is_last = !reader_.next(row_);
      if (block.is_last)
        sequence_.finish(findings_);
      else
        sequence_.add(row_, findings_);
      for (std::size_t i = known; i < found_.size(); ++i)
        block.found.emplace_back(block.rows.size(), found_[i]);
      if (!block.is_last) block.rows.push_back(row_);
    }
  } catch (...) {
    block.failure = std::current_exception();
    block.is_last = true;
  }
  block.position = reader_.position();
  return block;
}

void RowsAhead::read_blocks() {
  for (bool more = true; more;) {
    Block block = read_block();
    more = !block.is_last;
    std::unique_lock lock(mutex_);
    room_.wait(lock, [this] { return blocks_.size() < kBlocks || stop_; });
    if (stop_) return;
    blocks_.push_back(std::move(block));
    filled_.notify_one();
  }
}

/// False where there is none after the present one.
bool RowsAhead::take_block() {
  if (block_.is_last) return false;
  std::unique_lock lock(mutex_);
  filled_.wait(lock, [this] { return !blocks_.empty(); });
  block_ = std::move(blocks_.front());
  blocks_.pop_front();
  next_ = told_ = 0;
  // Waking the thread for one block at a time costs more than reading it.
  if (blocks_.size() <= kBlocks / 2) room_.notify_one();
  return true;
}

void RowsAhead::tell_until(std::size_t row) {
  for (; told_ < block_.found.size() && block_.found[told_].first <= row; ++told_) {
    places_.push_back(warnings_.size());
    warnings_.push_back(block_.found[told_].second);
  }
}

bool RowsAhead::next(Row& row) {
  while (next_ == block_.rows.size()) {
    tell_until(next_);
    if (block_.failure) std::rethrow_exception(std::exchange(block_.failure, nullptr));
    if (!take_block()) return false;
  }
  tell_until(next_);
  row = block_.rows[next_++];
  return true;
}

void RowsAhead::finish() {
  const std::vector<Warning> before = found_;
  findings_.finish();
  for (std::size_t i = 0; i < found_.size(); ++i)
    if (found_[i].text != before[i].text) warnings_[places_[i]].text = found_[i].text;
}

}  // namespace triax::lab
