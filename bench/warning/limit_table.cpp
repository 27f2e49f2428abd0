// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/warning/limit_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace triax::bench {
namespace {

constexpr double kWithin = 0.02;
constexpr std::size_t kTenth = 1;  ///< of kLeft
using Some = std::vector<const LimitTrial*>;

/// How many of a group each way has within kWithin; law of those that were asked.
struct Counts {
  double tests = 0, alone = 0, window = 0, bend = 0, any = 0, law = 0, one = 0, two = 0, told = 0;
  void add(const Counts& other) {
    tests += other.tests, alone += other.alone, window += other.window, bend += other.bend;
    any += other.any, law += other.law, one += other.one, two += other.two, told += other.told;
  }
};

bool within(const std::optional<double>& eta, const LimitTrial& t) {
  return eta && std::fabs(*eta - t.alone.eta) <= kWithin;
}

bool within(const AlarmTrial& t) {
  return t.looks[kTenth] && std::fabs(t.looks[kTenth]->error) <= kWithin;
}

double best_window(const Some& group) {
  double best = 0;
  for (std::size_t m = 0; m < group.front()->members.size(); ++m)
    best = std::max(best, static_cast<double>(std::ranges::count_if(
                              group, [m](const auto* t) { return within(t->members[m], *t); })));
  return best;
}

double best_bend(const Some& group) {
  constexpr double kLeast = 0.1, kMost = 3, kStep = 0.02;
  double best = 0;
  for (double b = kLeast; b <= kMost; b += kStep)
    best = std::max(best, static_cast<double>(std::ranges::count_if(group, [b](const auto* t) {
                      const auto& look = t->alone.looks[kTenth];
                      if (!look) return false;
                      const double ahead = t->alone.eta + look->error - look->now;
                      return within(look->now + b * ahead, *t);
                    })));
  return best;
}

Counts counts_of(const Some& group) {
  Counts c{.tests = static_cast<double>(group.size()),
           .window = best_window(group),
           .bend = best_bend(group)};
  for (const auto* t : group) {
    c.alone += within(t->alone);
    c.one += within(t->one);
    c.two += within(t->two);
    c.any += std::ranges::any_of(t->members, [&](const auto& eta) { return within(eta, *t); });
    c.law += within(t->law, *t);
    c.told += within(t->by_law);
  }
  return c;
}

void print_row(const std::string& name, const Counts& c) {
  const auto share = [](double part, double whole) { return whole > 0 ? 100 * part / whole : NAN; };
  fmt::print("{:46} {:5.0f} {:7.1f} {:7.1f} {:7.1f} {:7.1f} {:8.1f} {:7.1f} {:7.1f} {:7.1f}\n",
             name, c.tests, share(c.alone, c.tests), share(c.window, c.tests),
             share(c.bend, c.tests), share(c.any, c.tests), share(c.law, c.tests),
             share(c.one, c.tests), share(c.two, c.tests), share(c.told, c.tests));
}

}  // namespace

void print_limits(const std::vector<LimitTrial>& trials) {
  std::vector<std::pair<std::string, Some>> groups;
  for (const LimitTrial& t : trials) {
    const std::string name =
        fmt::format("{} {} e {}", t.alone.programme, t.alone.material, t.alone.density);
    auto at = std::ranges::find(groups, name, &std::pair<std::string, Some>::first);
    if (at == groups.end()) at = groups.insert(at, {name, {}});
    at->second.push_back(&t);
  }
  fmt::print("\n|error| within 0.02 at 10 % left, % of tests       \n");
  fmt::print("{:46} {:>5} {:>7} {:>7} {:>7} {:>7} {:>8} {:>7} {:>7} {:>7}\n", "specimen", "tests",
             "alone", "window", "bend", "any", "its law", "one", "two", "told");
  Counts all;
  std::map<std::string, Counts> laws;
  for (const auto& [name, group] : groups) {
    const Counts c = counts_of(group);
    print_row(name, c);
    all.add(c);
    laws[group.front()->alone.law()].add(c);
  }
  for (const auto& [law, counts] : laws) print_row("all " + law, counts);
  print_row("all", all);
}

}  // namespace triax::bench
