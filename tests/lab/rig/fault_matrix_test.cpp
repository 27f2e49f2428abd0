// SPDX-License-Identifier: GPL-3.0-or-later
// Every fault of every device, alone and in pairs, in short tests: the rig ends in words or goes
// on, says so, and nothing is judged on what is dead.
#include "tests/lab/rig/fault_matrix.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace triax::lab;
using namespace triax::lab::testing;
using Catch::Contains;

namespace {

/// One of the short tests without a fault, and the instants at which faults are put into it.
struct Subject {
  ShortTest test;
  Programme programme;
  Outcome sound;
  bool by_force() const {
    return test.type != "ICU" || test.name.find("load") != std::string::npos;
  }
  double shear_s() const { return *sound.shear_from_s; }
  double collapse_s() const {
    return sound.summary.truth->time_s.value_or((shear_s() + sound.last_time_s) / 2);
  }
  double consolidating_s() const { return 40; }
  double shearing_s() const { return (shear_s() + collapse_s()) / 2; }
  double afterwards_s() const { return collapse_s() + 0.4 * (sound.last_time_s - collapse_s()); }
};

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all = [] {
    std::vector<Subject> made;
    for (const ShortTest& test : short_tests()) {
      const Programme programme = read_programme(text_of(test), test.name + ".toml");
      made.push_back({test, programme, run_with(programme, {})});
    }
    return made;
  }();
  return all;
}

bool is_volume(const std::string& device) { return device.ends_with("_volume"); }

/// A channel on which q, p′ or the strains stand says nothing true from then on.
bool kills(const Fault& f, bool drained) {
  const bool dead = f.kind == FaultKind::stuck || f.kind == FaultKind::open_circuit ||
                    f.kind == FaultKind::drop_out;
  if (!dead) return false;
  // Behind a shut valve it stands still anyway.
  if (f.device == "back_volume") return drained || f.kind != FaultKind::stuck;
  return f.device == "axial_force" || f.device == "axial_displacement" ||
         f.device == "cell_pressure" || f.device == "pore_pressure";
}

/// Whether docs/reference/sensor-faults.md lists the fault as one that cannot be detected, or the
/// fault has no effect in this test.
bool unnoticeable(const Subject& s, const Fault& f) {
  if (f.kind == FaultKind::drift || f.kind == FaultKind::latency) return true;
  // What stands out of the looks of a reading is not in their mean.
  const bool averages = std::ranges::any_of(
      s.programme.stages, [](const Stage& stage) { return stage.logging.averaging_s > 0; });
  if (f.kind == FaultKind::spike && averages) return true;
  if (is_volume(f.device)) return f.kind == FaultKind::stuck || f.kind == FaultKind::spike;
  if (f.kind == FaultKind::leak) return true;
  if (f.device.ends_with("_controller")) return f.kind == FaultKind::stuck;
  if (f.device == "frame") return s.by_force();
  if (f.kind == FaultKind::does_not_open) return s.test.type != "CSD";
  if (f.kind == FaultKind::does_not_close) return s.test.type == "CSD";
  return false;
}

/// The specimen drains from then on though it was not to: nothing is judged as undrained.
bool drains(const Subject& s, const Fault& f, const std::vector<Fault>& faults) {
  const bool shut = std::ranges::any_of(
      faults, [](const Fault& other) { return other.kind == FaultKind::does_not_open; });
  return s.test.type != "CSD" && f.kind == FaultKind::does_not_close && !shut;
}

/// A stuck channel shows no other fault of its own.
bool masked(const Fault& fault, const std::vector<Fault>& faults) {
  return std::ranges::any_of(faults, [&](const Fault& other) {
    return other.device == fault.device && other.kind == FaultKind::stuck &&
           other.from_s < fault.from_s;
  });
}

