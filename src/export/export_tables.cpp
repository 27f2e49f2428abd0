// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/export_tables.hpp"

#include <functional>

#include "lab/base/text.hpp"
#include "lab/records/record_writer.hpp"
#include "src/export/export_sink.hpp"
#include "src/study/handover/state_columns.hpp"
#include "src/triaxial/json_report.hpp"

namespace triax::src {
namespace {

using UseRow = std::function<void(const std::vector<double>&)>;

void append_json_row(std::string& text, const std::vector<double>& row) {
  text += '[';
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i > 0) text += ',';
    const auto before = text.size();
    append_number(text, row[i]);
    if (text.size() == before) text += "null";
  }
  text += ']';
}

void write_json_table(ExportSink& sink, const char* name, const std::vector<std::string>& headings,
                      const std::function<void(const UseRow&)>& rows) {
  std::string text = ",\n  \"" + std::string(name) + "\": {\n    \"columns\": [\"" +
                     lab::joined(headings, "\", \"") + "\"],\n    \"rows\": [";
  bool first = true;
  rows([&](const std::vector<double>& row) {
    text += first ? "\n" : ",\n";
    first = false;
    append_json_row(text, row);
    sink.write(text);
    text.clear();
  });
  sink.write(text + "]\n  }");
}

void write_json_test(ExportSink& sink, const db::Store& store, const study::TestResult& test) {
  std::string document = json_of_test(test);
  document.resize(document.rfind('}'));  // the tables follow before the object ends
  while (document.ends_with('\n') || document.ends_with(' ')) document.pop_back();
  sink.write(document);
  const auto id = test.stored.id;
  write_json_table(
      sink, "readings", study::reading_headings(test.stored.header),
      [&](const UseRow& use) { study::for_each_reading_row(store, test.stored, use); });
  write_json_table(sink, "states", study::state_headings(),
                   [&](const UseRow& use) { study::for_each_state_row(store, id, use); });
  sink.write("\n}");
}

}  // namespace

void export_record(const db::Store& store, const db::StoredTest& test, const std::string& path) {
  const WrittenFile noted(path);
  lab::RecordWriter writer(path, test.header);
  store.for_each_scan(
      test.id, 1, [&](const lab::Reading& reading, const lab::State&) { writer.write(reading); });
  writer.finish(test.header, test.summary.truth);
  noted.is_there();
}

void export_states(const db::Store& store, const db::StoredTest& test, const std::string& path) {
  ExportSink sink(path);
  sink.write(lab::joined(study::state_headings(), ",") + "\r\n");
  std::string line;
  study::for_each_state_row(store, test.id, [&](const std::vector<double>& row) {
    line.clear();
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) line += ',';
      append_number(line, row[i]);
    }
    sink.write(line += "\r\n");
  });
  sink.finish();
}

void export_json(const db::Store& store, const std::vector<study::TestResult>& tests,
                 const std::string& path) {
  ExportSink sink(path);
  const bool list = tests.size() != 1;
  if (list) sink.write("[\n");
  for (const auto& test : tests) {
    if (&test != &tests.front()) sink.write(",\n");
    write_json_test(sink, store, test);
  }
  sink.write(list ? "\n]\n" : "\n");
  sink.finish();
}

}  // namespace triax::src
