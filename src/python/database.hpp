// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <mutex>
#include <string>

#include "db/store.hpp"
#include "src/python/columns.hpp"

namespace triax::python {

/// A database that is read, from any thread of Python: a Store is for one at a time.
struct Database {
  explicit Database(const std::string& file) : path(file), store(file) {}
  std::string path;
  std::mutex one_at_a_time;
  db::Store store;
};

/// A stored test; its tables are loaded when they are first asked for, and kept.
struct StoredTest {
  std::shared_ptr<Database> from;
  db::StoredTest stored;
  std::shared_ptr<Columns> states = nullptr, readings = nullptr, work = nullptr;
};

/// Opens the database anew. Pre-condition: the GIL is not held.
StoredTest test_of(const std::string& db, std::int64_t id);

}  // namespace triax::python