/// Wrong or not, nothing that q, p′, the strains or the drainage are known by stands on it, and no
/// loop reads it; a spike is left out.
bool spoils_nothing(const Subject& s, const Fault& f) {
  if (f.kind == FaultKind::spike) return true;
  if (f.device == "cell_volume") return true;
  return f.device == "back_volume" && f.kind == FaultKind::stuck && s.test.type == "ICU";
}

/// By then the collapse had cost what counts as one, a leap of it not taken for the death of a
/// sensor included.
bool comes_too_late(const Subject& s, const Fault& f) {
  constexpr double kLeap_s = 4;
  return s.sound.told_s && f.from_s > *s.sound.told_s + kLeap_s;
}

/// A sound verdict must not be lost. Where a loop followed a spike it is another test.
void check_verdict_stands(const Subject& s, const Fault& f, const Outcome& out) {
  const TestSummary& sound = s.sound.summary;
  const Truth& truth = *out.summary.truth;
  if (!sound.collapse.detected() || !truth.lost_sustainability || out.safe()) return;
  if (!truth.time_s || std::fabs(*truth.time_s - *sound.truth->time_s) > 5) return;
  if (!comes_too_late(s, f) && !spoils_nothing(s, f)) return;
  const Collapse& v = out.summary.collapse;
  CHECK(v.detected());
  if (v.detected()) CHECK(*v.onset->time_s == Approx(*sound.collapse.onset->time_s).margin(5));
}

/// Whether what a load or a held q did to the axis can be known all the same: a fall is one,
/// whatever became of the water and of what is measured of it.
bool fault_leaves_the_axis(const Subject& s, const Fault& f) {
  return s.by_force() &&
         (f.device == "pore_pressure" || f.device == "back_volume" || f.device == "valve");
}

/// A collapse that was found after that fault was there: found before, or the axis fell. Without an
/// assessment only the loss of control is known.
void check_onset(const Subject& s, const Fault& f, const Outcome& out) {
  const Collapse& c = out.summary.collapse;
  const auto& found = c.onset ? c.onset : c.loss_of_control;
  REQUIRE(found);
  const Instant& onset = *found;
  const auto& falls = out.summary.truth->run_aways;
  if (*onset.time_s <= f.from_s + 1) return;
  REQUIRE(fault_leaves_the_axis(s, f));
  REQUIRE_FALSE(falls.empty());
  // Where it drains it falls as slowly as the water goes.
  CHECK(*onset.time_s > falls.back().start_s - 2);
  if (f.device == "pore_pressure") CHECK_FALSE(onset.eta());
}

void check_always(const Subject& s, const std::vector<Fault>& faults, const Outcome& out) {
  for (const Fault& f : faults) {
    CHECK(std::ranges::any_of(out.summary.warnings,
                              [&](const Warning& w) { return w.text == describe(f); }));
  }
  CHECK(out.last_time_s < 4000);
  CHECK(out.last_time_s > faults.front().from_s - 1);
  const Collapse& v = out.summary.collapse;
  if (!v.detected()) return;
  // The specimen itself must have collapsed.
  CHECK(out.summary.truth->lost_sustainability);
  for (const Fault& f : faults) {
    // That a channel stands still shows after sensor_limits::kStuck readings.
    const bool too_late = f.kind == FaultKind::stuck && out.last_time_s < f.from_s + 20;
    if (kills(f, s.test.type == "CSD") && !too_late && !masked(f, faults)) check_onset(s, f, out);
    if (drains(s, f, faults)) check_onset(s, f, out);
  }
}

}  // namespace

TEST_CASE("short tests without a fault collapse where the specimen does, the dense one never") {
  for (const Subject& s : subjects()) {
    INFO(s.test.name);
    const Collapse& v = s.sound.summary.collapse;
    CHECK(v.judged);
    CHECK(v.detected() == (s.test.void_ratio > 1));
    if (v.detected()) CHECK(*v.onset->time_s == Approx(*s.sound.summary.truth->time_s).margin(10));
    CHECK_FALSE(s.sound.safe());
    CHECK_FALSE(v.judged_until);
    CHECK(s.sound.said().find("stood at") == std::string::npos);
    CHECK(s.sound.said().find("water") == std::string::npos);
  }
}

