// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/catalogue.hpp"

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "db/columns.hpp"
#include "db/connection.hpp"
#include "db/test_reader.hpp"
#include "db/test_writer.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::db {
namespace {

using SQLite::Statement;

constexpr const char* kListed =
    "SELECT t.id, t.name, t.origin, t.programme, s.status, s.last_sign_of_life, s.silent_s, "
    "v.kind, "
    "s.readings, t.stored_at, t.source, t.digest, "
    "t.id IN (SELECT test_id FROM counted_tests), "
    "1 + (SELECT count(*) FROM revisions r WHERE r.test_id = t.id) "
    "FROM tests t JOIN seen_tests s ON s.test_id = t.id "
    "LEFT JOIN verdicts v ON v.test_id = t.id "
    "WHERE ?1 = '' OR EXISTS (SELECT 1 FROM tags g WHERE g.test_id = t.id AND g.tag = ?1) "
    "ORDER BY t.id";

ListedTest listed(Columns c) {
  ListedTest test;
  test.id = c.integer().value_or(0);
  test.name = c.text();
  test.origin = c.text() == "simulated" ? lab::Origin::simulated : lab::Origin::recorded;
  test.programme = c.text();
  test.status = status_of(c.text());
  test.sign_of_life = sign_of_life(c);
  test.kind = lab::collapse_kind_from(c.text());
  test.readings = c.integer().value_or(0);
  test.stored_at = c.text();
  test.source = c.text();
  test.digest = c.text();
  test.counted = c.truth().value_or(true);
  test.revision = c.integer().value_or(1);
  return test;
}

std::vector<std::string> tags_of(SQLite::Database& database, std::int64_t id) {
  Statement select(database, "SELECT tag FROM tags WHERE test_id = ? ORDER BY tag");
  select.bind(1, id);
  std::vector<std::string> tags;
  while (select.executeStep()) tags.push_back(select.getColumn(0).getString());
  return tags;
}

std::vector<ListedTest> all_listed(SQLite::Database& database, const std::string& tag) {
  std::vector<ListedTest> tests;
  Statement select(database, kListed);
  select.bind(1, tag);
  while (select.executeStep()) tests.push_back(listed(Columns(select)));
  for (ListedTest& test : tests) test.tags = tags_of(database, test.id);
  return tests;
}

/// Runs `work` in one transaction of a database that is there.
template <class Work>
auto change(const std::string& path, const Work& work) {
  check_there(path);
  try {
    SQLite::Database database = open_for_writing(path);
    SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
    auto result = work(database);
    transaction.commit();
    return result;
  } catch (const SQLite::Exception& error) {
    throw_for(error, path);
  }
}

std::string one_line(const std::string& text, const char* what) {
  std::string line(lab::trimmed(text));
  if (line.empty()) throw lab::BadInput(fmt::format("the {0} is empty; give a {0}", what));
  const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
  if (!lab::is_utf8(line) || std::ranges::any_of(line, is_control))
    throw lab::BadInput(
        fmt::format("the {} {} must be one line of UTF-8 text", what, lab::excerpt(line)));
  return line;
}

std::vector<std::string> each_one_line(const std::vector<std::string>& tags) {
  std::vector<std::string> lines;
  lines.reserve(tags.size());
  for (const std::string& tag : tags) lines.push_back(one_line(tag, "tag"));
  return lines;
}

[[noreturn]] void no_such_test(const std::string& path, const std::vector<std::int64_t>& ids) {
  throw lab::BadInput(path, 0, describe_missing_tests(ids));
}

/// The writer that has a lease of a test that is marked as running; empty where there is none.
std::string running_writer(SQLite::Database& database, std::int64_t id) {
  Statement select(database,
                   "SELECT l.writer FROM leases l JOIN tests t ON t.id = l.test_id "
                   "WHERE t.id = ? AND t.status = 'running'");
  select.bind(1, id);
  return select.executeStep() ? select.getColumn(0).getString() : std::string();
}

std::string name_of(SQLite::Database& database, const std::string& path, std::int64_t id) {
  Statement select(database, "SELECT name FROM tests WHERE id = ?");
  select.bind(1, id);
  if (!select.executeStep()) no_such_test(path, {id});
  return select.getColumn(0).getString();
}

/// Runs a statement on (test_id, tag).
void run_on_tag(SQLite::Database& database, const char* sql, std::int64_t id,
                const std::string& tag) {
  Statement statement(database, sql);
  statement.bind(1, id);
  statement.bind(2, tag);
  statement.exec();
}

[[noreturn]] void no_such_tag(const std::vector<std::string>& tags, std::int64_t id,
                              const std::string& tag) {
  throw lab::BadInput(tags.empty()
                          ? fmt::format("test {} has no tag {}; it has none", id, lab::excerpt(tag))
                          : fmt::format("test {} has no tag {}; {}", id, lab::excerpt(tag),
                                        lab::suggestion(tag, tags)));
}

}  // namespace

std::vector<ListedTest> list_tests(const std::string& path, const std::string& tag) {
  SQLite::Database database = open_for_reading(path);
  try {
    SQLite::Transaction one_state_of_it(database);
    return all_listed(database, tag);
  } catch (const SQLite::Exception& error) {
    throw_for(error, path);
  }
}

std::string rename_test(const std::string& path, std::int64_t id, const std::string& name) {
  const std::string line = one_line(name, "name");
  return change(path, [&](SQLite::Database& database) {
    std::string before = name_of(database, path, id);
    Statement update(database, "UPDATE tests SET name = ? WHERE id = ?");
    Binder(update).text(line).integer(id).run();
    return before;
  });
}

void tag_test(const std::string& path, std::int64_t id, const std::vector<std::string>& tags) {
  const auto lines = each_one_line(tags);
  change(path, [&](SQLite::Database& database) {
    name_of(database, path, id);
    for (const std::string& tag : lines)
      run_on_tag(database, "INSERT OR IGNORE INTO tags (test_id, tag) VALUES (?, ?)", id, tag);
    return true;
  });
}

void untag_test(const std::string& path, std::int64_t id, const std::vector<std::string>& tags) {
  const auto lines = each_one_line(tags);
  const std::set<std::string> each_once(lines.begin(), lines.end());
  change(path, [&](SQLite::Database& database) {
    name_of(database, path, id);
    const auto present = tags_of(database, id);
    for (const std::string& tag : each_once) {
      if (std::ranges::find(present, tag) == present.end()) no_such_tag(present, id, tag);
      run_on_tag(database, "DELETE FROM tags WHERE test_id = ? AND tag = ?", id, tag);
    }
    return true;
  });
}

std::vector<ListedTest> remove_tests(const std::string& path, const std::vector<std::int64_t>& ids,
                                     const std::set<std::string>& silent) {
  return change(path, [&](SQLite::Database& database) {
    std::set<std::int64_t> wanted(ids.begin(), ids.end());
    std::vector<ListedTest> tests;
    for (ListedTest& test : all_listed(database, {}))
      if (wanted.erase(test.id) > 0) tests.push_back(std::move(test));
    if (!wanted.empty()) no_such_test(path, {wanted.begin(), wanted.end()});
    for (const ListedTest& test : tests) {
      const std::string writer = running_writer(database, test.id);
      if (!writer.empty() && !silent.contains(writer))
        throw lab::BadInput(
            path, 0,
            fmt::format("test {} {} is still being recorded; remove it when it has ended, nothing "
                        "was removed",
                        test.id, lab::excerpt(test.name)));
    }
    for (const ListedTest& test : tests) remove_test(database, test.id);
    return tests;
  });
}

}  // namespace triax::db
