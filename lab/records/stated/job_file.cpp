// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/stated/job_file.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <filesystem>

#include "lab/base/text.hpp"
#include "lab/base/toml_reader.hpp"

namespace triax::lab {
namespace {

std::string place_of(const TomlTable& table, std::int64_t line) {
  return fmt::format("{}:{}", table.file(), line);
}

/// All keys of `table` as "PREFIX.key".
void take_values(const TomlTable& table, const std::string& prefix, RecordHeader& trial,
                 std::vector<SetValue>& values) {
  for (const std::string& key : table.keys()) {
    SetValue value{fmt::format("{}.{}", prefix, key), table.scalar(key).value_or(""),
                   place_of(table, table.line(key))};
    set_value(trial, value);
    values.push_back(std::move(value));
  }
}

void take_stages(const TomlTable& stages, RecordHeader& trial, std::vector<SetValue>& values) {
  for (const std::string& number : stages.keys()) {
    if (!stages.is_table(number))
      stages.fail(number, "expected a table for each stage: [stages.1]");
    take_values(*stages.table(number), "stages." + number, trial, values);
  }
}

/// The values of all groups that a document or a section has. They are tried on a header, so that
/// a mistake is reported before the first record is read.
std::vector<SetValue> values_of(const TomlTable& document) {
  std::vector<SetValue> values;
  RecordHeader trial;
  for (const char* const group : {"test", "specimen", "labels", "sensors"})
    if (const auto table = document.table(group)) take_values(*table, group, trial, values);
  if (const auto stages = document.table("stages")) take_stages(*stages, trial, values);
  return values;
}

}  // namespace

JobFile JobFile::read(const std::string& path) {
  const TomlTable document = TomlTable::read(path);
  JobFile job;
  job.common_ = values_of(document);
  for (const TomlTable& table : document.tables("file")) {
    Section section{table.texts("match"), place_of(table, table.line()), values_of(table)};
    if (section.patterns.empty() || std::ranges::any_of(section.patterns, &std::string::empty))
      table.fail("match", "expected a pattern of file names, such as \"ICU-*.csv\"");
    table.finish();
    job.sections_.push_back(std::move(section));
  }
  document.finish();
  return job;
}

bool JobFile::Section::matches(const std::string& record) const {
  const std::string name = std::filesystem::path(record).filename().string();
  return std::ranges::any_of(patterns, [&](const std::string& pattern) {
    return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
  });
}

std::vector<SetValue> JobFile::values_for(const std::string& record) const {
  std::vector<SetValue> values = common_;
  for (const Section& section : sections_)
    if (section.matches(record))
      values.insert(values.end(), section.values.begin(), section.values.end());
  return values;
}

std::vector<std::string> JobFile::unmatched(const std::vector<std::string>& records) const {
  std::vector<std::string> found;
  for (const Section& section : sections_)
    if (std::ranges::none_of(records, [&](const auto& record) { return section.matches(record); }))
      found.push_back(fmt::format("{}: no record matches '{}'", section.where,
                                  joined(section.patterns, "', '")));
  return found;
}

}  // namespace triax::lab
