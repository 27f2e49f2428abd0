// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/warning/worst.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "lab/records/record_writer.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"

namespace triax::bench {
namespace {

constexpr std::size_t kWorst = 5;

struct FailureKind {
  const char* name;
  std::function<double(const AlarmTrial&)> badness;  ///< 0: none
};

const std::vector<FailureKind> kFailureKinds = {
    {"missed-by-force",
     [](const AlarmTrial& t) {
       return t.collapses && t.under_force && !t.warned() ? t.stage_s : 0;
     }},
    {"missed-by-displacement",
     [](const AlarmTrial& t) {
       return t.collapses && !t.under_force && !t.warned() ? t.stage_s : 0;
     }},
    {"control-imminent",
     [](const AlarmTrial& t) { return !t.collapses && t.imminent ? 2 + t.least_work : 0; }},
    {"error", [](const AlarmTrial& t) {
       return t.collapses && t.looks[1] ? std::fabs(t.looks[1]->error) : 0;
     }}};

void write_trial(const Subject& subject, std::uint64_t seed, const std::string& path) {
  Instruments instruments{};
  lab::VirtualRig rig(varied_for_alarm(subject, seed, instruments), seed);
  lab::RecordWriter writer(path, rig.header());
  lab::SessionListener listener;
  listener.scanned = [&](const lab::Reading& reading, const lab::State&) { writer.write(reading); };
  lab::run_session(rig, {}, {listener});
  writer.finish(rig.header(), rig.truth());
}

}  // namespace

void write_worst(const std::vector<AlarmTrial>& trials, const std::vector<Subject>& subjects,
                 const std::string& folder) {
  for (const FailureKind& kind : kFailureKinds) {
    std::vector<std::size_t> bad;
    for (std::size_t i = 0; i < trials.size(); ++i)
      if (!trials[i].programme.empty() && trials[i].comparable() && kind.badness(trials[i]) > 0)
        bad.push_back(i);
    std::ranges::stable_sort(bad, std::greater<>(),
                             [&](std::size_t i) { return kind.badness(trials[i]); });
    bad.resize(std::min(bad.size(), kWorst));
    for (std::size_t place = 0; place < bad.size(); ++place) {
      const std::string name = fmt::format("{}-{}", kind.name, place + 1);
      const AlarmTrial& t = trials[bad[place]];
      write_trial(subjects[bad[place] % subjects.size()], t.seed, folder + "/" + name + ".csv");
      fmt::print("{}: {} {} seed {}\n", name, t.programme, t.material, t.seed);
    }
  }
}

}  // namespace triax::bench
