// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/report.hpp"

#include <filesystem>
#include <memory>

#include "db/grain_store.hpp"
#include "db/store.hpp"
#include "lab/base/bad_input.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/grains/grain_figure_folder.hpp"
#include "src/grains/grain_json.hpp"
#include "src/grains/grain_markup.hpp"
#include "src/grains/grain_text.hpp"
#include "src/output/output.hpp"
#include "src/output/table.hpp"
#include "src/study/triaxial/collapse_increments.hpp"
#include "src/triaxial/figure_folder.hpp"
#include "src/triaxial/html_report.hpp"
#include "src/triaxial/json_report.hpp"
#include "src/triaxial/left_waiting.hpp"
#include "src/triaxial/pdf_report.hpp"
#include "src/triaxial/print_tests.hpp"
#include "src/triaxial/report_choice.hpp"
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
};

std::string chosen_format(const ReportOptions& o) {
  if (!o.format.empty()) return o.format;
  const std::string ending = std::filesystem::path(o.output).extension().string();
  for (const char* format : {"json", "html", "pdf"})
    if (ending == std::string(".") + format) return format;
  return "text";
}

/// All that is reported.
struct Reported {
  std::vector<study::TestResult> tests;
  std::vector<db::StoredGrainRun> runs;
};

std::string json(const Reported& all) {
  if (all.runs.empty()) return json_report(all.tests);
  if (all.tests.empty() && all.runs.size() == 1) return grain_run_json(all.runs.front());
  std::vector<std::string> documents;
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

void write(const std::string& format, const Reported& all, const std::string& output) {
  if (format == "pdf")
    pdf_report(all.tests, output, grain_pages(all.runs));
  else if (format == "html")
    write_file(output, html_report(all.tests, grain_html(all.runs)));
  else
    write_file(output, format == "json" ? json(all) : text(all));
}

void run_report(const ReportOptions& o) {
  const std::string format = chosen_format(o);
  const bool drawn = format == "html" || format == "pdf";
  const std::string output = !o.output.empty() ? o.output : drawn ? "triax_report." + format : "-";
  refuse_overwriting("--output", output, database_files(o.db), "the database");
  const db::Store store(o.db);
  tell_of_what_waits(o.db);
  if (o.live) {
    if (drawn) throw lab::BadInput("--live is told as text or JSON, not as " + format);
    return write_file(output, live_document(o.db, store.find(o.tests), format == "json"));
  }
  const db::GrainStore grains(o.db);
  const auto [ids, run_ids] = report_choice(store, grains, o.tests);
  const auto curves = drawn || !o.figures.empty() ? study::WithCurves::yes : study::WithCurves::no;
  Reported all;
  for (const auto id : ids) all.tests.push_back(study::load_test_result(store, id, curves));
  for (const auto id : run_ids) all.runs.push_back(grains.load(id));
  if (!o.figures.empty()) {
    write_figures(all.tests, study::collapse_increments(store, ids), o.figures);
    write_grain_figures(all.runs, o.figures);
    if (format == "text" && o.output.empty()) return;
  }
  write(format, all, output);
}

}  // namespace

Command report_command() {
  return {
      .name = "report",
      .purpose = "say when, why and at what stress ratio tests collapsed: text, JSON, HTML or PDF",
      .description =
          {"Reports the named tests and runs of grains, or all, from the database. A test is named "
           "by its number or its name, a run of grains by its name or by grains:NUMBER; of several "
           "with one name it is the latest.",
           "HTML is one file with its figures inside; PDF is A4. Both hold the path in q-p' with "
           "the onset, "
           "the instability line and the Mohr-Coulomb line, and q, u, axial strain and normalised "
           "second-order work on one axis. The ending of --output says the format unless --format "
           "does. Without --output they are written to triax_report.html "
           "or "
           "triax_report.pdf in the current folder; text and JSON go to standard output.",
           "--figures writes each figure of a report, and those that compare all tests of a type, "
           "as SVG, PNG and PDF into a folder, those of runs of grains with the numbers behind "
           "them; without --format and --output nothing else."},
      .diagnostics = {{"FILE: ... no such database; ...",
                       "there is no database yet, or --db names another file"}},
      .examples = {{"triax report", "all tests and runs of grains as text"},
                   {"triax report csu_26 --output csu_26.html", "one test with figures"},
                   {"triax report csu_26 --live", "what was said while the test ran, and when"},
                   {"triax report 1 2 3 --format json", "three tests as one JSON document"},
                   {"triax report grains:1 --format html", "a run of grains with its figures"},
                   {"triax report --figures pictures",
                    "the figures of all tests and runs of grains as files"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<ReportOptions>();
        app.add_option("TEST", o->tests,
                       "numbers or names of tests, grains:1 a run of grains; all if none is given")
            ->type_name("");
        add_db(app, o->db);
        add_format(app, o->format, {"text", "json", "html", "pdf"});
        o->format.clear();
        app.add_option("--output", o->output,
                       "file to write; .json, .html or .pdf at its end says the format")
            ->type_name("FILE");
        add_live(app, o->live);
        app.add_option("--figures", o->figures, "folder to write the figures to")
            ->type_name("FOLDER");
        return [o] { run_report(*o); };
      }};
}

}  // namespace triax::src
