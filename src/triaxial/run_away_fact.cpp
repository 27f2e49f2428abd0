#include "src/triaxial/run_away_fact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/output/words.hpp"

namespace triax::src {
namespace {

constexpr std::size_t kMostLines = 5;

/// A run-away lasts milliseconds or minutes.
std::string lapse(double seconds) {
  return std::abs(seconds) < 1000 ? fmt::format("{:.3g} s", seconds) : duration(seconds);
}

std::string energy_balance(const lab::RunAwayTruth& run_away) {
  if (!run_away.kinetic_energy_j || !run_away.second_order_work_j) return "Eq. (5) is not resolved";
  const double half_work = -*run_away.second_order_work_j / 2;
  auto line = fmt::format("Eq. (5) at its start: E_c {} against −W₂/2 {}",
                          joules(run_away.kinetic_energy_j), joules(half_work));
  if (const auto ratio = kinetic_energy_ratio(run_away))
    line += fmt::format(", ratio {}", number(ratio, 3));
  if (run_away.expected_ratio)
    line +=
        fmt::format(" where {} is expected ({})", number(run_away.expected_ratio, 3),
                    *run_away.expected_ratio < 0.8 ? "from a limit point, where the third order governs"
                                                   : "past the peak");
  return line;
}

std::string ending(const lab::RunAwayTruth& run_away) {
  if (!run_away.end_s) return "still moving when the test ended";
  std::string how = run_away.end.empty() ? "ended" : run_away.end;
  if (how == "end of travel") how = "travel limit reached";
  return fmt::format("{} after {}", how, lapse(*run_away.end_s - run_away.start_s));
}

std::string line_of(const lab::RunAwayTruth& run_away) {
  return fmt::format("at {}, largest kinetic energy {} after {}; {}; {}",
                     duration(run_away.start_s), joules(run_away.largest_kinetic_energy_j),
                     lapse(run_away.largest_at_s - run_away.start_s), energy_balance(run_away),
                     ending(run_away));
}

}  // namespace

std::optional<double> kinetic_energy_ratio(const lab::RunAwayTruth& run_away) {
  if (!run_away.kinetic_energy_j || !run_away.second_order_work_j) return std::nullopt;
  const double ratio = -2 * *run_away.kinetic_energy_j / *run_away.second_order_work_j;
  return std::isfinite(ratio) ? std::optional(ratio) : std::nullopt;
}

std::string joules(std::optional<double> j) {
  if (!j || !std::isfinite(*j)) return kUnknown;
  const double size = std::abs(*j);
  if (size >= 1 || size == 0) return fmt::format("{:.3g} J", *j);
  if (size >= 1e-3) return fmt::format("{:.3g} mJ", *j * 1e3);
  if (size >= 1e-6) return fmt::format("{:.3g} µJ", *j * 1e6);
  return fmt::format("{:.3g} nJ", *j * 1e9);
}

std::vector<std::string> run_away_lines(const std::vector<lab::RunAwayTruth>& run_aways) {
  std::vector<std::string> lines;
  const auto shown = std::min(run_aways.size(), kMostLines);
  for (std::size_t i = 0; i < shown; ++i) lines.push_back(line_of(run_aways[i]));
  if (shown < run_aways.size())
    lines.push_back(fmt::format("and {} more", run_aways.size() - shown));
  return lines;
}

}  // namespace triax::src
