#pragma once
// Records that hold only reduced stresses and strains enter at State: columns are taken as they are
// and completed. Effective stresses, where given, come before p' and q that somebody computed from
// them.
#include <optional>
#include <vector>

#include "lab/collapse/test_summary.hpp"
#include "lab/records/record_header.hpp"
#include "lab/reduction/state.hpp"

namespace triax::lab {

class ReducedColumns {
 public:
  explicit ReducedColumns(const RecordHeader& header);

  State reduce(const Reading& reading);
  Consolidation consolidation() const;
  std::vector<Warning> warnings() const { return warnings_; }

 private:
  bool undrained(int stage) const;

  std::vector<StageInfo> stages_;
  std::optional<double> void_ratio_start_, p_eff_start_;
  std::vector<Warning> warnings_;
};

}  // namespace triax::lab
