// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/export.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

#include "db/store.hpp"
#include "lab/ags/ags_rules.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/export/export_sink.hpp"
#include "src/export/export_tables.hpp"
#include "src/export/workbook/test_workbook.hpp"
#include "src/output/file_names.hpp"
#include "src/output/notice.hpp"
#include "src/output/output.hpp"
#include "src/study/handover/ags_delivery.hpp"
#include "src/study/handover/diggs_delivery.hpp"
#include "src/triaxial/left_waiting.hpp"

namespace triax::src {
namespace {

struct ExportOptions {
  std::vector<std::string> tests;
  std::string db = "triax.db";
  std::string format;  ///< empty: what the ending of --output says
  std::string output;
  std::vector<std::string> sets;
  std::string check;
  bool states = false;
};

const std::vector<std::string> kFormats{"csv", "xlsx", "json", "ags", "diggs"};

std::string format_of(const ExportOptions& o) {
  if (!o.format.empty()) return o.format;
  const std::string ending = std::filesystem::path(o.output).extension().string();
  for (const auto& format : kFormats)
    if (ending == '.' + format) return format;
  if (ending == ".xml") return "diggs";
  throw lab::BadInput("no format: use --format " + lab::joined(kFormats, "|") +
                      " or an --output file with that extension");
}

/// Letters, digits and a few signs of the name: what stands in any file system.
std::string exported_name(const std::string& name) {
  std::string out;
  for (const char c : name)
    out += (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'
               ? c
               : '_';
  return out.empty() ? "test" : out;
}

/// One file a test: that of --output, or named after the tests in the folder that it is.
std::vector<std::string> files_of_tests(const ExportOptions& o, const std::string& format,
                                        const std::vector<study::TestResult>& tests) {
  std::error_code unreadable;
  if (o.output == "-")
    throw lab::BadInput("--output -: " + format + " goes to files, not to standard output");
  const bool folder = o.output.empty() || std::filesystem::is_directory(o.output, unreadable);
  if (!folder && tests.size() == 1) return {o.output};
  if (!folder)
    throw lab::BadInput(
        fmt::format("--output {}: {} tests need {} files; expected an existing folder", o.output,
                    tests.size(), tests.size()));
  FileNames names;
  std::vector<std::string> files;
  files.reserve(tests.size());
  for (const auto& test : tests)
    files.push_back(
        (std::filesystem::path(o.output) /
         (names.take(exported_name(test.stored.header.name), test.stored.id) + '.' + format))
            .string());
  return files;
}

void export_workbooks(const db::Store& store, const std::vector<study::TestResult>& tests,
                      const ExportOptions& o) {
  const auto files = files_of_tests(o, "xlsx", tests);
  for (std::size_t i = 0; i < tests.size(); ++i) {
    refuse_overwriting("--output", files[i], database_files(o.db), "the database");
    refuse_longer_than_a_sheet(store, tests[i].stored);
  }
  for (std::size_t i = 0; i < tests.size(); ++i) {
    const auto plain = export_workbook(store, tests[i], files[i]);
    if (plain > 0)
      notify(
          fmt::format("{}: {} cells of states are numbers, because no formula of the readings "
                      "gives the stored value",
                      files[i], plain));
  }
}

std::string today() {
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::chrono::system_clock::now()));
}

void export_ags(const db::Store& store, const std::vector<study::TestResult>& tests,
                const ExportOptions& o) {
  std::vector<study::AgsSaid> said;
  for (const auto& [key, value] : key_values(o.sets, "LOCA_ID=BH1"))
    said.push_back(study::ags_said(key, value));
  std::vector<study::AgsTest> all;
  all.reserve(tests.size());
  for (const auto& test : tests)
    all.push_back({test.stored, study::shear_values(store, test.stored)});
  const auto document = study::ags_delivery(all, said, today());
  const auto unsaid = std::ranges::count_if(
      document.find("LOCA")->rows, [](const lab::AgsRow& row) { return row.front().empty(); });
  if (unsaid > 0)
    notify(
        "some tests have no location: LOCA_ID is empty; give it with --set TEST/LOCA_ID=... (and "
        "SAMP_REF, SAMP_TOP)");
  write_file(o.output.empty() ? "-" : o.output, lab::ags_text(document));
}

void export_diggs(const db::Store& store, const std::vector<study::TestResult>& tests,
                  const ExportOptions& o) {
  std::vector<study::AgsSaid> said;
  for (const auto& [key, value] : key_values(o.sets, "LOCA_ID=BH1"))
    said.push_back(study::diggs_said(key, value));
  std::vector<db::StoredTest> stored;
  stored.reserve(tests.size());
  for (const auto& test : tests) stored.push_back(test.stored);
  ExportSink sink(o.output.empty() ? "-" : o.output);
  study::write_diggs(store, stored, said, today(),
                     [&sink](std::string_view text) { sink.write(text); });
  sink.finish();
}

void check_file(const std::string& path) {
  const auto check = lab::check_ags(*lab::open_file(path));
  std::string text;
  for (const auto& finding : check.findings) text += path + ": " + in_words(finding) + '\n';
  if (!check.unknown_groups.empty())
    text += fmt::format("{}: checked with the dictionary except {}\n", path,
                        lab::joined(check.unknown_groups));
  print(text);
  if (!check.findings.empty())
    throw lab::BadInput(path, 0,
                        fmt::format("{} violations of the rules of AGS4", check.findings.size()));
  print(path + ": no violation of the rules of AGS4\n");
}

void run_export(const ExportOptions& o) {
  if (!o.check.empty()) return check_file(o.check);
  const std::string format = format_of(o);
  if (!o.sets.empty() && format != "ags" && format != "diggs")
    throw lab::BadInput("--set needs --format ags or diggs");
  if (o.states && format != "csv")
    throw lab::BadInput("--states needs --format csv; json and xlsx contain the states already");
  refuse_overwriting("--output", o.output, database_files(o.db), "the database");
  const db::Store store(o.db);
  tell_of_gaps(o.db);
  std::vector<study::TestResult> tests;
  for (const auto id : store.find(o.tests))
    tests.push_back(study::load_test_result(store, id, study::WithCurves::no));
  if (tests.empty()) throw lab::BadInput(o.db, 0, "no test in the database");
  if (format == "ags") return export_ags(store, tests, o);
  if (format == "diggs") return export_diggs(store, tests, o);
  if (format == "xlsx") return export_workbooks(store, tests, o);
  if (format == "json") return export_json(store, tests, o.output.empty() ? "-" : o.output);
  const auto files = files_of_tests(o, format, tests);
  for (std::size_t i = 0; i < tests.size(); ++i) {
    refuse_overwriting("--output", files[i], database_files(o.db), "the database");
    (o.states ? export_states : export_record)(store, tests[i].stored, files[i]);
  }
}

}  // namespace

