// SPDX-License-Identifier: GPL-3.0-or-later
// A simulation and the replay of its record are the same test, to the bit.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>

#include "lab/base/toml_reader.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "lab/records/record_writer.hpp"
#include "lab/rig/recorded.hpp"
#include "lab/rig/session.hpp"
#include "lab/rig/simulated/virtual_rig.hpp"
#include "tests/lab/rig/rig_text.hpp"

using namespace triax;
using namespace triax::lab;

namespace {

const std::string kProgramme = "samples/programmes/icu_6.toml";
const std::string kRecord = "samples/records/icu_6.csv";

std::string simulated_record(std::uint64_t seed) {
  const auto path = (std::filesystem::temp_directory_path() /
                     ("triax_simulated_" + std::to_string(::getpid()) + ".csv"))
                        .string();
  VirtualRig rig(load_programme(kProgramme), seed);
  RecordWriter writer(path, rig.header());
  for (Reading reading; rig.next(reading);) writer.write(reading);
  writer.finish(rig.header(), rig.truth());
  auto text = read_text_file(path);
  std::filesystem::remove(path);
  return text;
}

std::string exact(double value) { return fmt::format("{:a}", value); }
template <class Value>
std::string exact(const std::optional<Value>& value) {
  return value ? exact(static_cast<double>(*value)) : "unknown";
}
std::string exact(const std::optional<Instant>& i) {
  if (!i) return "unknown";
  return fmt::format("{} {} {} {} {} {}", i->reading, exact(i->time_s), exact(i->axial_strain),
                     exact(i->q_pa), exact(i->p_eff_pa), exact(i->pore_pressure_pa));
}

/// What a test came to, every number with all its bits.
std::vector<std::string> verdict(const TestSummary& s) {
  const Consolidation& c = s.consolidation;
  std::vector<std::string> lines{
      std::string(to_string(s.collapse.kind)),
      exact(s.collapse.inside_limit_surface),
      exact(s.collapse.onset),
      exact(s.collapse.second_order_work_normalised),
      exact(s.collapse.second_order_work_error),
      exact(s.collapse.limit_stress_ratio),
      s.collapse.limit_source,
      exact(s.peak),
      fmt::format("{} {} {} {} {}", exact(c.p_eff_pa), exact(c.b_value), exact(c.void_ratio),
                  exact(c.height_m), exact(c.diameter_m)),
      std::to_string(s.readings)};
  for (const Criterion& one : s.collapse.criteria)
    lines.push_back(fmt::format("{} {} {} {} {} {}", one.name, one.found(), exact(one.reading),
                                exact(one.time_s), exact(one.eta), one.evidence));
  for (const Check& one : s.checks)
    lines.push_back(fmt::format("{} {} {}", to_string(one.kind), exact(one.measured), one.ok));
  return lines;
}

struct SimulatedRun {
  std::vector<double> readings, states;
  std::vector<std::string> events, verdict;
  TestSummary summary;
};

SimulatedRun run_and_collect(BackEnd& rig, double speed = 0) {
  SimulatedRun result;
  SessionListener listener;
  listener.scanned = [&](const Reading& r, const State& s) {
    auto& readings = result.readings;
    readings.insert(readings.end(), {static_cast<double>(r.number), r.time_s, double(r.stage)});
    readings.insert(readings.end(), r.si.begin(), r.si.end());
    result.states.insert(
        result.states.end(),
        {s.time_s, s.strain.axial, s.strain.radial, s.volumetric_strain, s.void_ratio, s.area_m2,
         s.effective_stress.axial, s.effective_stress.radial, s.pore_pressure, s.p_eff, s.q});
  };
  listener.happened = [&](const Event& e) {
    result.events.push_back(fmt::format("{} {} {}", e.reading, to_string(e.kind), e.detail));
  };
  result.summary = run_session(rig, {.reduction = {}, .speed = speed}, {listener});
  result.verdict = verdict(result.summary);
  return result;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

void check_same(const SimulatedRun& a, const SimulatedRun& b) {
  CHECK(a.readings.size() > 10'000);
  CHECK(same_bits(a.readings, b.readings));
  CHECK(same_bits(a.states, b.states));
  CHECK(a.events == b.events);
  CHECK(a.verdict == b.verdict);
}

/// A file of which every read gives only a few bytes.
class Dribble : public ByteSource {
 public:
  Dribble(const std::string& path, std::size_t most) : file_(open_file(path)), most_(most) {}
  const std::string& name() const override { return file_->name(); }
  std::uint64_t size() const override { return file_->size(); }
  std::size_t read(std::span<char> into) override {
    return file_->read(into.first(std::min(most_, into.size())));
  }
  void rewind() override { file_->rewind(); }

 private:
  std::unique_ptr<ByteSource> file_;
  std::size_t most_;
};

}  // namespace

TEST_CASE("the same seed writes the same file, and the sample is that file") {
  const auto first = simulated_record(6);
  CHECK(first == simulated_record(6));
  CHECK(first != simulated_record(7));
  const auto sample = read_text_file(kRecord);
  CHECK(sample.size() < 400'000);
  // The truth holds all digits of the law's integration, in which another machine's mathematical
  // library may differ; instruments round that away.
  const auto truth = sample.find("# [truth]");
  REQUIRE(truth != std::string::npos);
  CHECK(first.substr(0, truth) == sample.substr(0, truth));
}

TEST_CASE("replaying the record of a simulation is the simulation, to the bit") {
  VirtualRig simulated(load_programme(kProgramme));
  const SimulatedRun original = run_and_collect(simulated);
  const auto recorded = open_record(kRecord, {});
  const SimulatedRun replayed = run_and_collect(*recorded);
  check_same(original, replayed);
  CHECK(recorded->header().origin == Origin::simulated);
  CHECK(recorded->header().warnings.empty());
  CHECK(original.summary.collapse.kind == CollapseKind::flow);
  REQUIRE(replayed.summary.truth);
  CHECK(*replayed.summary.truth->time_s == Approx(*original.summary.truth->time_s));
  CHECK(*replayed.summary.truth->q_pa == Approx(*original.summary.truth->q_pa));
  CHECK(*replayed.summary.collapse.onset->time_s ==
        Approx(*original.summary.truth->time_s).margin(20));
}

TEST_CASE("neither speed nor the size of a read changes anything") {
  const auto whole = open_record(kRecord, {});
  const SimulatedRun expected = run_and_collect(*whole);
  for (const std::size_t most : {1U, 7U, 1000U}) {
    RecordedRig rig(std::make_unique<Dribble>(kRecord, most), {}, "", "");
    check_same(expected, run_and_collect(rig));
  }
  const auto paced = open_record(kRecord, {});
  check_same(expected, run_and_collect(*paced, 50'000));
  VirtualRig simulated(load_programme(kProgramme));
  check_same(expected, run_and_collect(simulated, 50'000));
}

TEST_CASE("why a test was cut short stands in its record: the replay is not judged either") {
  const auto path = (std::filesystem::temp_directory_path() /
                     ("triax_cut_" + std::to_string(::getpid()) + ".csv"))
                        .string();
  VirtualRig rig(
      test::rig_programme(test::shear_stage("closed", "displacement", "axial_rate_mm_per_min = 0.5",
                                            R"("axial_strain_pct", above = 10.0)"),
                          test::kIdealFrame + "load_limit_N = 60.0\n"));
  RecordWriter writer(path, rig.header());
  for (Reading reading; rig.next(reading);) writer.write(reading);
  writer.finish(rig.header(), rig.truth());
  const std::string why = rig.header().cut_short;
  CHECK_THAT(why, Catch::Contains("emergency stop"));

  const auto recorded = open_record(path, {});
  const Collapse replayed = run_session(*recorded, {}).collapse;
  CHECK(recorded->header().cut_short == why);
  CHECK_FALSE(replayed.judged);
  CHECK(replayed.judged_until_reason == why);

  // Said by hand of a record that does not say it.
  const auto said =
      open_record(kRecord, {.dialect = {}, .sets = {{"test.cut_short", "power cut"}}});
  CHECK(said->header().cut_short == "power cut");
  std::filesystem::remove(path);
}
