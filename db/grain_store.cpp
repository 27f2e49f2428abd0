// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/grain_store.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include "db/connection.hpp"
#include "db/grain_reader.hpp"
#include "lab/base/text.hpp"

namespace triax::db {

struct GrainStore::Impl {
  /// Runs `work`; what SQLite says becomes an error that names the file.
  template <class Work>
  auto guarded(const Work& work) {
    try {
      return work();
    } catch (const SQLite::Exception& error) {
      throw_for(error, path);
    }
  }
  std::string path;
  SQLite::Database database;
};

GrainStore::GrainStore(const std::string& path) : impl_(new Impl{path, open_for_reading(path)}) {}
GrainStore::~GrainStore() = default;

std::vector<std::int64_t> GrainStore::all() const {
  return impl_->guarded([&] {
    std::vector<std::int64_t> ids;
    SQLite::Statement select(impl_->database, "SELECT id FROM grain_runs ORDER BY id");
    while (select.executeStep()) ids.push_back(select.getColumn(0).getInt64());
    return ids;
  });
}

std::optional<std::int64_t> GrainStore::find(const std::string& name) const {
  return impl_->guarded([&]() -> std::optional<std::int64_t> {
    SQLite::Statement select(impl_->database,
                             "SELECT id FROM grain_runs WHERE name = ?1 OR id = ?2 "
                             "ORDER BY name = ?1 DESC, id DESC LIMIT 1");
    select.bind(1, name);
    select.bind(2, lab::whole_text_as<std::int64_t>(name).value_or(0));
    if (!select.executeStep()) return std::nullopt;
    return select.getColumn(0).getInt64();
  });
}

StoredGrainRun GrainStore::load(std::int64_t id) const {
  return impl_->guarded([&] { return read_grain_run(impl_->database, id); });
}

}  // namespace triax::db
