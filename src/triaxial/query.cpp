// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/query.hpp"

#include "db/query.hpp"

#include <CLI/Validators.hpp>
#include <memory>

#include "src/cli/shared_options.hpp"
#include "src/output/result_writer.hpp"
#include "src/triaxial/left_waiting.hpp"

namespace triax::src {
namespace {

struct QueryOptions {
  std::string text;
  std::string db = "triax.db";
  std::string format = "text";
  bool list = false;
  double time_limit_s = db::kQueryLimit_s;
};

void list_queries(ResultWriter& writer) {
  writer.columns({"query", "answers"});
  for (const auto& query : db::named_queries())
    writer.row({std::string(query.name), std::string(query.purpose)});
  writer.finish();
}

void run_query(const QueryOptions& o) {
  const auto writer = make_result_writer(o.format);
  if (o.list || o.text.empty()) return list_queries(*writer);
  db::query(
      o.db, o.text, [&](const std::vector<std::string>& columns) { writer->columns(columns); },
      [&](const std::vector<db::Value>& row) { writer->row(row); }, o.time_limit_s);
  writer->finish();
  tell_of_gaps(o.db);
}

}  // namespace

Command query_command() {
  return {
      .name = "query",
      .purpose = "Query the database with named queries or SQL (read-only)",
      .description =
          {"Without an argument, or with --list, the named queries are listed. An argument that is "
           "not one of their names is run as SQL. The database is opened read-only.",
           "The table tests and the views readings, states, second_order_work, collapses and "
           "collapse_points all have the column test_id. The names of the columns include their "
           "units."},
      .diagnostics = {{"FILE: database does not exist; ...",
                       "correct --db, or create the database with triax simulate, run or replay"},
                      {"SQL: no such column: ...", "correct the SQL; the message is from SQLite"},
                      {"SQL: this statement would change the database; ...",
                       "use only SELECT and harmless PRAGMA statements"},
                      {"the query did not finish within S s; ...",
                       "simplify the query, or allow more time with --time-limit"}},
      .examples =
          {{"triax query collapse_points",
            "print the table of collapse points, like Table 2 of Darve et al. (2007)"},
           {"triax query \"SELECT reading, q_kPa FROM states WHERE test_id = 1\" --format csv",
            "print the readings of one test for a spreadsheet"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<QueryOptions>();
        app.add_option("NAME|SQL", o->text, "name of a query, or SQL")->type_name("");
        add_db(app, o->db);
        add_format(app, o->format, {"text", "csv", "json"});
        app.add_option("--time-limit", o->time_limit_s, "stop a query after S seconds")
            ->check(CLI::Range(0.001, 1e6).description(""))
            ->type_name("S")
            ->capture_default_str();
        app.add_flag("--list", o->list, "list the named queries");
        return [o] { run_query(*o); };
      }};
}

}  // namespace triax::src