TEST_CASE("every fault alone: said, noticed where it can be, no verdict on a dead sensor",
          "[slow]") {
  for (const Subject& s : subjects()) {
    const std::string sound = s.sound.said();
    for (const double at : {s.consolidating_s(), s.shearing_s(), s.afterwards_s()}) {
      for (const Fault& fault : every_fault(at)) {
        // Still drained then: the same as before, and takes long.
        const bool again =
            s.test.type == "CSU" && fault.kind == FaultKind::does_not_close && at == s.shearing_s();
        if (again) continue;
        const Outcome out = run_with(s.programme, {fault});
        INFO(s.test.name << ", " << describe(fault) << ": " << to_string(out.summary.collapse.kind)
                         << ", ends at " << out.last_time_s << "\n"
                         << out.said());
        check_always(s, {fault}, out);
        check_verdict_stands(s, fault, out);
        if (at < s.collapse_s() && !unnoticeable(s, fault)) CHECK(out.said() != sound);
      }
    }
  }
}

namespace {

using Pair = std::vector<Fault>;

/// Every two faults, in either order, the second 7 s after the first.
std::vector<Pair> every_pair(const Subject& s) {
  const std::vector<Fault> first = every_fault(s.shearing_s());
  const std::vector<Fault> second = every_fault(s.shearing_s() + 7);
  std::vector<Pair> all;
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t k = 0; k < second.size(); ++k)
      if (i != k) all.push_back({first[i], second[k]});
  return all;
}

void run_pair(const Subject& s, const Pair& pair) {
  const Outcome out = run_with(s.programme, pair);
  INFO(s.test.name << ", " << describe(pair[0]) << " and " << describe(pair[1]) << ": "
                   << to_string(out.summary.collapse.kind) << '\n'
                   << out.said());
  check_always(s, pair, out);
}

bool has(const Pair& pair, FaultKind kind) {
  return std::ranges::any_of(pair, [&](const Fault& f) { return f.kind == kind; });
}

}  // namespace

TEST_CASE("faults in pairs: both are said, the dense specimen never collapses by them", "[slow]") {
  // A share of them in each test, for time; the strides have no common factor, and each test begins
  // elsewhere, so that the shares differ. A specimen that drains under its load takes the law a
  // hundred times as long as one that does not.
  struct Share {
    std::size_t every, of_the_slow;
  };
  const std::map<std::string, Share> shares = {{"loose, by displacement", {5, 1}},
                                               {"dense, by displacement", {4, 1}},
                                               {"loose, by load", {11, 26}},
                                               {"loose, drained at constant q", {23, 1}},
                                               {"loose, undrained at constant q", {29, 26}}};
  std::size_t subject = 0;
  for (const Subject& s : subjects()) {
    const auto& [every, of_the_slow] = shares.at(s.test.name);
    std::size_t number = subject++, slow = 0;
    for (const Pair& pair : every_pair(s)) {
      if (number++ % every != 0) continue;
      if (has(pair, FaultKind::does_not_close) && slow++ % of_the_slow != 0) continue;
      run_pair(s, pair);
    }
  }
}

TEST_CASE("a channel that spikes and then dies, or dies twice, gives no verdict") {
  const Subject& s = subjects()[2];
  const auto fault = [&](const char* device, FaultKind kind, double at) {
    const std::vector<Fault> all = every_fault(at);
    return *std::ranges::find_if(
        all, [&](const Fault& f) { return f.device == device && f.kind == kind; });
  };
  using enum FaultKind;
  const double at = s.shearing_s();
  for (const FaultKind then : {open_circuit, drop_out})
    run_pair(s,
             {fault("axial_displacement", spike, at), fault("axial_displacement", then, at + 7)});
  run_pair(s, {fault("back_volume", open_circuit, at), fault("back_volume", drop_out, at + 7)});
  run_pair(s, {fault("pore_pressure", spike, at), fault("valve", does_not_open, at + 7)});
}

