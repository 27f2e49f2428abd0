#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "lab/records/record_header.hpp"

namespace triax::lab {

/// Collects what was changed or assumed while a record was read. Findings of one kind become one
/// warning: the first with its line, the rest as a count.
class Findings {
 public:
  /// Writes into `warnings`, which must outlive this object.
  explicit Findings(std::vector<Warning>& warnings) : warnings_(warnings) {}

  /// One finding; `kind` says which findings are of one kind. Costs a search over the few kinds.
  void note(const std::string& kind, std::int64_t line, const std::string& text);
  /// The record is over: adds the counts to the texts.
  void finish();

 private:
  struct Kind {
    std::string name;
    std::size_t warning = 0;
    std::int64_t more = 0;
    std::int64_t last_line = 0;
  };
  std::vector<Warning>& warnings_;
  std::vector<Kind> kinds_;
};

}  // namespace triax::lab
