// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/export_sink.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "src/output/output.hpp"

namespace triax::src {

ExportSink::ExportSink(const std::string& path) {
  if (path == "-") return;
  noted_.emplace(path);
  file_.emplace(path);
}

void ExportSink::write(std::string_view text) {
  constexpr std::size_t kFlushAt = std::size_t{1} << 16;
  waiting_ += text;
  if (waiting_.size() > kFlushAt) flush();
}

void ExportSink::flush() {
  if (file_)
    file_->write(waiting_);
  else
    put(waiting_);
  waiting_.clear();
}

void ExportSink::finish() {
  flush();
  if (!file_) return print({});
  file_->finish();
  noted_->is_there();
}

void append_number(std::string& text, double value) {
  if (std::isfinite(value)) fmt::format_to(std::back_inserter(text), "{}", value);
}

}  // namespace triax::src
