// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/report.hpp"

#include <fmt/format.h>

#include <CLI/Validators.hpp>
#include <filesystem>
#include <memory>
#include <set>

#include "db/choice/test_choice.hpp"
#include "db/grain_store.hpp"
#include "db/store.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/grains/grain_figure_folder.hpp"
#include "src/grains/grain_json.hpp"
#include "src/grains/grain_markup.hpp"
#include "src/grains/grain_text.hpp"
#include "src/output/notice.hpp"
#include "src/output/output.hpp"
#include "src/output/table.hpp"
#include "src/study/triaxial/collapse_increments.hpp"
#include "src/triaxial/figure_folder.hpp"
#include "src/triaxial/figures/few_states.hpp"
#include "src/triaxial/html_report.hpp"
#include "src/triaxial/json_report.hpp"
#include "src/triaxial/left_waiting.hpp"
#include "src/triaxial/pdf_report.hpp"
#include "src/triaxial/print_tests.hpp"
#include "src/triaxial/report_choice.hpp"
#include "src/triaxial/sheet/sheet_json.hpp"
#include "src/triaxial/text_report.hpp"

namespace triax::src {
namespace {

struct ReportOptions {
  std::vector<std::string> tests;
  std::string db = "triax.db";
  std::string format;  ///< empty: what the ending of --output says, or text
  std::string output;
  std::string figures;
  bool live = false;
  std::string where, type, sweep;  ///< which tests; empty: all that are named
  std::string failure = "peak-q";
  double failure_strain_pct = 15;
  std::vector<std::string> sets;
  bool each = false, evidence = false;
  bool has_sheet_words = false;  ///< --failure, --failure-strain or --set was given
};

/// The ending of the file, where it is that of a format.
std::string format_of_ending(const std::string& output) {
  const std::string ending = std::filesystem::path(output).extension().string();
  for (const char* format : {"json", "html", "pdf"})
    if (ending == std::string(".") + format) return format;
  return {};
}

std::string chosen_format(const ReportOptions& o) {
  const std::string ending = format_of_ending(o.output);
  if (o.format.empty()) return ending.empty() ? "text" : ending;
  if (!ending.empty() && ending != o.format)
    throw lab::BadInput(
        fmt::format("--output {} would contain {}, which does not match its extension: leave "
                    "--format out, or give the file another extension",
                    o.output, o.format));
  return o.format;
}

std::string in_sql(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + '\'';
}

/// Those of `ids` that the filters leave, in their order.
std::vector<std::int64_t> filtered(const ReportOptions& o, const std::vector<std::int64_t>& ids) {
  std::vector<std::string> conditions;
  if (!o.where.empty()) conditions.push_back("(" + o.where + ")");
  if (!o.type.empty()) conditions.push_back("programme = " + in_sql(o.type));
  if (!o.sweep.empty()) conditions.push_back("sweep = " + in_sql(o.sweep));
  std::set<std::int64_t> chosen;
  for (const auto& test :
       db::choose_tests(o.db, fmt::format("{}", fmt::join(conditions, " AND ")), ""))
    chosen.insert(test.id);
  std::vector<std::int64_t> left;
  for (const auto id : ids)
    if (chosen.contains(id)) left.push_back(id);
  if (left.empty())
    throw lab::BadInput(
        fmt::format("no test matches {}; `triax tests list` shows all tests",
                    lab::joined({o.where.empty() ? "" : "--where", o.type.empty() ? "" : "--type",
                                 o.sweep.empty() ? "" : "--sweep"},
                                " and ")));
  return left;
}

bool has_filter(const ReportOptions& o) {
  return !o.where.empty() || !o.type.empty() || !o.sweep.empty();
}

SheetRequest sheet_request(const ReportOptions& o) {
  SheetRequest request;
  request.options.failure = study::failure_criterion(o.failure);
  request.options.failure_strain = o.failure_strain_pct / 100;
  for (const auto& [key, value] : key_values(o.sets, "borehole=B3"))
    request.said.push_back(study::said_word(key, value));
  return request;
}

/// All that is reported.
struct Reported {
  std::vector<study::TestResult> tests;
  std::vector<db::StoredGrainRun> runs;
};

study::Json document_of(const SheetTest& test) {
  auto document = test_document(test.result.stored);
  document["sheet"] = sheet_json(test);
  return document;
}

/// With what their sheets say, where sheets were asked for.
std::string json(const Reported& all, const std::vector<SheetTest>& sheets) {
  if (all.runs.empty() && sheets.empty()) return json_report(all.tests);
  if (all.runs.empty() && sheets.size() == 1)
    return study::json_document(document_of(sheets.front()));
  if (all.tests.empty() && sheets.empty() && all.runs.size() == 1)
    return grain_run_json(all.runs.front());
  std::vector<std::string> documents;
  documents.reserve(sheets.size());
  for (const auto& sheet : sheets) documents.push_back(study::json_document(document_of(sheet)));
  if (sheets.empty())
    for (const auto& test : all.tests) documents.push_back(json_of_test(test) + '\n');
  for (const auto& run : all.runs) documents.push_back(grain_run_json(run));
  std::string out = "[\n";
  for (auto& document : documents) {
    document = indented(document);
    document.pop_back();
    out += document + (&document == &documents.back() ? "\n" : ",\n");
  }
  return out + "]\n";
}

std::string text(const Reported& all) {
  if (all.runs.empty()) return text_for_people(all.tests);
  const std::string runs = grain_runs_text(all.runs);
  return all.tests.empty() ? runs : text_for_people(all.tests) + '\n' + runs;
}

/// Of many tests few states stay in memory; each is loaded again for its own page.
ReportSheets sheets_of(const db::Store& store, const std::vector<std::int64_t>& ids,
                       const ReportOptions& o) {
  ReportSheets sheets{.tests = {}, .each = o.each, .evidence = o.evidence};
  const auto request = sheet_request(o);
  const bool many = ids.size() > ReportSheets::kMostSheets;
  for (const auto id : ids) {
    sheets.tests.push_back(load_sheet_test(store, id, request));
    if (many) keep_few_states(sheets.tests.back().result);
  }
  if (many)
    sheets.whole = [&store, request](const SheetTest& test) {
      return load_sheet_test(store, test.result.stored.id, request);
    };
  return sheets;
}

void write_figures(const db::Store& store, const std::vector<std::int64_t>& ids,
                   const std::vector<db::StoredGrainRun>& runs, const ReportOptions& o) {
  FigureFolder figures(o.figures);
  const auto request = sheet_request(o);
  for (const auto id : ids) figures.add(load_sheet_test(store, id, request));
  figures.finish(study::collapse_increments(store, ids));
  write_grain_figures(runs, o.figures);
}

void write_pages(const std::string& format, const ReportSheets& sheets,
                 const std::vector<db::StoredGrainRun>& runs, const std::string& output) {
  if (!sheets.has_page_of_each())
    notify(fmt::format("{} tests: only pages of sets; use --each for a page of each test",
                       sheets.tests.size()));
  if (format == "pdf")
    pdf_report(sheets, output, grain_pages(runs));
  else
    write_file(output, html_report(sheets, grain_html(runs)));
}

void run_report(const ReportOptions& o) {
  const std::string format = chosen_format(o);
  const bool drawn = format == "html" || format == "pdf";
  const std::string output = !o.output.empty() ? o.output : drawn ? "triax_report." + format : "-";
  refuse_overwriting("--output", output, database_files(o.db), "the database");
  const db::Store store(o.db);
  tell_of_gaps(o.db);
  if (o.live) {
    if (drawn) throw lab::BadInput("--live needs --format text or json, not " + format);
    return write_file(output, live_document(o.db, store.find(o.tests), format == "json"));
  }
  const db::GrainStore grains(o.db);
  auto [ids, run_ids] = report_choice(store, grains, o.tests);
  if (has_filter(o)) {
    ids = filtered(o, ids);
    if (o.tests.empty()) run_ids.clear();
  }
  Reported all;
  for (const auto id : run_ids) all.runs.push_back(grains.load(id));
  if (!o.figures.empty()) {
    write_figures(store, ids, all.runs, o);
    if (format == "text" && o.output.empty()) return;
  }
  if (drawn) return write_pages(format, sheets_of(store, ids, o), all.runs, output);
  ReportSheets sheets;
  if (format == "json" && o.has_sheet_words)
    sheets = sheets_of(store, ids, o);
  else
    for (const auto id : ids)
      all.tests.push_back(study::load_test_result(store, id, study::WithCurves::no));
  write_file(output, format == "json" ? json(all, sheets.tests) : text(all));
}

void add_choice(CLI::App& app, ReportOptions& o) {
  app.add_option("--where", o.where,
                 "only tests that match this SQL condition; columns as in triax soil --where")
      ->type_name("SQL");
  app.add_option("--type", o.type, "only tests of this type, such as ICU or CSD")
      ->type_name("TYPE");
  app.add_option("--sweep", o.sweep, "only tests of this sweep")->type_name("NAME");
}

void add_sheet_options(CLI::App& app, ReportOptions& o) {
  app.add_option("--failure", o.failure,
                 "failure criterion of test reports: largest q, largest s1'/s3', strain of "
                 "--failure-strain, or the critical state if it was reached")
      ->type_name("peak-q|peak-ratio|strain|critical-state")
      ->check(CLI::IsMember({"peak-q", "peak-ratio", "strain", "critical-state"}).description(""))
      ->capture_default_str();
  app.add_option("--failure-strain", o.failure_strain_pct,
                 "axial strain of --failure strain, in percent")
      ->type_name("PERCENT")
      ->check(CLI::Range(0.1, 50.0).description(""))
      ->capture_default_str();
  app.add_option("--set", o.sets,
                 "field of the test report that the record lacks: project, borehole, depth, "
                 "operator, drained_at, side_drains, load_cell, remarks, ...; TEST/KEY=VALUE for "
                 "one test (repeatable)")
      ->type_name("KEY=VALUE");
  app.add_flag("--each", o.each, "write a page for each test, however many there are");
  app.add_flag("--evidence", o.evidence,
               "add criteria, events, checks and histories to the page of each test");
}

}  // namespace

Command report_command() {
  return {
      .name = "report",
      .purpose = "Report tests as text, JSON, HTML or PDF",
      .description =
          {"Reports the named tests and grain runs of the database, or all of them. A test is "
           "named by its number or its name, a grain run by its name or by grains:NUMBER. If "
           "several have the same name, the latest is used.",
           "HTML and PDF are test reports: one A4 page for each test, and one for each set of "
           "tests on the same soil. They contain the heading, specimen, saturation, consolidation "
           "with t100 and c_v, rate, failure, corrections, the assessment of collapse, deviations "
           "from ISO 17892-9, ASTM D4767 and D7181 and BS 1377-8, and figures. The page of a set "
           "has Mohr circles with c' and phi'. With more than 24 tests, only the sets have pages. "
           "Fields without a value are left empty for filling in by hand; --set fills them.",
           "A test of type UU, UUM or UNC has a test report in total stresses after ISO 17892-8, "
           "with c_u = q_f/2. JSON contains the values of the test report as member \"sheet\" if "
           "--failure, --failure-strain or --set is given.",
           "The extension of --output selects the format unless --format is given. Without "
           "--output, HTML and PDF are written to triax_report.html or triax_report.pdf in the "
           "current folder, and text and JSON to standard output.",
           "--figures writes each figure of a report, and the figures that compare all tests of a "
           "type, to a folder as SVG, PNG and PDF. Figures of grain runs include their data. "
           "Nothing else is written without --format and --output."},
      .diagnostics = {{"FILE: database does not exist; ...",
                       "correct --db, or create the database with triax simulate, run or replay"},
                      {"no test matches ...",
                       "correct --where, --type or --sweep, or name other tests"}},
      .examples = {{"triax report", "report all tests and grain runs as text"},
                   {"triax report csu_26 --output csu_26.html",
                    "write the test report of one test"},
                   {"triax report 1 2 3 --output set.pdf --failure peak-ratio --set borehole=B3",
                    "write the test reports of a set and of its tests"},
                   {"triax report --sweep densities --output sweep.pdf",
                    "report all tests of a sweep (above 24 tests: only pages of the sets)"},
                   {"triax report csu_26 --live",
                    "list what was reported during the test, and when"},
                   {"triax report 1 2 3 --format json", "print three tests as one JSON document"},
                   {"triax report grains:1 --format html", "report a grain run with its figures"},
                   {"triax report --figures pictures",
                    "write the figures of all tests and grain runs to a folder"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<ReportOptions>();
        app.add_option("TEST", o->tests,
                       "tests, by number or name; grain runs as grains:NUMBER [all]")
            ->type_name("");
        add_db(app, o->db);
        add_format(app, o->format, {"text", "json", "html", "pdf"});
        o->format.clear();
        app.add_option("--output", o->output,
                       "file to write; its extension .json, .html or .pdf selects the format")
            ->type_name("FILE");
        add_choice(app, *o);
        add_sheet_options(app, *o);
        add_live(app, o->live);
        app.add_option("--figures", o->figures, "write the figures to FOLDER")->type_name("FOLDER");
        return [o, &app] {
          for (const char* option : {"--failure", "--failure-strain", "--set"})
            o->has_sheet_words = o->has_sheet_words || app.count(option) > 0;
          run_report(*o);
        };
      }};
}

}  // namespace triax::src
