// SPDX-License-Identifier: GPL-3.0-or-later
// Sensors broken under virtual tests: what is said of them, and that no verdict rests on them.
#include <fmt/format.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "tests/lab/health/faulty_rig.hpp"

using namespace triax::lab;
using namespace triax::lab::testing;

namespace {

constexpr Quantity kNeeded[] = {Quantity::axial_displacement, Quantity::axial_force,
                                Quantity::cell_pressure, Quantity::pore_pressure,
                                Quantity::back_volume};
constexpr const char* kTests[] = {"icu_6", "csd_51", "csu_26", "icu_dense"};

const DrawnTest& drawn(const std::string& name) {
  static std::map<std::string, DrawnTest> all;
  const auto found = all.find(name);
  return found != all.end() ? found->second : all.emplace(name, draw(name)).first->second;
}

bool speaks_of(const TestSummary& s, Quantity q) {
  const std::string name = fmt::format("({})", info(q).name);
  return std::ranges::any_of(
      s.warnings, [&](const Warning& w) { return w.text.find(name) != std::string::npos; });
}

const Check* check(const TestSummary& s, CheckKind kind) {
  const auto found = std::ranges::find(s.checks, kind, &Check::kind);
  return found == s.checks.end() ? nullptr : &*found;
}

struct Case {
  std::string name;
  Break broken;
  std::int64_t until;  ///< first reading that is right again
};

std::vector<Case> dead_for_good(Quantity q, std::int64_t at) {
  return {{"stuck", stuck(q, at), INT64_MAX},
          {"saturated", constant(q, open_circuit(q), at), INT64_MAX},
          {"at zero", constant(q, 0, at), INT64_MAX},
          {"missing", missing(q, at), INT64_MAX}};
}

std::vector<Case> dead_for_a_while(Quantity q, std::int64_t at) {
  const double height = 0.3 * open_circuit(q);
  return {{"stuck for 100", stuck(q, at, at + 100), at + 100},
          {"saturated for 100", constant(q, open_circuit(q), at, at + 100), at + 100},
          {"missing for 100", missing(q, at, at + 100), at + 100},
          {"spike", spike(q, height, at), at + 1},
          {"broad spike", spike(q, -height, at, 3), at + 3}};
}

/// With the valve closed the volume stands still of itself: nobody sees that its gauge is stuck,
/// and nothing depends on it.
bool harmless(const DrawnTest& test, Quantity q, const Case& c) {
  const bool still = c.name.starts_with("stuck") || c.name.starts_with("missing");
  return q == Quantity::back_volume && still &&
         test.header.stage(test.readings.back().stage)->drainage == Drainage::closed;
}

/// A dead sensor is known by standing still for a while. A collapse under load is over in less: the
/// record ends ten readings after it.
constexpr std::int64_t kReadingsToTell = 60;

/// What is true of the programmes themselves: B, a slow drain in CSD 51, a rest cut short.
bool of_the_test_not_its_sensors(const Check& c) {
  return c.kind == CheckKind::b_value || c.kind == CheckKind::rate ||
         c.kind == CheckKind::consolidation;
}

}  // namespace

TEST_CASE("sound sensors, real or perfect: nothing is found and everything is judged") {
  for (const char* name : kTests) {
    for (bool perfect : {false, true}) {
      const DrawnTest test = perfect ? draw(name, 1, true) : drawn(name);
      const TestSummary s = judge(test);
      INFO(name << (perfect ? ", perfect" : ""));
      std::string said;
      for (const Warning& w : s.warnings) said += w.text + '\n';
      INFO(said << s.collapse.judged_until_reason);
      for (const auto& row : quantities()) CHECK_FALSE(speaks_of(s, row.quantity));
      CHECK_FALSE(s.collapse.judged_until);
      CHECK(s.collapse.judged_until_reason.empty());
      for (const Check& c : s.checks) {
        INFO(to_string(c.kind) << ": " << c.note);
        CHECK((c.ok || of_the_test_not_its_sensors(c)));
      }
    }
  }
}

namespace {

/// What the axis did is known without it: a specimen that ran away is told, where it ran away.
bool leaves_the_axis(Quantity q) {
  return q == Quantity::pore_pressure || q == Quantity::back_volume;
}

}  // namespace