Command export_command() {
  return {
      .name = "export",
      .purpose = "Export tests as CSV, workbook, JSON, AGS4 or DIGGS",
      .description =
          {"Writes the named tests, or all tests, for other programs. A test is named by its "
           "number or its name. If several tests have the same name, the latest is used.",
           "csv is the record in the format of triax: one file for each test, named after the "
           "test, in the current folder or in the folder of --output. triax replay reads it back "
           "bit for bit. With --states, the file has strains, stresses and second-order work "
           "instead. A spreadsheet does not evaluate any cell as a formula. json is the document "
           "of `triax report --format json` with readings and states.",
           "xlsx is one workbook for each test, named like a csv file: specimen, stages, readings, "
           "states, the blocks from which second-order work is computed, the assessment, and "
           "charts. States are formulas of the readings, so that each number can be traced, and "
           "the values that triax stored are next to them. A text is never a formula. A worksheet "
           "has at most 1048576 rows: export a longer test as csv.",
           "ags is one file of AGS4 4.1.1 with all tests: TREG and TRET, TRIG and TRIT for a UU "
           "test, CTRG, CTRC, CTRP and CTRD for a cyclic test. The stress ratio at the onset of "
           "collapse and the kind of collapse have headings of their own, declared in DICT. "
           "References of the client (LOCA_ID, SAMP_TOP, SAMP_REF, SAMP_TYPE, SAMP_ID, SPEC_REF, "
           "SPEC_DPTH) come from the preamble of the record or from --set and are written "
           "unchanged. Values that the record lacks are empty. A file that would violate a rule of "
           "AGS4 is not written.",
           "diggs is one document of DIGGS 2.6 with all tests: project, locations, specimens, "
           "readings with their units, shearing increments and results. triax replay reads it "
           "back bit for bit. --set gives the project, client and references of the specimen "
           "under the names of AGS4: PROJ_NAME, PROJ_CLNT, LOCA_ID, SAMP_REF, SAMP_TOP, SPEC_REF. "
           "Values without an element of DIGGS are written as otherTestProperty. A simulated test "
           "is "
           "marked as simulated.",
           "--check validates an AGS4 file against the rules of the format and lists each line "
           "that violates one. Nothing is exported."},
      .diagnostics = {{"FILE: database does not exist; ...",
                       "correct --db, or create the database with triax simulate, run or replay"},
                      {"the AGS4 file would violate line N, rule 8, ...",
                       "correct the value of --set: it is not of the type of its heading, or has a "
                       "character that AGS4 does not allow"}},
      .examples =
          {{"triax export csu_26 --format csv", "export the record of CSU 26 as CSU_26.csv"},
           {"triax export csu_26 --format xlsx",
            "export a workbook with live formulas as CSU_26.xlsx"},
           {"triax export 1 2 --format ags --set LOCA_ID=BH1 --set 1/SAMP_REF=22 --output lab.ags",
            "export two tests as AGS4 with the references of the client"},
           {"triax export --output tests.xml --set LOCA_ID=BH1", "export all tests as DIGGS"},
           {"triax export --format json --output all.json",
            "export all tests with readings and states"},
           {"triax export --check lab.ags", "validate an AGS4 file"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<ExportOptions>();
        app.add_option("TEST", o->tests, "tests, by number or name [all]")->type_name("");
        add_db(app, o->db);
        app.add_option("--format", o->format, "output format [extension of --output]")
            ->check(CLI::IsMember(kFormats).description(""))
            ->type_name(lab::joined(kFormats, "|"));
        app.add_option("--output", o->output, "file to write, or folder for several files")
            ->type_name("FILE");
        app.add_option("--set", o->sets,
                       "heading of AGS4 that the record lacks, also for DIGGS; "
                       "TEST/HEADING=VALUE for one test (repeatable)")
            ->type_name("HEADING=VALUE")
            ->allow_extra_args(false);
        app.add_flag("--states", o->states,
                     "write states and second-order work instead of readings (csv)");
        app.add_option("--check", o->check, "validate an AGS4 file and exit")->type_name("FILE");
        return [o] { run_export(*o); };
      }};
}

}  // namespace triax::src
