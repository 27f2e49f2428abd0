// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the routes of the page share.
#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "src/page/api/column_cache.hpp"
#include "src/page/api/desk.hpp"
#include "src/page/api/kept_texts.hpp"
#include "src/page/api/memory_budget.hpp"
#include "src/page/http/limits.hpp"
#include "src/page/live/live_tests.hpp"
#include "src/page/record/record_reading.hpp"

namespace triax::src {

struct PageLaboratory {
  PageLaboratory(const std::string& database, std::string rig_file)
      : db(database), rig(std::move(rig_file)), live(database) {}

  std::string db;
  std::string rig;                           ///< file of instruments; empty: none
  std::function<std::string()> new_address;  ///< that lets another browser in
  /// Reads an uploaded record until it is done or `stop` returns true; as read_record(). The
  /// program sets read_record_apart(), tests read in their own process.
  std::function<std::string(const RecordToRead&, const Upload&, const std::function<bool()>& stop)>
      read_record = [](const RecordToRead& record, const Upload& upload,
                       const std::function<bool()>&) { return src::read_record(record, upload); };
  std::uint64_t record_bytes = PageLimits{}.record_bytes;  ///< that are taken in of one record
  std::atomic<bool> ending = false;                        ///< nothing new is begun
  MemoryBudget budget{std::size_t{512} << 20};
  ColumnCache columns{budget};
  KeptTexts summaries, outlines;
  Desk desk;
  LiveTests live;
};

}  // namespace triax::src
