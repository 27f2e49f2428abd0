// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sweep_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "db/store.hpp"
#include "src/output/output.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"
#include "src/study/sweep/sweep_summary.hpp"
#include "src/triaxial/json_report.hpp"

namespace triax::src {
namespace {

constexpr std::size_t kMostMembers = 40;
constexpr std::size_t kMostFailures = 10;

std::string finding(const study::SweepMember& m) {
  if (!m.failure.empty()) return "failed";
  if (!m.id) return "not run";
  return m.judged ? std::string(lab::to_string(m.kind)) : "not assessed";
}

Table lines(const lab::Sweep& sweep, const std::vector<study::SweepMember>& members) {
  Table table{{{"#", Align::right}, {"Test", Align::right}}, {}};
  for (const auto& [key, value] : sweep.values(1)) table.columns.push_back({key, Align::right});
  for (const char* heading : {"Collapse", "η_coll", "Time", "η true", "Time true"})
    table.columns.push_back({heading, *heading == 'C' ? Align::left : Align::right});
  for (std::size_t i = 0; i < std::min(members.size(), kMostMembers); ++i) {
    const study::SweepMember& m = members[i];
    auto& row = table.rows.emplace_back();
    row = {fmt::format("{}", m.place), m.id ? fmt::format("{}", *m.id) : kUnknown};
    for (auto& [key, value] : sweep.values(m.place)) row.push_back(std::move(value));
    for (std::string cell : {finding(m), number(m.eta, 3), duration(m.time_s),
                             number(m.true_eta, 3), duration(m.true_time_s)})
      row.push_back(std::move(cell));
  }
  return table;
}

std::string spread_text(const std::optional<study::Spread>& spread) {
  if (!spread) return kUnknown;
  return fmt::format("mean {}, minimum {}, maximum {}, standard deviation {}",
                     number(spread->mean, 4), number(spread->smallest, 4),
                     number(spread->largest, 4), number(spread->standard_deviation, 4));
}

std::string counts_text(const study::SweepSummary& sum) {
  std::string text = fmt::format("{} tests", sum.tests);
  if (sum.failed > 0) text += fmt::format(", {} failed", sum.failed);
  if (sum.not_run > 0) text += fmt::format(", {} not run", sum.not_run);
  return text + fmt::format(", {} assessed, {} collapses detected\n", sum.judged, sum.detected);
}

std::string truth_text(const study::SweepSummary& sum) {
  return fmt::format(
      "true onset (model): {} became unstable, {} of them detected; {} detected although "
      "stable\n"
      "η at the true onset: {}\nη found minus true η: {}\n",
      sum.truly_lost, sum.truly_lost_detected, sum.false_alarms, spread_text(sum.true_eta),
      spread_text(sum.eta_error));
}

}  // namespace

std::string sweep_text(const lab::Sweep& sweep, const std::vector<study::SweepMember>& members) {
  std::string text = "*** SIMULATED, not measured ***\n";
  text += to_text(lines(sweep, members));
  if (members.size() > kMostMembers)
    text += fmt::format("... and {} more; `triax query sweep` lists all\n",
                        members.size() - kMostMembers);
  const auto sum = study::summary_of(members);
  text += '\n' + counts_text(sum) + "η at collapse: " + spread_text(sum.eta) + '\n';
  return without_controls(text + truth_text(sum));
}

std::vector<std::string> sweep_failures(const lab::Sweep& sweep,
                                        const std::vector<study::SweepMember>& members) {
  std::vector<std::string> texts;
  std::size_t more = 0;
  for (const study::SweepMember& m : members) {
    if (m.failure.empty()) continue;
    if (texts.size() < kMostFailures)
      texts.push_back(
          on_one_line(fmt::format("--sweep [{}]: {}", sweep.label(m.place), m.failure)));
    else
      ++more;
  }
  if (more > 0) texts.push_back(fmt::format("--sweep: {} more tests failed", more));
  return texts;
}

void print_sweep_json(const std::string& db, const std::vector<study::SweepMember>& members) {
  std::optional<db::Store> store;
  const char* before = "[\n";
  for (const study::SweepMember& m : members) {
    if (!m.id) continue;
    if (!store) store.emplace(db);
    put(before + json_of_test(study::load_test_result(*store, *m.id, study::WithCurves::no)));
    before = ",\n";
  }
  print(store ? "\n]\n" : "[]\n");
}

}  // namespace triax::src
