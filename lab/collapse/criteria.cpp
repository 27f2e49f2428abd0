// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/criteria.hpp"

#include <array>

#include "lab/collapse/control_peak.hpp"
#include "lab/collapse/loss_of_control.hpp"
#include "lab/collapse/second_order_work.hpp"

namespace triax::lab {
namespace {

template <class Of>
std::unique_ptr<CollapseCriterion> make() {
  return std::make_unique<Of>();
}

constexpr auto kCriteria = std::to_array<CriterionRow>({
    {"second_order_work", "nowhere negative with statistical significance", make<SecondOrderWork>},
    {LossOfControl::kName, "no loss of control detected", make<LossOfControl>},
    {"control_peak", "no peak of the control variable", make<ControlPeak>},
});

}  // namespace

std::span<const CriterionRow> collapse_criteria() { return kCriteria; }

Criterion criterion_of(const CriterionRow& row, const std::optional<Finding>& finding) {
  Criterion c{.name = std::string(row.name)};
  if (!finding) {
    c.evidence = row.otherwise;
    return c;
  }
  c.detected = finding->detected;
  c.reading = finding->instant.reading;
  c.time_s = finding->instant.time_s;
  c.eta = finding->instant.eta();
  c.detected_at = finding->noticed;
  c.evidence = finding->evidence;
  return c;
}

std::vector<Criterion> no_criteria(const std::string& reason) {
  std::vector<Criterion> all;
  all.reserve(kCriteria.size());
  for (const CriterionRow& row : kCriteria)
    all.push_back({.name = std::string(row.name), .detected = std::nullopt, .evidence = reason});
  return all;
}

Criteria::Criteria() {
  for (const CriterionRow& row : kCriteria) all_.push_back(row.make());
}

void Criteria::set_now(const std::optional<Moment>& now) {
  for (const auto& one : all_) one->set_now(now);
}

void Criteria::start_stage(const StageInfo* stage) {
  for (const auto& one : all_) one->start_stage(stage);
}

void Criteria::add_state(const State& state, bool has_time) {
  for (const auto& one : all_) one->add_state(state, has_time);
}

void Criteria::add_point(const PathPoint& point, bool has_time) {
  for (const auto& one : all_) one->add_point(point, has_time);
}

std::vector<Criterion> Criteria::criteria() const {
  std::vector<Criterion> all;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const auto finding = all_[i]->finding();
    all.push_back(criterion_of(kCriteria[i], finding));
    if (const auto why = all_[i]->blind(); !finding && !why.empty()) all.back().evidence = why;
  }
  return all;
}

}  // namespace triax::lab
