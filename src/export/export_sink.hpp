// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/base/whole_file.hpp"
#include "src/output/written_files.hpp"

namespace triax::src {

/// Text of any length to a file that appears whole, or to standard output ("-") as it comes.
class ExportSink {
 public:
  /// Throws as lab::WholeFile does.
  explicit ExportSink(const std::string& path);
  void write(std::string_view text);
  /// Once all is written. Throws lab::WorkFailed.
  void finish();

 private:
  void flush();

  std::optional<WrittenFile> noted_;
  std::optional<lab::WholeFile> file_;  ///< empty: standard output
  std::string waiting_;
};

/// A number with the fewest digits that mean it; nothing for NaN and what is infinite.
void append_number(std::string& text, double value);

}  // namespace triax::src
