#include "src/triaxial/report.hpp"

#include <filesystem>
#include <memory>

#include "db/store.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/output/output.hpp"
#include "src/study/triaxial/collapse_increments.hpp"
#include "src/triaxial/figure_folder.hpp"
#include "src/triaxial/html_report.hpp"
#include "src/triaxial/json_report.hpp"
#include "src/triaxial/pdf_report.hpp"
#include "src/triaxial/print_tests.hpp"
#include "src/triaxial/text_report.hpp"

namespace triax::src {
namespace {

struct Options {
  std::vector<std::string> tests;
  std::string db = "triax.db";
  std::string format;  ///< empty: what the ending of --output says, or text
  std::string output;
  std::string figures;
};

std::string chosen_format(const Options& o) {
  if (!o.format.empty()) return o.format;
  const std::string ending = std::filesystem::path(o.output).extension().string();
  for (const char* format : {"json", "html", "pdf"})
    if (ending == std::string(".") + format) return format;
  return "text";
}

void run(const Options& o) {
  const std::string format = chosen_format(o);
  const bool drawn = format == "html" || format == "pdf";
  const std::string output = !o.output.empty() ? o.output
                             : drawn           ? "triax_report." + format
                                               : "-";
  refuse_overwriting("--output", output, database_files(o.db), "the database");
  const db::Store store(o.db);
  const auto ids = store.find(o.tests);
  const auto curves = drawn || !o.figures.empty() ? study::WithCurves::yes : study::WithCurves::no;
  std::vector<study::TestResult> tests;
  for (const auto id : ids) tests.push_back(study::load_test_result(store, id, curves));
  if (!o.figures.empty()) {
    write_figures(tests, study::collapse_increments(store, ids), o.figures);
    if (format == "text" && o.output.empty()) return;
  }

  if (format == "pdf")
    pdf_report(tests, output);
  else if (format == "html")
    write_file(output, html_report(tests));
  else
    write_file(output, format == "json" ? json_report(tests) : text_for_people(std::move(tests)));
}

}  // namespace

Command report_command() {
  return {
      .name = "report",
      .purpose = "say when, why and at what stress ratio tests collapsed: text, JSON, HTML or PDF",
      .description =
          {"Reports the named tests, or all, from the database. A test is named by its number or "
           "its name; "
           "of several with one name it is the latest.",
           "HTML is one file with its figures inside; PDF is A4. Both hold the path in q-p' with "
           "the onset, "
           "the instability line and the Mohr-Coulomb line, and q, u, axial strain and normalised "
           "second-order work on one axis. The ending of --output says the format unless --format does. Without --output they are written to triax_report.html "
           "or "
           "triax_report.pdf in the current folder; text and JSON go to standard output.",
           "--figures writes each figure of a report, and those that compare all tests of a type, "
           "as SVG, PNG and PDF into a folder; without --format and --output nothing else."},
      .diagnostics = {{"FILE: ... no such database; ...",
                       "there is no database yet, or --db names another file"}},
      .examples = {{"triax report", "all tests as text"},
                   {"triax report csu_26 --output csu_26.html",
                    "one test with figures"},
                   {"triax report 1 2 3 --format json", "three tests as one JSON document"},
                   {"triax report --figures pictures", "the figures of all tests as files"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<Options>();
        app.add_option("TEST", o->tests, "numbers or names of tests; all if none is given")
            ->type_name("");
        add_db(app, o->db);
        add_format(app, o->format, {"text", "json", "html", "pdf"});
        o->format.clear();
        app.add_option("--output", o->output, "file to write; .json, .html or .pdf at its end says the format")
            ->type_name("FILE");
        app.add_option("--figures", o->figures, "folder to write the figures to")
            ->type_name("FOLDER");
        return [o] { run(*o); };
      }};
}

}  // namespace triax::src