TEST_CASE("a sensor that dies for good ends the verdict there, and a collapse before it stands") {
  for (const char* name : kTests) {
    const DrawnTest& test = drawn(name);
    const TestSummary whole = judge(test);
    const std::int64_t start = test.last_stage(), end = test.size();
    const std::int64_t onset =
        whole.collapse.onset ? whole.collapse.onset->reading : (start + end) / 2;
    for (std::int64_t at : {start - 200, (start + onset) / 2, onset - 5, (onset + end) / 2}) {
      if (end - at < kReadingsToTell) continue;
      for (Quantity q : kNeeded) {
        for (const Case& c : dead_for_good(q, at)) {
          if (harmless(test, q, c)) continue;
          const TestSummary s = judge(test, {c.broken});
          const Collapse& v = s.collapse;
          INFO(name << ", " << info(q).name << ' ' << c.name << " from " << at << " on, onset "
                    << onset << ": " << to_string(v.kind) << ' ' << v.judged_until_reason
                    << ", until " << v.judged_until.value_or(-1));
          const bool late_volume = q == Quantity::back_volume && c.name == "stuck" && at > onset;
          // A liquefied specimen carries nothing that a cap could be seen to move against.
          if (q == Quantity::axial_displacement && c.name == "stuck" && at > onset + 500) continue;
          if (late_volume) continue;  // the little that is left of the test does not show it
          CHECK(speaks_of(s, q));
          CHECK_FALSE(v.judged_until_reason.empty());
          // A volume that stood still when its gauge died is doubted from there on.
          const std::int64_t early = q == Quantity::back_volume ? 100 : 3;
          if (v.judged_until) CHECK(*v.judged_until <= at + 3);
          if (v.judged_until) CHECK(*v.judged_until >= at - early);
          if (v.detected() && leaves_the_axis(q) && v.onset->reading > at) {
            CHECK(whole.collapse.detected());
            CHECK(v.onset->reading >= onset - 12);
            continue;
          }
          if (at < onset) CHECK_FALSE(v.detected());
          if (v.detected()) CHECK(std::abs(v.onset->reading - onset) <= 12);
          if (at > onset + 500) CHECK(v.kind == whole.collapse.kind);
        }
      }
    }
  }
}

TEST_CASE(
    "a sensor that fails for a while: no onset in between, and what follows is judged again") {
  for (const char* name : kTests) {
    const DrawnTest& test = drawn(name);
    const TestSummary whole = judge(test);
    const std::int64_t start = test.last_stage(), end = test.size();
    const std::int64_t onset =
        whole.collapse.onset ? whole.collapse.onset->reading : (start + end) / 2;
    for (std::int64_t at : {(start + onset) / 2, onset - 5, onset + 20}) {
      if (end - at < kReadingsToTell) continue;
      for (Quantity q : kNeeded) {
        for (const Case& c : dead_for_a_while(q, at)) {
          if (harmless(test, q, c) || (q == Quantity::back_volume && c.name == "stuck for 100"))
            continue;
          const TestSummary s = judge(test, {c.broken});
          const Collapse& v = s.collapse;
          INFO(name << ", " << info(q).name << ' ' << c.name << " from " << at << ", onset "
                    << onset << ": " << to_string(v.kind) << " at "
                    << (v.onset ? v.onset->reading : -1) << ' ' << v.judged_until_reason);
          CHECK(speaks_of(s, q));
          if (v.onset && !leaves_the_axis(q))
            CHECK((v.onset->reading < at || v.onset->reading >= c.until));
          if (!whole.collapse.detected()) CHECK_FALSE(v.detected());
          // A spike costs a few readings, no verdict.
          if (c.until - at > 3) continue;
          CHECK(v.kind == whole.collapse.kind);
          CHECK(v.judged_until_reason.empty());
          if (v.onset) CHECK(std::abs(v.onset->reading - onset) <= 12);
        }
      }
    }
  }
}

TEST_CASE("two sensors at once: both are spoken of, dense sand does not collapse by them") {
  for (const char* name : {"icu_6", "icu_dense"}) {
    const DrawnTest& test = drawn(name);
    const TestSummary whole = judge(test);
    const std::int64_t start = test.last_stage();
    const std::int64_t onset =
        whole.collapse.onset ? whole.collapse.onset->reading : (start + test.size()) / 2;
    const std::int64_t at = (start + onset) / 2;
    for (Quantity first : kNeeded)
      for (Quantity second : kNeeded) {
        if (first >= second) continue;
        for (const Case& a : dead_for_good(first, at))
          for (const Case& b : dead_for_good(second, at + 7)) {
            const TestSummary s = judge(test, {a.broken, b.broken});
            INFO(name << ", " << info(first).name << ' ' << a.name << " and " << info(second).name
                      << ' ' << b.name << ": " << to_string(s.collapse.kind));
            if (!harmless(test, first, a)) CHECK(speaks_of(s, first));
            if (!harmless(test, second, b)) CHECK(speaks_of(s, second));
            if (harmless(test, first, a) && harmless(test, second, b)) continue;
            CHECK_FALSE(s.collapse.detected());
          }
      }
  }
}

TEST_CASE("slow faults show where one sensor is held against another") {
  const DrawnTest& drained = drawn("csd_51");
  const Break drift = [](Reading& r) { r[Quantity::pore_pressure] += 2.0 * r.time_s; };
  CHECK_FALSE(check(judge(drained, {drift}), CheckKind::rate)->ok);
  const Break offset = [](Reading& r) { r[Quantity::pore_pressure] += 5e3; };
  const TestSummary shifted = judge(drained, {offset});
  CHECK_FALSE(check(shifted, CheckKind::zero_difference)->ok);
  // It is the same at rest and in shear.
  CHECK(check(shifted, CheckKind::rate)->ok == check(judge(drained), CheckKind::rate)->ok);

  const DrawnTest& closed = drawn("icu_6");
  const Break leak = [](Reading& r) { r[Quantity::back_volume] -= 2e-10 * r.time_s; };
  const TestSummary leaking = judge(closed, {leak});
  CHECK_FALSE(check(leaking, CheckKind::undrained_volume)->ok);
  CHECK_FALSE(check(leaking, CheckKind::consolidation)->ok);
  const Break unsaid = [](Reading&) {};
  CHECK(check(judge(closed, {unsaid}), CheckKind::undrained_volume)->ok);
}

