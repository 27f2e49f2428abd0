#include "src/triaxial/sweep_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "db/store.hpp"
#include "src/output/output.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"
#include "src/triaxial/json_report.hpp"

namespace triax::src {
namespace {

constexpr std::size_t kMostLines = 40;
constexpr std::size_t kMostFailures = 10;

bool detected(const study::SweepMember& m) { return m.judged && m.kind != lab::CollapseKind::none; }

std::string finding(const study::SweepMember& m) {
  if (!m.failure.empty()) return "failed";
  if (!m.id) return "not run";
  return m.judged ? std::string(lab::to_string(m.kind)) : "not judged";
}

Table lines(const lab::Sweep& sweep, const std::vector<study::SweepMember>& members) {
  Table table{{{"#", Align::right}, {"Test", Align::right}}, {}};
  for (const auto& [key, value] : sweep.values(1)) table.columns.push_back({key, Align::right});
  for (const char* heading : {"Collapse", "η_coll", "Time", "η true", "Time true"})
    table.columns.push_back({heading, *heading == 'C' ? Align::left : Align::right});
  for (std::size_t i = 0; i < std::min(members.size(), kMostLines); ++i) {
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

/// Mean, extremes and standard deviation (n − 1) of some values.
struct Spread {
  std::vector<double> values;

  void add(std::optional<double> value) {
    if (value && std::isfinite(*value)) values.push_back(*value);
  }
  std::string text() const {
    if (values.empty()) return kUnknown;
    const auto n = static_cast<double>(values.size());
    double mean = 0, squares = 0;
    for (const double v : values) mean += v / n;
    for (const double v : values) squares += (v - mean) * (v - mean);
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const auto deviation =
        values.size() > 1 ? std::optional(std::sqrt(squares / (n - 1))) : std::nullopt;
    return fmt::format("mean {}, minimum {}, maximum {}, standard deviation {}", number(mean, 4),
                       number(*least, 4), number(*most, 4), number(deviation, 4));
  }
};

std::int64_t count(const std::vector<study::SweepMember>& members,
                   bool (*is_so)(const study::SweepMember&)) {
  return std::count_if(members.begin(), members.end(), is_so);
}

std::string counts_text(const std::vector<study::SweepMember>& members) {
  const auto failed =
      count(members, [](const study::SweepMember& m) { return !m.failure.empty(); });
  const auto not_run =
      count(members, [](const study::SweepMember& m) { return !m.id && m.failure.empty(); });
  const auto judged = count(members, [](const study::SweepMember& m) { return m.judged; });
  std::string text = fmt::format("{} tests", members.size());
  if (failed > 0) text += fmt::format(", {} failed", failed);
  if (not_run > 0) text += fmt::format(", {} not run", not_run);
  return text +
         fmt::format(", {} judged, {} collapses detected\n", judged, count(members, detected));
}

std::string truth_text(const std::vector<study::SweepMember>& members) {
  const auto lost =
      count(members, [](const study::SweepMember& m) { return m.id && m.truly_lost; });
  const auto found =
      count(members, [](const study::SweepMember& m) { return m.truly_lost && detected(m); });
  const auto invented =
      count(members, [](const study::SweepMember& m) { return !m.truly_lost && detected(m); });
  Spread eta, error;
  for (const study::SweepMember& m : members) {
    eta.add(m.true_eta);
    if (m.eta && m.true_eta) error.add(*m.eta - *m.true_eta);
  }
  return fmt::format(
      "true onset (model): {} became unstable, {} of them detected; {} detected that remained stable\n"
      "η at the true onset: {}\nη found minus true η: {}\n",
      lost, found, invented, eta.text(), error.text());
}

}  // namespace

std::string sweep_text(const lab::Sweep& sweep, const std::vector<study::SweepMember>& members) {
  std::string text = "*** SIMULATED, not measured ***\n";
  text += to_text(lines(sweep, members));
  if (members.size() > kMostLines)
    text += fmt::format("... and {} more; `triax query sweep` lists all\n",
                        members.size() - kMostLines);
  Spread eta;
  for (const study::SweepMember& m : members) eta.add(m.eta);
  text += '\n' + counts_text(members) + "η at collapse: " + eta.text() + '\n';
  return without_controls(text + truth_text(members));
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
