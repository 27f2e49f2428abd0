// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/store.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "db/channel_columns.hpp"
#include "db/connection.hpp"
#include "db/missing_readings.hpp"
#include "db/plain_statement.hpp"
#include "db/scan_writer.hpp"
#include "db/scans/read_columns.hpp"
#include "db/scans/scan_codec.hpp"
#include "db/summary_reader.hpp"
#include "db/test_reader.hpp"
#include "db/test_rows.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::db {
namespace {

using SQLite::Statement;

std::string select_scans(SQLite::Database& database) {
  return "SELECT " + selected(database, "scans", "s", scan_columns()) + ", " +
         selected(database, "scan_details", "d", detail_columns()) +
         " FROM scans s LEFT JOIN scan_details d ON d.id = s.id "
         "WHERE s.id BETWEEN ?1 << 32 | ?3 AND ?1 << 32 | ?4 "
         "AND (s.id & 4294967295) % ?2 = 0 ORDER BY s.id";
}

constexpr std::int64_t kLastReading = 4294967295;

bool has_details(SQLite::Database& database, std::int64_t id) {
  Statement any(database,
                "SELECT EXISTS (SELECT 1 FROM scan_details WHERE id BETWEEN ?1 << 32 "
                "AND ?1 << 32 | 4294967295)");
  any.bind(1, id);
  any.executeStep();
  return any.getColumn(0).getInt() != 0;
}

/// The join is half of the time, and few tests need it.
std::string select_rows(std::span<const std::size_t> columns, bool with_details) {
  std::string sql = "SELECT s.id & 4294967295";
  for (const std::size_t column : columns) {
    const ReadColumn& read = read_columns()[column];
    sql +=
        ", " + (with_details && !read.sql_with_details.empty() ? read.sql_with_details : read.sql);
  }
  sql += " FROM scans s ";
  if (with_details) sql += "LEFT JOIN scan_details d ON d.id = s.id ";
  return sql + "WHERE s.id BETWEEN ?1 << 32 | ?2 AND ?1 << 32 | 4294967295 ORDER BY s.id";
}

/// Oldest first; the tests of a sweep together, in its order.
constexpr const char* kAllTests =
    "WITH places AS (SELECT DISTINCT test_id, sweep, place FROM sweep_members), "
    "firsts AS (SELECT sweep, min(test_id) AS first FROM places GROUP BY sweep) "
    "SELECT t.id FROM tests t LEFT JOIN places p ON p.test_id = t.id "
    "LEFT JOIN firsts f ON f.sweep = p.sweep "
    "ORDER BY coalesce(f.first, t.id), p.place, t.id";

void read_row(const PlainStatement& row, ScanRow& scan) {
  int column = 0;
  scan.number = row.integer(column++) & 0xffffffff;
  scan.time_s = row.number(column++);
  scan.stage = static_cast<int>(row.integer(column++));
  for (double& value : scan.raw) value = row.number(column++);
  scan.axial_strain = row.number(column++);
  scan.volumetric_strain = row.number(column++);
  scan.q_pa = row.number(column++);
  scan.p_eff_pa = row.number(column++);
  scan.last_bits = row.integer(column++);
  if constexpr (kAddedChannelCount > 0) scan.added_last_bits = row.integer(column);
}

/// The columns of scan_details from its id on; false where the scan has none.
bool read_detail(const PlainStatement& row, ScanDetail& detail) {
  auto column = static_cast<int>(scan_columns().size());
  if (row.is_null(column++)) return false;
  for (double& value : detail.given) value = row.number(column++);
  detail.given_last_bits = row.integer(column++);
  for (double& value : detail.state_si) value = row.number(column++);
  detail.state_missing = row.integer(column);
  return true;
}

template <class Use>
void visit_scans(SQLite::Database& database, std::int64_t id, std::int64_t every,
                 std::pair<std::int64_t, std::int64_t> readings, const Use& use) {
  const auto references = stage_references(database, id);
  PlainStatement row(database, select_scans(database).c_str());
  row.bind(1, id);
  row.bind(2, every);
  row.bind(3, readings.first);
  row.bind(4, readings.second);
  ScanRow scan;
  ScanDetail detail;
  lab::Reading reading;
  lab::State state;
  while (row.step()) {
    read_row(row, scan);
    const bool detailed = read_detail(row, detail);
    const auto reference = references.find(scan.stage);
    decode(scan, detailed ? &detail : nullptr,
           reference == references.end() ? StageReference{} : reference->second, reading, state);
    use(reading, state);
  }
}

}  // namespace

