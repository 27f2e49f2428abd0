// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/calibrate/implied_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace triax::study {
namespace {

constexpr std::size_t kFewestForInterval = 10;
constexpr std::size_t kConeEvery = 2, kConesPerPressure = 2;

using Columns = std::vector<sim::DomainColumn>;
using Value = std::optional<double>;

/// Of the middle `confidence` of the values, straight between their ranks.
double quantile(const std::vector<double>& sorted, double share) {
  const double rank = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], rank - std::floor(rank));
}

Implied implied(const Value& best, const std::vector<Value>& draws, double confidence) {
  Implied told{.best = best};
  std::vector<double> known;
  for (const Value& value : draws)
    if (value) known.push_back(*value);
  if (!draws.empty())
    told.share = static_cast<double>(known.size()) / static_cast<double>(draws.size());
  if (known.size() < kFewestForInterval) return told;
  std::ranges::sort(known);
  told.low = quantile(known, (1 - confidence) / 2);
  told.high = quantile(known, (1 + confidence) / 2);
  return told;
}

/// The angle, whole turns apart, that is nearest to another.
double nearest_turn(double angle, double to) {
  return angle - 2 * std::numbers::pi * std::round((angle - to) / (2 * std::numbers::pi));
}

double middle(const sim::Sector& cone) { return (cone.from + cone.to) / 2; }

class Gathering {
 public:
  Gathering(const ImpliedStates& at, const Answers& best, const std::vector<Answers>& draws,
            ImpliedDomain& out)
      : at_(at), best_(best), draws_(draws), out_(out) {}

  void run() {
    out_.compression = boundaries(&Answers::compression, &sim::DomainColumn::compression);
    if (at_.extension)
      out_.extension = boundaries(&Answers::extension, &sim::DomainColumn::extension);
    for (std::size_t k = 1; k < at_.pressures.size(); k += kConeEvery) add_cones(k);
    out_.none = why_none();
  }

 private:
  using Side = Columns Answers::*;
  using Boundary = sim::DomainBoundary sim::DomainColumn::*;

  template <class Of>
  Implied implied_of(const Of& of) const {
    std::vector<Value> values;
    values.reserve(draws_.size());
    for (const Answers& draw : draws_) values.push_back(of(draw));
    return implied(of(best_), values, out_.confidence);
  }

  std::vector<ImpliedBoundary> boundaries(Side side, Boundary boundary) const {
    std::vector<ImpliedBoundary> all;
    for (std::size_t k = 0; k < at_.pressures.size(); ++k) {
      const double p = at_.pressures[k];
      const auto angle_of = [&](const Answers& answers) -> Value {
        const Columns& columns = answers.*side;
        return k < columns.size() ? (columns[k].*boundary).first_unstable_angle : std::nullopt;
      };
      const auto ratio = [&](Value sim::DomainBoundary::*q) {
        return implied_of([&, q](const Answers& answers) -> Value {
          const Columns& columns = answers.*side;
          const Value met = k < columns.size() ? columns[k].*boundary.*q : std::nullopt;
          return met ? Value(*met / p) : std::nullopt;
        });
      };
      const double about = angle_of(best_).value_or(sim::kIsotropicUnloading);
      all.push_back({.p = p,
                     .first_unstable = ratio(&sim::DomainBoundary::first_unstable_q),
                     .first_angle = implied_of([&](const Answers& answers) -> Value {
                       const Value angle = angle_of(answers);
                       return angle ? Value(nearest_turn(*angle, about)) : std::nullopt;
                     }),
                     .isotropic_unloading = ratio(&sim::DomainBoundary::isotropic_unloading_q),
                     .limit = ratio(&sim::DomainBoundary::limit_q)});
    }
    return all;
  }

  /// At some rows of the column that are unstable with the best set.
  void add_cones(std::size_t column) {
    if (column >= best_.compression.size()) return;
    const auto& states = best_.compression[column].states;
    std::vector<std::size_t> unstable, chosen;
    for (std::size_t row = 0; row < states.size(); ++row)
      if (!states[row].cones.empty()) unstable.push_back(row);
    for (std::size_t k = 0; k < kConesPerPressure && !unstable.empty(); ++k)
      chosen.push_back(unstable[(2 * k + 1) * unstable.size() / (2 * kConesPerPressure)]);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    for (const std::size_t row : chosen) out_.cones.push_back(cone_at(column, row));
  }

  ImpliedCone cone_at(std::size_t column, std::size_t row) const {
    const sim::DomainState& state = best_.compression[column].states[row];
    const auto opening = [](const sim::Sector& cone) { return cone.to - cone.from; };
    const sim::Sector widest = *std::ranges::max_element(state.cones, {}, opening);
    const auto cone_of = [&](const Answers& answers) -> std::optional<sim::Sector> {
      if (column >= answers.compression.size()) return std::nullopt;
      const auto& cones = answers.compression[column].states[row].cones;
      if (cones.empty()) return std::nullopt;
      const auto away = [&](const sim::Sector& cone) {
        return std::abs(nearest_turn(middle(cone), middle(widest)) - middle(widest));
      };
      sim::Sector nearest = *std::ranges::min_element(cones, {}, away);
      const double turn = nearest_turn(middle(nearest), middle(widest)) - middle(nearest);
      nearest.from += turn, nearest.to += turn;
      return nearest;
    };
    const auto told = [&](const auto& of) {
      return implied_of([&](const Answers& answers) -> Value {
        const auto cone = cone_of(answers);
        return cone ? Value(of(*cone)) : std::nullopt;
      });
    };
    return {.p = at_.pressures[column],
            .q = state.q,
            .from = told([](const sim::Sector& cone) { return cone.from; }),
            .to = told([](const sim::Sector& cone) { return cone.to; }),
            .opening = told(opening)};
  }

  /// The law's words where it has no state at all.
  std::string refused_everywhere() const {
    std::string words = "the law gives no result";
    for (const auto& column : best_.compression) {
      if (column.states.front().kind != sim::DomainStateKind::refused) return "";
      words = column.refusal;
    }
    return words;
  }

  std::string why_none() const {
    if (!best_.refusal.empty())
      return "the law gives no result in some directions, so that the domain is unknown: " +
             best_.refusal;
    if (const std::string words = refused_everywhere(); !words.empty())
      return "the law rejects these states: " + words;
    double least = 0, most = 0;
    for (const auto* side : {&out_.compression, &out_.extension})
      for (const ImpliedBoundary& at : *side) {
        if (at.first_unstable.best || at.first_unstable.share > 0) return "";
        least = std::min(least, at.limit.best.value_or(0));
        most = std::max(most, at.limit.best.value_or(0));
      }
    if (most > 0)
      return fmt::format(
          "no direction of negative second-order work before the plastic limit (η = {:.3f}{}), "
          "with the best set and with all draws",
          most, least < 0 ? fmt::format(" and {:.3f}", least) : "");
    return fmt::format(
        "no direction of negative second-order work up to η = {:g}, with the best "
        "set and with all draws",
        kLargestRatioOfDomain);
  }

  const ImpliedStates& at_;
  const Answers& best_;
  const std::vector<Answers>& draws_;
  ImpliedDomain& out_;
};

}  // namespace

void tell_answers(const ImpliedStates& at, const Answers& best, const std::vector<Answers>& draws,
                  ImpliedDomain& out) {
  Gathering(at, best, draws, out).run();
}

}  // namespace triax::study
