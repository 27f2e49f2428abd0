// SPDX-License-Identifier: GPL-3.0-or-later
// wire_faults [--every N] [--at-a-time N] [--broken KIND] [--trial N]: the campaign of faults on
// the wire, with its counts; 1 where a trial did not hold.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <thread>

#include "tests/wire/faults/trial.hpp"

using namespace triax::lab::test;

namespace {

constexpr std::pair<const char*, Broken> kBroken[] = {{"held_over", Broken::held_over},
                                                      {"other_channel", Broken::other_channel},
                                                      {"untold", Broken::untold},
                                                      {"unsafe", Broken::unsafe},
                                                      {"identity", Broken::identity}};

struct Options {
  std::size_t every = 1, at_a_time = 40;
  int trial = -1;
  Broken broken = Broken::nothing;
};

Options options_of(int count, char** words) {
  Options options;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string word = words[i], value = words[i + 1];
    if (word == "--every") options.every = std::stoul(value);
    if (word == "--at-a-time") options.at_a_time = std::stoul(value);
    if (word == "--trial") options.trial = std::stoi(value);
    if (word == "--broken")
      for (const auto& [name, kind] : kBroken)
        if (value == name) options.broken = kind;
  }
  return options;
}

const char* word_of(const TrialPlan& plan) {
  return plan.serial ? "RTU" : plan.modbus ? "Modbus" : "SCPI";
}

struct Count {
  int trials = 0, held = 0, safe = 0;
};

struct Counts {
  std::map<std::string, Count> by_kind;
  long cells = 0, missing = 0, told_apart = 0;
  double stall_s = 0;
  int broken = 0, wrongs = 0;

  void add(const TrialPlan& plan, const TrialLog& log, const Verdict& verdict) {
    const bool held = verdict.complaints.empty();
    const std::string kind = plan.wrongs.size() > 1 ? "two instruments" : plan.wrongs[0].kind;
    Count& count = by_kind[fmt::format("{:<7}{}", word_of(plan), kind)];
    ++count.trials;
    count.held += held;
    count.safe += verdict.safe;
    broken += !held;
    wrongs += static_cast<int>(plan.wrongs.size());
    cells += verdict.cells;
    missing += verdict.missing;
    told_apart += verdict.told_apart;
    stall_s = std::max(stall_s, log.stall_s);
    if (!held) tell(plan, log, verdict);
  }
  static void tell(const TrialPlan& plan, const TrialLog& log, const Verdict& verdict) {
    fmt::print("broken: --trial {}", plan.number);
    for (const Wrong& one : plan.wrongs)
      fmt::print("; {} {} {} from {:.2f} s for {} s", word_of(plan), one.instrument, one.kind,
                 one.from_s, one.for_s);
    fmt::print(" (stalled {:.2f} s)\n", log.stall_s);
    for (const std::string& text : verdict.complaints) fmt::print("  {}\n", text);
  }
  void print(double took_s) const {
    fmt::print("{:<34}{:>7}{:>7}{:>7}{:>12}\n", "fault", "trials", "held", "broken", "safe state");
    int trials = 0, safe = 0;
    const auto row = [](const std::string& name, int all, int held, int safes) {
      fmt::print("{:<34}{:>7}{:>7}{:>7}{:>12}\n", name, all, held, all - held, safes);
    };
    for (const auto& [kind, count] : by_kind) {
      row(kind, count.trials, count.held, count.safe);
      trials += count.trials;
      safe += count.safe;
    }
    row("all", trials, trials - broken, safe);
    fmt::print(
        "{} faults in {:.1f} min; {} cells compared with the plant, {} of them unlike the plant's "
        "a quarter of a second before; {} missing; longest wait for the machine {:.2f} s\n",
        wrongs, took_s / 60, cells, told_apart, missing, stall_s);
  }
};

}  // namespace

int main(int count, char** words) {
  const Options options = options_of(count, words);
  const std::vector<TrialPlan> all = all_trials();
  std::vector<TrialPlan> plans;
  for (const TrialPlan& plan : all)
    if (options.trial >= 0
            ? plan.number == options.trial
            : static_cast<std::size_t>(plan.number) % options.every == options.every / 2)
      plans.push_back(plan);
  // Not all of a kind at a time: serial lines start programs of their own.
  std::ranges::sort(plans, {}, [count = static_cast<int>(all.size())](const TrialPlan& plan) {
    return plan.number * 577 % count;
  });
  Counts counts;
  std::mutex mutex;
  std::atomic<std::size_t> next = 0;
  const double began_s = trial_now_s();
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < std::min(options.at_a_time, plans.size()); ++i)
    threads.emplace_back([&] {
      for (std::size_t mine = next++; mine < plans.size(); mine = next++) {
        const TrialLog log = run_trial(plans[mine], options.broken);
        const Verdict verdict = judge(plans[mine], log);
        const std::lock_guard lock(mutex);
        counts.add(plans[mine], log, verdict);
      }
    });
  for (std::thread& one : threads) one.join();
  counts.print(trial_now_s() - began_s);
  return counts.broken == 0 ? 0 : 1;
}
