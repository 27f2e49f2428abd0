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
#include "src/export/export_tables.hpp"
#include "src/export/workbook/test_workbook.hpp"
#include "src/output/file_names.hpp"
#include "src/output/notice.hpp"
#include "src/output/output.hpp"
#include "src/study/handover/ags_delivery.hpp"
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

const std::vector<std::string> kFormats{"csv", "xlsx", "json", "ags"};

std::string format_of(const ExportOptions& o) {
  if (!o.format.empty()) return o.format;
  const std::string ending = std::filesystem::path(o.output).extension().string();
  for (const auto& format : kFormats)
    if (ending == '.' + format) return format;
  throw lab::BadInput("which format? give --format " + lab::joined(kFormats, "|") +
                      ", or a file with such an ending to --output");
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
        fmt::format("--output {}: {} tests are {} files; give a folder that is there", o.output,
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
          fmt::format("{}: {} cells of states stand as numbers: no formula of the readings comes "
                      "to what was stored",
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
        "tests without a location: LOCA_ID is empty there; give the client's with --set "
        "TEST/LOCA_ID=... (and SAMP_REF, SAMP_TOP)");
  write_file(o.output.empty() ? "-" : o.output, lab::ags_text(document));
}

void check_file(const std::string& path) {
  const auto check = lab::check_ags(*lab::open_file(path));
  std::string text;
  for (const auto& finding : check.findings) text += path + ": " + in_words(finding) + '\n';
  if (!check.unknown_groups.empty())
    text += fmt::format("{}: held to the dictionary without {}\n", path,
                        lab::joined(check.unknown_groups));
  print(text);
  if (!check.findings.empty())
    throw lab::BadInput(
        path, 0, fmt::format("{} findings against the rules of AGS4", check.findings.size()));
  print(path + ": no finding against the rules of AGS4\n");
}

void run_export(const ExportOptions& o) {
  if (!o.check.empty()) return check_file(o.check);
  const std::string format = format_of(o);
  if (!o.sets.empty() && format != "ags")
    throw lab::BadInput("--set says headings of --format ags");
  if (o.states && format != "csv")
    throw lab::BadInput("--states is of --format csv; json and xlsx have both");
  refuse_overwriting("--output", o.output, database_files(o.db), "the database");
  const db::Store store(o.db);
  tell_of_gaps(o.db);
  std::vector<study::TestResult> tests;
  for (const auto id : store.find(o.tests))
    tests.push_back(study::load_test_result(store, id, study::WithCurves::no));
  if (tests.empty()) throw lab::BadInput(o.db, 0, "no test in the database");
  if (format == "ags") return export_ags(store, tests, o);
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
      .purpose = "hand tests over: CSV, workbooks, JSON or AGS4",
      .description =
          {"Writes the named tests, or all, for other programs. A test is named by its number or "
           "its name; of several with one name it is the latest.",
           "csv is the record in triax's own form, a file a test, named after it in the current "
           "folder or in the folder of --output; replay reads it again, bit for bit. With --states "
           "it holds strains, stresses and second-order work instead. No cell is a formula to a "
           "spreadsheet. json is the document of `triax report --format json` with readings and "
           "states in it.",
           "xlsx is a workbook a test, named as a csv is: specimen, stages, readings, states, the "
           "blocks that second-order work rests on, verdict and charts. States are formulas of the "
           "readings, so that each number can be followed, with the values that triax stored "
           "beside "
           "them. A text is never a formula. A sheet ends at row 1048576: a longer test is "
           "refused, "
           "and goes out as csv.",
           "ags is one file of AGS4 4.1.1 with all tests: TREG and TRET, TRIG and TRIT of a UU "
           "test, "
           "CTRG, CTRC, CTRP and CTRD of a cyclic one; the stress ratio at the onset of collapse "
           "and "
           "its kind are headings of their own, declared in DICT. References of the client "
           "(LOCA_ID, "
           "SAMP_TOP, SAMP_REF, SAMP_TYPE, SAMP_ID, SPEC_REF, SPEC_DPTH) come from the preamble of "
           "the record or from --set and stand as they were given. What the record does not know "
           "is empty. A file that would break a rule of AGS4 is not written.",
           "--check holds a file of AGS4 to the rules of the format and tells each line that "
           "breaks "
           "one; nothing is exported then."},
      .diagnostics = {{"FILE: ... no such database; ...",
                       "there is no database yet, or --db names another file"},
                      {"the AGS4 file would break line N, rule 8, ...",
                       "a value of --set is not of the type of its heading, or a reference has a "
                       "sign that AGS4 has not"}},
      .examples =
          {{"triax export csu_26 --format csv", "the record as csu_26.csv"},
           {"triax export csu_26 --format xlsx", "a workbook with live formulas as csu_26.xlsx"},
           {"triax export 1 2 --format ags --set LOCA_ID=BH1 --set 1/SAMP_REF=22 --output lab.ags",
            "two tests as AGS4, with the client's references"},
           {"triax export --format json --output all.json", "all tests with readings and states"},
           {"triax export --check lab.ags", "whether a file keeps to the rules of AGS4"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<ExportOptions>();
        app.add_option("TEST", o->tests, "numbers or names of tests; all if none is given")
            ->type_name("");
        add_db(app, o->db);
        app.add_option("--format", o->format, "form of what is handed over")
            ->check(CLI::IsMember(kFormats).description(""))
            ->type_name(lab::joined(kFormats, "|"));
        app.add_option("--output", o->output,
                       "file to write, or a folder for several; its ending says the format")
            ->type_name("FILE");
        app.add_option(
               "--set", o->sets,
               "a heading of AGS4 that the record does not hold, TEST/HEADING=VALUE for one "
               "test alone; again for more")
            ->type_name("HEADING=VALUE")
            ->allow_extra_args(false);
        app.add_flag("--states", o->states, "csv: states and second-order work, not the readings");
        app.add_option("--check", o->check, "hold a file of AGS4 to the rules; nothing else")
            ->type_name("FILE");
        return [o] { run_export(*o); };
      }};
}

}  // namespace triax::src