/// For hand: `lab_tests "[.all-pairs]"`, or one test of them with -c "loose, by load".
TEST_CASE("all faults in pairs, in all tests", "[.all-pairs]") {
  for (const Subject& s : subjects()) {
    DYNAMIC_SECTION(s.test.name) {
      for (const Pair& pair : every_pair(s)) run_pair(s, pair);
    }
  }
}

TEST_CASE("what drains is not judged as undrained, whatever else is broken") {
  for (const Subject& s : {subjects()[0], subjects()[4]}) {
    const std::int64_t opened = std::llround(2 * s.shearing_s());  // readings
    for (const Pair& pair : every_pair(s)) {
      const bool gauge = std::ranges::any_of(pair, [](const Fault& f) {
        return f.device.starts_with("back_") || f.device == "pore_pressure";
      });
      if (!gauge || !has(pair, FaultKind::does_not_close)) continue;
      const Outcome out = run_with(s.programme, pair);
      const Collapse& v = out.summary.collapse;
      INFO(s.test.name << ", " << describe(pair[0]) << " and " << describe(pair[1]) << ": "
                       << to_string(v.kind) << '\n'
                       << out.said());
      CHECK_FALSE(v.detected());
      if (out.safe()) continue;  // before the valve mattered, or because of the water
      REQUIRE(v.judged_until);
      CHECK(*v.judged_until <= opened + 15);
      CHECK_THAT(out.said(), Contains("not assessed after reading"));
    }
  }
}

TEST_CASE("what a loop needs and has died leads to the safe state, within seconds") {
  const Subject& s = subjects()[2];  // at constant q
  const double at = s.shearing_s() + 60;
  for (const char* device : {"axial_force", "axial_displacement"})
    for (const FaultKind kind : {FaultKind::stuck, FaultKind::open_circuit, FaultKind::drop_out}) {
      const Outcome out = run_with(s.programme, {{device, kind, at, {}, 0}});
      INFO(device << ' ' << to_string(kind) << '\n' << out.said());
      CHECK(out.safe());
      CHECK(out.last_time_s < at + 60);
      CHECK_FALSE(out.summary.collapse.detected());
      CHECK_FALSE(out.summary.collapse.judged);
    }
}

TEST_CASE("the programmes with faults tell what became of them") {
  const auto run = [](const std::string& name) {
    const Programme p = load_programme("samples/programmes/faults/" + name + ".toml");
    REQUIRE(p.faults.size() == 1);
    return run_with(p, p.faults);
  };
  const Outcome pore = run("stuck_pore_pressure");
  CHECK_FALSE(pore.safe());
  CHECK_FALSE(pore.summary.collapse.detected());
  CHECK_THAT(pore.said(), Contains("(pore_pressure) is stuck") && Contains("not assessed after"));
  const Outcome open = run("load_cell_open");
  CHECK(open.safe());
  CHECK_FALSE(open.summary.collapse.detected());
  CHECK(open.summary.collapse.judged_until == 1439);
  CHECK_THAT(open.summary.collapse.judged_until_reason,
             Contains("the load cell (axial_force) is saturated"));
  const Outcome leaks = run("valve_leaks");
  CHECK_THAT(leaks.said(),
             Contains("although the valve is closed") && Contains("undrained_volume"));
  CHECK_FALSE(leaks.summary.collapse.detected());
  const Outcome empty = run("back_controller_empty");
  CHECK(empty.safe());
  CHECK_THAT(empty.said(), Contains("the back-pressure controller is empty"));
  const Outcome silent = run("drop_out");
  CHECK_FALSE(silent.safe());
  CHECK_THAT(silent.said(), Contains("axial_force gives no readings"));
  CHECK_FALSE(silent.summary.collapse.detected());
}
