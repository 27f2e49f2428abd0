// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Columns of the tests that browsers look at, so that a zoom reads no database.
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>

#include "src/page/api/memory_budget.hpp"
#include "src/study/triaxial/test_columns.hpp"

namespace triax::src {

class ColumnCache {
 public:
  explicit ColumnCache(MemoryBudget& budget) : budget_(budget) {}

  /// Calls `use` with the columns of a test, which it reads and cuts and which then take no more
  /// than `bytes`; others wait that want the same test. `version` says which test it is: what was
  /// kept of another version is dropped. Tests that nobody asked for lately make room. Throws
  /// Refused where one test alone is too much.
  void with(std::int64_t test, const std::string& version,
            const std::function<std::size_t(const study::TestColumns&)>& bytes,
            const std::function<void(study::TestColumns&)>& use);

 private:
  struct Kept {
    Kept(std::int64_t id, std::string v) : columns(id), version(std::move(v)) {}
    std::mutex mutex;
    study::TestColumns columns;
    std::string version;
    MemoryBudget::Share share;
    std::size_t bytes = 0;
  };
  std::shared_ptr<Kept> kept_of(std::int64_t test, const std::string& version);
  MemoryBudget::Share room_for(std::size_t bytes, const Kept* but);

  MemoryBudget& budget_;
  std::mutex mutex_;
  std::list<std::shared_ptr<Kept>> all_;  ///< asked for last, first
};

}  // namespace triax::src
