// SPDX-License-Identifier: GPL-3.0-or-later
// newest_schema OUT.sql MIGRATION.sql...: what the migrations come to, for a new database to be
// made in one step. Run by the build.
#include <sqlite3.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>

namespace {

[[noreturn]] void fail(const std::string& what) {
  std::cerr << "newest_schema: " << what << '\n';
  std::exit(1);
}

int write_row(void* out, int, char** cells, char**) {
  *static_cast<std::string*>(out) += std::string(cells[0]) + ";\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) fail("OUT.sql MIGRATION.sql... are asked");
  sqlite3* opened = nullptr;
  if (sqlite3_open(":memory:", &opened) != SQLITE_OK) fail("no memory");
  const std::unique_ptr<sqlite3, int (*)(sqlite3*)> database(opened, sqlite3_close);
  const auto run = [&](const std::string& sql, const std::string& where, std::string* out) {
    const auto row = out == nullptr ? nullptr : write_row;
    if (sqlite3_exec(database.get(), sql.c_str(), row, out, nullptr) != SQLITE_OK)
      fail(where + ": " + sqlite3_errmsg(database.get()));
  };
  for (int i = 2; i < argc; ++i) {
    std::ifstream file(argv[i]);
    run({std::istreambuf_iterator<char>(file), {}}, argv[i], nullptr);
  }
  std::string schema;
  run("SELECT sql FROM sqlite_schema WHERE sql IS NOT NULL AND name NOT LIKE 'sqlite_%' ORDER BY "
      "rowid",
      "schema", &schema);
  if (!(std::ofstream(argv[1]) << schema).flush())
    fail(std::string(argv[1]) + " cannot be written");
}