std::string describe_missing_tests(const std::vector<std::int64_t>& ids) {
  return fmt::format("{} {} not exist; `triax tests` lists all tests",
                     ids.size() == 1 ? fmt::format("test {}", ids.front())
                                     : fmt::format("tests {}", fmt::join(ids, ", ")),
                     ids.size() == 1 ? "does" : "do");
}

std::string_view to_string(TestStatus status) {
  switch (status) {
    case TestStatus::running:
      return "running";
    case TestStatus::complete:
      return "complete";
    case TestStatus::interrupted:
      return "interrupted";
  }
  return {};
}

TestStatus status_of(std::string_view text) {
  for (const auto status : {TestStatus::running, TestStatus::complete})
    if (to_string(status) == text) return status;
  return TestStatus::interrupted;
}

struct Store::Impl {
  explicit Impl(const std::string& file)
      : path(file), own(open_for_reading(file)), database(*own) {}
  Impl(std::string file, SQLite::Database& open) : path(std::move(file)), database(open) {}

  /// Runs `work`; what SQLite says becomes an error that names the file.
  template <class Work>
  auto guarded(const Work& work) {
    try {
      return work();
    } catch (const SQLite::Exception& error) {
      throw_for(error, path);
    }
  }

  [[noreturn]] void no_test(std::int64_t id) const {
    throw lab::BadInput(path, 0, describe_missing_tests({id}));
  }
  std::int64_t find_one(const std::string& name) const;
  std::int64_t find_by_short_name(const std::string& name) const;
  /// For messages: of the last twenty tests.
  std::vector<std::string> latest_names() const;

  std::string path;
  std::optional<SQLite::Database> own;
  SQLite::Database& database;
};

std::int64_t Store::Impl::find_one(const std::string& name) const {
  // A test that is called "42" is meant rather than the forty-second of the database.
  Statement select(database,
                   "SELECT id FROM tests WHERE name = ?1 OR id = ?2 "
                   "ORDER BY name = ?1 DESC, id DESC LIMIT 1");
  select.bind(1, name);
  select.bind(2, lab::whole_text_as<std::int64_t>(name).value_or(0));
  return select.executeStep() ? select.getColumn(0).getInt64() : find_by_short_name(name);
}

/// "csu_26" and "26" for "CSU 26", as long as no other name may be meant.
std::int64_t Store::Impl::find_by_short_name(const std::string& name) const {
  Statement select(database,
                   "SELECT id, name FROM tests "
                   "WHERE lower(replace(name, '_', ' ')) = lower(replace(?1, '_', ' ')) "
                   "OR substr(name, -length(?1) - 1) = ' ' || ?1 ORDER BY id DESC");
  select.bind(1, name);
  std::int64_t latest = 0;
  std::string called;
  while (select.executeStep()) {
    const std::string other = select.getColumn(1).getString();
    if (latest != 0 && other != called)
      throw lab::BadInput(
          path, 0,
          fmt::format("test '{}' is ambiguous: '{}' or '{}'; give the full name or the number",
                      name, called, other));
    if (latest == 0) latest = select.getColumn(0).getInt64();
    called = other;
  }
  if (latest != 0) return latest;
  const auto names = latest_names();
  throw lab::BadInput(
      path, 0,
      fmt::format("test {} does not exist; {}", lab::excerpt(name),
                  names.empty() ? "the database has no tests" : lab::suggestion(name, names)));
}

std::vector<std::string> Store::Impl::latest_names() const {
  Statement select(database, "SELECT name FROM tests GROUP BY name ORDER BY max(id) DESC LIMIT 20");
  std::vector<std::string> names;
  while (select.executeStep()) names.push_back(select.getColumn(0).getString());
  return names;
}

Store::Store(const std::string& path) : impl_(std::make_unique<Impl>(path)) {}
Store::Store(const std::string& path, SQLite::Database& database)
    : impl_(std::make_unique<Impl>(path, database)) {}
Store::~Store() = default;

std::vector<std::int64_t> Store::find(const std::vector<std::string>& names) const {
  return impl_->guarded([&] {
    std::vector<std::int64_t> ids;
    ids.reserve(names.size());
    for (const std::string& name : names) ids.push_back(impl_->find_one(name));
    if (!names.empty()) return ids;
    Statement select(impl_->database, kAllTests);
    while (select.executeStep()) ids.push_back(select.getColumn(0).getInt64());
    return ids;
  });
}

StoredTest Store::load(std::int64_t id) const {
  return impl_->guarded([&] {
    StoredTest test = read_test(impl_->database, id);
    if (test.id == 0) impl_->no_test(id);
    if (const auto missing = missing_readings(impl_->database, id))
      test.summary.warnings.push_back({0, in_words(*missing) + "; its result was found with them"});
    if (const auto& onset = test.summary.collapse.onset)
      test.state_at_onset = state_at(id, onset->reading);
    return test;
  });
}

