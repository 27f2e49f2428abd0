// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/facts/run_away_fact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/output/words.hpp"
#include "src/study/triaxial/runaway_balance.hpp"

namespace triax::src {
namespace {

constexpr std::size_t kMostLines = 5;

/// A run-away lasts milliseconds or minutes.
std::string lapse(double seconds) {
  return std::abs(seconds) < 1000 ? fmt::format("{:.3g} s", seconds) : duration(seconds);
}

std::string energy_balance(const lab::RunAwayTruth& run_away,
                           const study::RunawayBalance& balance) {
  if (!balance.half_work_j) return "Eq. (5) is not resolved";
  auto line = fmt::format("Eq. (5) at its start: E_c {} against −W₂/2 {}",
                          joules(run_away.kinetic_energy_j), joules(balance.half_work_j));
  if (balance.ratio) line += fmt::format(", ratio {}", number(balance.ratio, 3));
  if (balance.start)
    line += fmt::format(" where {} is expected ({})", number(run_away.expected_ratio, 3),
                        *balance.start == study::RunawayStart::limit_point
                            ? "from a limit point, where the third order governs"
                            : "past the peak");
  return line;
}

std::string ending(const lab::RunAwayTruth& run_away, const study::RunawayBalance& balance) {
  if (!balance.duration_s) return "still moving when the test ended";
  const auto how = run_away.end == lab::RunAwayEnd::none ? std::string("ended")
                   : run_away.end == lab::RunAwayEnd::end_of_travel
                       ? std::string("travel limit reached")
                       : std::string(to_string(run_away.end));
  return fmt::format("{} after {}", how, lapse(*balance.duration_s));
}

std::string line_of(const lab::RunAwayTruth& run_away) {
  const auto balance = study::balance_of(run_away);
  return fmt::format("at {}, largest kinetic energy {} after {}; {}; {}",
                     duration(run_away.start_s), joules(run_away.largest_kinetic_energy_j),
                     lapse(balance.rise_s), energy_balance(run_away, balance),
                     ending(run_away, balance));
}

}  // namespace

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
