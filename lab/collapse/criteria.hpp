// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The list of criteria of collapse, and all of them at work on one test.
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "lab/collapse/criterion.hpp"

namespace triax::lab {

/// A new criterion is a class of its own and a row of this list: the verdict, the database and the
/// reports then have it.
struct CriterionRow {
  std::string_view name;       ///< in the database and in JSON; reports put blanks for underscores
  std::string_view otherwise;  ///< the evidence where it found nothing
  std::unique_ptr<CollapseCriterion> (*make)();
};
/// In the order in which they are told. Second-order work is the first: the verdict qualifies what
/// that found by a fall and by the limit surface.
std::span<const CriterionRow> collapse_criteria();
/// What the criterion of that row has to say.
Criterion criterion_of(const CriterionRow& row, const std::optional<Finding>& finding);
/// Where the test cannot be judged: the same of all rows, with the reason.
std::vector<Criterion> no_criteria(const std::string& reason);

class Criteria {
 public:
  Criteria();

  /// What is found from here on is known at that reading; empty: the record is over.
  void set_now(const std::optional<Moment>& now);
  void start_stage(const StageInfo* stage);
  void add_state(const State& state, bool has_time);
  void add_point(const PathPoint& point, bool has_time);
  /// One a row.
  std::vector<Criterion> criteria() const;
  /// The criterion of that class, which has to be in the list.
  template <class Of>
  Of& of() const {
    for (const auto& one : all_)
      if (auto* found = dynamic_cast<Of*>(one.get())) return *found;
    throw std::logic_error("no such criterion of collapse");
  }

 private:
  std::vector<std::unique_ptr<CollapseCriterion>> all_;  ///< one a row
};

}  // namespace triax::lab
