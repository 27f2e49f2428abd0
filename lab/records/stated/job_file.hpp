// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Values for many records in one TOML file: `triax replay RECORD... --job job.toml`.
//
//   [labels]                     # all keys of --set, in their tables
//   client = "..."
//   [specimen]
//   height_mm = 140
//   [stages.1]
//   role = "consolidation"
//   [[file]]                     # only for records with such names, stronger than the above
//   match = "ICU-*.csv"          # or a list of patterns
//   specimen.void_ratio = 0.95
#include <string>
#include <vector>

#include "lab/records/stated/set_value.hpp"

namespace triax::lab {

class JobFile {
 public:
  /// Values for no record.
  JobFile() = default;
  /// Throws BadInput "FILE:LINE: ..." for a file that cannot be read, an unknown key (names the
  /// nearest), a value that is not valid for its key, test.origin and test.seed, and a section
  /// [[file]] without a pattern.
  static JobFile read(const std::string& path);

  /// The values for a record, the stronger later: those of all records, then those of each section
  /// [[file]] of which a pattern matches its file name, in the order of the file. In a pattern * is
  /// any text, ? one character and [abc] one of these; letter case counts.
  std::vector<SetValue> values_for(const std::string& record) const;
  /// "FILE:LINE: no record matches 'ICU-*.csv'" for each section that matches none of these.
  std::vector<std::string> unmatched(const std::vector<std::string>& records) const;

 private:
  struct Section {
    std::vector<std::string> patterns;
    std::string where;
    std::vector<SetValue> values;
    bool matches(const std::string& record) const;
  };
  std::vector<SetValue> common_;
  std::vector<Section> sections_;
};

}  // namespace triax::lab
