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
  if (f.device == "back_volume") return drained || f.kind == FaultKind::open_circuit;
  return f.device == "axial_force" || f.device == "axial_displacement" ||
         f.device == "cell_pressure" || f.device == "pore_pressure";
}

/// What docs/faults.md says that nobody can notice, or that does nothing in this test.
bool unnoticeable(const Subject& s, const Fault& f) {
  if (f.kind == FaultKind::drift || f.kind == FaultKind::latency) return true;
  if (is_volume(f.device)) return f.kind == FaultKind::stuck || f.kind == FaultKind::spike;
  if (f.kind == FaultKind::leak) return true;
  if (f.device.ends_with("_controller")) return f.kind == FaultKind::stuck;
  if (f.device == "frame") return s.by_force();
  if (f.kind == FaultKind::does_not_open) return s.test.type != "CSD";
  if (f.kind == FaultKind::does_not_close) return s.test.type == "CSD";
  return false;
}

/// With a dead gauge nobody sees that a valve that was to be closed lets water through: the
/// specimen drains and is judged as if it did not (docs/faults.md).
bool drains_unseen(const std::vector<Fault>& faults) {
  const auto any = [&](const std::string& device) {
    return std::ranges::any_of(faults, [&](const Fault& f) { return f.device == device; });
  };
  // So does a pore pressure that comes late while the specimen drains fast.
  const bool late = std::ranges::any_of(faults, [](const Fault& f) {
    return f.device == "pore_pressure" && f.kind == FaultKind::latency;
  });
  return (any("back_volume") || late) && (any("valve") || any("back_controller"));
}

/// A stuck channel shows no other fault of its own.
bool masked(const Fault& fault, const std::vector<Fault>& faults) {
  return std::ranges::any_of(faults, [&](const Fault& other) {
    return other.device == fault.device && other.kind == FaultKind::stuck &&
           other.from_s < fault.from_s;
  });
}

void check_always(const Subject& s, const std::vector<Fault>& faults, const Outcome& out) {
  for (const Fault& f : faults) {
    CHECK(std::ranges::any_of(out.summary.warnings,
                              [&](const Warning& w) { return w.text == describe(f); }));
  }
  CHECK(out.last_time_s < 4000);
  CHECK(out.last_time_s > faults.front().from_s - 1);
  const Collapse& v = out.summary.collapse;
  if (!v.detected() || drains_unseen(faults)) return;
  // The specimen itself must have collapsed.
  CHECK(out.summary.truth->lost_sustainability);
  for (const Fault& f : faults) {
    // That a channel stands still shows after RecordHealth::kAtRest readings.
    const bool too_late = f.kind == FaultKind::stuck && out.last_time_s < f.from_s + 20;
    if (kills(f, s.test.type == "CSD") && !too_late && !masked(f, faults))
      CHECK(*v.onset->time_s <= f.from_s + 1);
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

TEST_CASE("every fault alone: said, noticed where it can be, no verdict on a dead sensor") {
  for (const Subject& s : subjects()) {
    const std::string sound = s.sound.said();
    for (const double at : {s.consolidating_s(), s.shearing_s(), s.afterwards_s()}) {
      for (const Fault& fault : every_fault(at)) {
        const Outcome out = run_with(s.programme, {fault});
        INFO(s.test.name << ", " << describe(fault) << ": " << to_string(out.summary.collapse.kind)
                         << ", ends at " << out.last_time_s << "\n"
                         << out.said());
        check_always(s, {fault}, out);
        if (at < s.collapse_s() && !unnoticeable(s, fault)) CHECK(out.said() != sound);
      }
    }
  }
}

TEST_CASE("faults in pairs: both are said, the dense specimen never collapses by them") {
  // Not all of them in each test, for time: one of so many.
  const std::map<std::string, std::size_t> every = {{"loose, by displacement", 3},
                                                    {"dense, by displacement", 2},
                                                    {"loose, by load", 61},
                                                    {"loose, drained at constant q", 17},
                                                    {"loose, undrained at constant q", 61}};
  for (const Subject& s : subjects()) {
    const std::vector<Fault> first = every_fault(s.shearing_s());
    const std::vector<Fault> second = every_fault(s.shearing_s() + 7);
    std::size_t number = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
      for (std::size_t k = i + 1; k < second.size(); ++k) {
        if (number++ % every.at(s.test.name) != 0) continue;
        const Outcome out = run_with(s.programme, {first[i], second[k]});
        INFO(s.test.name << ", " << describe(first[i]) << " and " << describe(second[k]) << ": "
                         << to_string(out.summary.collapse.kind) << '\n'
                         << out.said());
        check_always(s, {first[i], second[k]}, out);
      }
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
  CHECK_THAT(pore.said(), Contains("(pore_pressure) is stuck") && Contains("no verdict after"));
  const Outcome open = run("load_cell_open");
  CHECK(open.safe());
  CHECK_FALSE(open.summary.collapse.detected());
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
