// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lab/results/record_header.hpp"

namespace triax::lab {

/// Collects what was changed or assumed while a record was read. Findings of one kind become one
/// warning: the first with its line, the rest as a count. A file with hundreds of kinds is broken
/// in a way that one more warning does not explain: the rest is only counted.
class Findings {
 public:
  /// Writes into `warnings`, which must outlive this object.
  explicit Findings(std::vector<Warning>& warnings) : warnings_(warnings) {}
  /// Goes on from `before` in a copy of its warnings.
  Findings(const Findings& before, std::vector<Warning>& warnings)
      : warnings_(warnings), kinds_(before.kinds_) {}

  /// One finding; `kind` says which findings are of one kind.
  void note(std::string_view kind, std::int64_t line, std::string text);
  /// The same; the text is made for the first of its kind only.
  void note(std::string_view kind, std::int64_t line, std::invocable auto make_text) {
    if (!repeats(kind, line)) note(kind, line, std::string(make_text()));
  }
  /// The record is over: adds the counts to the texts.
  void finish();

 private:
  struct Kind {
    std::string name;
    std::size_t warning = 0;
    std::int64_t more = 0;
    std::int64_t last_line = 0;
  };
  bool repeats(std::string_view kind, std::int64_t line);

  std::vector<Warning>& warnings_;
  std::vector<Kind> kinds_;
};

}  // namespace triax::lab