TEST_CASE("a transducer that leaps beyond the specimen's height ends no test") {
  const DrawnTest& test = drawn("icu_6");
  for (std::int64_t at : {test.last_stage() - 100, test.size() - 500}) {
    const TestSummary s = judge(test, {constant(Quantity::axial_displacement, 0.5, at)});
    CHECK(s.readings == test.size());
    CHECK(speaks_of(s, Quantity::axial_displacement));
    CHECK(s.collapse.judged == (at > test.last_stage()));
  }
}

TEST_CASE("nothing measured with a dead sensor is reported as measured") {
  const DrawnTest& test = drawn("icu_6");
  const TestSummary sound = judge(test);
  REQUIRE(sound.consolidation.b_value);
  const TestSummary pore = judge(test, {constant(Quantity::pore_pressure, 1e6, 55)});
  CHECK_FALSE(pore.consolidation.b_value);
  CHECK_FALSE(check(pore, CheckKind::b_value));
  CHECK_FALSE(pore.consolidation.p_eff_pa);
  CHECK(pore.consolidation.height_m);
  CHECK_FALSE(pore.collapse.judged);
  CHECK_FALSE(pore.peak);
  const TestSummary gauge = judge(test, {missing(Quantity::axial_displacement, 100)});
  CHECK(gauge.consolidation.b_value);
  CHECK_FALSE(gauge.consolidation.void_ratio);
}

TEST_CASE("undrained, spikes of the load cell cost no verdict, whenever they begin") {
  const DrawnTest& test = drawn("icu_6");
  const TestSummary whole = judge(test);
  REQUIRE(whole.collapse.detected());
  for (const std::int64_t at : {test.last_stage(), test.last_stage() + 10}) {
    const Break spikes = [at](Reading& r) {
      if (r.number >= at && (r.number - at) % 40 == 0) r[Quantity::axial_force] += 900;
    };
    const TestSummary s = judge(test, {spikes});
    INFO(s.collapse.judged_until_reason);
    CHECK(s.collapse.kind == whole.collapse.kind);
    REQUIRE(s.collapse.onset);
    CHECK(std::abs(s.collapse.onset->reading - whole.collapse.onset->reading) <= 12);
  }
}

TEST_CASE("an onset that was lost in a gap is said to lie at or before what was found after it") {
  const DrawnTest& test = drawn("icu_6");
  const auto number_at = [&](double time_s) {
    return std::ranges::find_if(test.readings, [&](const Reading& r) { return r.time_s >= time_s; })
        ->number;
  };
  const double onset_s = *test.truth->time_s;
  const auto between = [&](double from_s, double until_s) {
    return judge(test, {missing(Quantity::axial_force, number_at(onset_s + from_s),
                                number_at(onset_s + until_s))});
  };
  const auto warned = [](const TestSummary& s) {
    return std::ranges::any_of(s.warnings, [](const Warning& w) {
      return w.text.find("readings are missing before it") != std::string::npos;
    });
  };
  const TestSummary after = between(21, 41);
  REQUIRE(after.collapse.onset);
  const std::string said = fmt::format("at or before reading {}: readings are missing before it",
                                       after.collapse.onset->reading);
  CHECK(after.collapse.judged_until_reason == said);
  CHECK(warned(after));
  const TestSummary before = between(-300, -250);
  REQUIRE(before.collapse.onset);
  CHECK(std::fabs(*before.collapse.onset->time_s - onset_s) < 10);
  CHECK(before.collapse.judged_until_reason.empty());
  CHECK_FALSE(warned(before));
}

TEST_CASE("along a strain path without flow (R = 1) a collapse is judged") {
  Programme programme = load_programme("samples/programmes/strain_path_070.toml");
  programme.stages.back().strain_path_R = 1.0;
  VirtualRig rig(programme);
  const TestSummary s = run_session(rig, {});
  std::string said;
  for (const Warning& w : s.warnings) said += w.text + '\n';
  INFO(said);
  REQUIRE(s.truth);
  REQUIRE(s.truth->lost_sustainability);
  CHECK(s.collapse.detected());
  CHECK(s.collapse.judged_until_reason.empty());
  CHECK_FALSE(speaks_of(s, Quantity::back_volume));
  CHECK_FALSE(check(s, CheckKind::rate));
  REQUIRE(s.collapse.onset);
  CHECK(std::fabs(*s.collapse.onset->time_s - *s.truth->time_s) < 60);
}
