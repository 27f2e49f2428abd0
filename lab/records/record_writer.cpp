// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/record_writer.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/whole_file.hpp"
#include "lab/records/metadata.hpp"
#include "lab/records/truth_toml.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kFlushAt = std::size_t{1} << 16;

// How a simulation is repeated; empty for what came from a record.
std::string origin_remark(const RecordHeader& header) {
  if (header.origin != Origin::simulated || !header.dialect.empty() || !header.seed) return {};
  const auto programme = std::filesystem::path(header.source).filename().string();
  return fmt::format("## simulated, not measured: triax simulate {} --seed {}\n",
                     toml_quoted(programme), *header.seed);
}

}  // namespace

struct RecordWriter::Impl {
  explicit Impl(const std::string& to) : path(to), file(to) {}

  const std::string path;
  WholeFile file;
  bool has_time = true, is_empty = true;
  std::vector<std::pair<Quantity, sim::Unit>> columns;
  std::string text;

  void flush() {
    file.write(text);
    text.clear();
  }

  void append(double value) {
    if (!std::isfinite(value)) return;
    std::array<char, 32> digits{};
    auto* const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text.append(digits.data(), end);
  }

  void append_headings() {
    if (has_time) text += "time_s,";
    text += "stage";
    for (const auto& [quantity, unit] : columns) text.append(",").append(heading(quantity));
    text += '\n';
  }
};

RecordWriter::RecordWriter(const std::string& path, const RecordHeader& header)
    : impl_(std::make_unique<Impl>(path)) {
  impl_->has_time = header.has_time;
  for (const Quantity q : header.columns)
    impl_->columns.emplace_back(q, *sim::find_unit(info(q).unit));
  impl_->text = origin_remark(header) + as_comment(metadata_toml(header));
  impl_->append_headings();
}

RecordWriter::~RecordWriter() = default;

void RecordWriter::write(const Reading& reading) {
  impl_->is_empty = false;
  if (impl_->has_time) {
    impl_->append(reading.time_s);
    impl_->text += ',';
  }
  impl_->text += std::to_string(reading.stage);
  for (const auto& [quantity, unit] : impl_->columns) {
    impl_->text += ',';
    impl_->append(sim::to_field(reading[quantity], unit));
  }
  impl_->text += '\n';
  if (impl_->text.size() > kFlushAt) impl_->flush();
}

void RecordWriter::finish(const RecordHeader& header, const std::optional<Truth>& truth) {
  if (impl_->is_empty)
    throw WorkFailed(impl_->path + ": not written because the test has no readings");
  impl_->text += as_comment(ending_toml(header));
  if (truth) impl_->text += as_comment(truth_toml(*truth));
  impl_->flush();
  impl_->file.finish();
}

}  // namespace triax::lab