TestVersion Store::version(std::int64_t id) const {
  return impl_->guarded([&] {
    std::optional<TestVersion> found;
    for_rows(impl_->database, id,
             "SELECT s.status, t.stored_at, t.digest, s.readings, "
             "1 + (SELECT count(*) FROM revisions r WHERE r.test_id = t.id) "
             "FROM tests t JOIN seen_tests s ON s.test_id = t.id WHERE t.id = ?",
             [&found](Columns& c) {
               found.emplace();
               found->status = status_of(c.text());
               found->stored_at = c.text();
               found->digest = c.text();
               found->readings = c.integer().value_or(0);
               found->revision = c.integer().value_or(1);
             });
    if (!found) impl_->no_test(id);
    return *found;
  });
}

void Store::for_each_scan(
    std::int64_t id, std::int64_t every,
    const std::function<void(const lab::Reading&, const lab::State&)>& use) const {
  impl_->guarded([&] {
    visit_scans(impl_->database, id, std::max<std::int64_t>(every, 1), {0, kLastReading}, use);
  });
}

void Store::for_each_row(
    std::int64_t id, std::int64_t from, std::span<const std::size_t> columns,
    const std::function<void(std::int64_t, std::span<const double>)>& use) const {
  impl_->guarded([&] {
    const bool details =
        std::ranges::any_of(
            columns, [](std::size_t c) { return !read_columns()[c].sql_with_details.empty(); }) &&
        has_details(impl_->database, id);
    PlainStatement row(impl_->database, select_rows(columns, details).c_str());
    row.bind(1, id);
    row.bind(2, std::max<std::int64_t>(from, 0));
    std::vector<double> values(columns.size());
    while (row.step()) {
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = row.number(static_cast<int>(i) + 1);
      use(row.integer(0), values);
    }
  });
}

void Store::for_each_scan_from(
    std::int64_t id, std::int64_t from,
    const std::function<void(const lab::Reading&, const lab::State&)>& use) const {
  impl_->guarded([&] {
    visit_scans(impl_->database, id, 1, {std::max<std::int64_t>(from, 0), kLastReading}, use);
  });
}

std::optional<lab::State> Store::state_at(std::int64_t id, std::int64_t reading) const {
  return impl_->guarded([&] {
    std::optional<lab::State> found;
    if (reading >= 0 && reading <= kLastReading)
      visit_scans(impl_->database, id, 1, {reading, reading},
                  [&](const lab::Reading&, const lab::State& state) { found = state; });
    return found;
  });
}

std::vector<lab::Reading> Store::readings(std::int64_t id, std::int64_t from,
                                          std::int64_t count) const {
  return impl_->guarded([&] {
    std::vector<lab::Reading> found;
    visit_scans(impl_->database, id, 1, {std::max<std::int64_t>(from, 0), from + count - 1},
                [&](const lab::Reading& reading, const lab::State&) { found.push_back(reading); });
    return found;
  });
}

std::int64_t Store::scan_count(std::int64_t id) const {
  return impl_->guarded([&] {
    Statement count(impl_->database,
                    "SELECT count(*) FROM scans WHERE id BETWEEN ?1 << 32 "
                    "AND ?1 << 32 | 4294967295");
    count.bind(1, id);
    count.executeStep();
    return count.getColumn(0).getInt64();
  });
}

std::vector<lab::SecondOrderWorkPoint> Store::second_order_work(std::int64_t id) const {
  return impl_->guarded([&] {
    PlainStatement row(impl_->database,
                       "SELECT id & 4294967295, time_s, small_strain, eulerian, semi_lagrangian, "
                       "normalised, normalised_error, window_readings, axial_strain_path "
                       "FROM work_points "
                       "WHERE id BETWEEN ?1 << 32 AND ?1 << 32 | 4294967295 ORDER BY id");
    row.bind(1, id);
    std::vector<lab::SecondOrderWorkPoint> points;
    while (row.step()) {
      lab::SecondOrderWorkPoint& point = points.emplace_back();
      point.reading = row.integer(0);
      point.time_s = row.number(1);
      point.work = {row.number(2), row.number(3), row.number(4), row.number(5)};
      point.normalised_error = row.number(6);
      point.window_readings = row.integer(7);
      point.axial_strain_path = row.number(8);
    }
    return points;
  });
}

std::vector<lab::Forecast> Store::forecasts(std::int64_t id) const {
  return impl_->guarded([&] { return read_forecasts(impl_->database, id); });
}

}  // namespace triax::db
