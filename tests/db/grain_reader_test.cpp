// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/grain_reader.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>

#include "db/connection.hpp"
#include "db/recording/grain_recorder.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/grains/grain_programme_reader.hpp"
#include "sim/grains/state/triaxial_axes.hpp"
#include "tests/db/temporary_folder.hpp"
#include "tests/lab/grains/small_programme.hpp"

using namespace triax;

namespace {

/// With a second mark, which is never reached.
const lab::GrainProgramme& programme() {
  static const auto read = lab::read_grain_programme(
      test::replaced(test::kSmallGrains, "value = 0.2}",
                     "value = 0.2}, {name = \"never\", quantity = \"stress_ratio\", value = 1.4}"),
      "g.toml");
  return read;
}

struct Ran {
  lab::GrainsMade made;
  std::vector<lab::GrainStageResult> results;
};
const Ran& ran() {
  static const Ran all = [] {
    Ran r;
    lab::GrainListener listener;
    listener.made = [&](const lab::GrainsMade& made) { r.made = made; };
    listener.stage_ended = [&](const lab::GrainStage&, const sim::GrainState&,
                               const lab::GrainStageResult& result) {
      r.results.push_back(result);
    };
    lab::run_grains(programme(), {}, {listener});
    return r;
  }();
  return all;
}

/// Every number of a value as its bits, one after the other: two values are the same where these
/// are.
class Bits {
 public:
  Bits& operator<<(double value) {
    bits_.push_back(std::bit_cast<std::uint64_t>(value));
    return *this;
  }
  Bits& operator<<(std::int64_t value) {
    bits_.push_back(static_cast<std::uint64_t>(value));
    return *this;
  }
  Bits& operator<<(const sim::GrainMeasures& m) {
    for (const double stress : m.wall_stress_pa) *this << stress;
    return *this << m.porosity << m.void_ratio << m.coordination << m.kinetic_energy_j
                 << m.unbalanced << m.grain_contacts << m.wall_contacts << m.sliding_contacts
                 << m.floating_grains << m.grains_outside;
  }
  Bits& operator<<(const sim::GrainPathPoint& p) {
    return *this << p.time_s << p.strain.axial << p.strain.radial << p.volumetric_strain
                 << p.stress.axial << p.stress.radial << p.p_pa << p.q_pa << p.path_stress_pa
                 << p.kinetic_energy_j << p.unbalanced << p.porosity << p.coordination
                 << p.sliding_share;
  }
  Bits& operator<<(const sim::GrainLedger& l) {
    for (const auto* of : {&l.walls_impulse, &l.damping_impulse, &l.stopped_impulse,
                           &l.momentum_start, &l.momentum_end})
      for (const double component : *of) *this << component;
    return *this << l.walls_j << l.friction_j << l.damping_j << l.stopped_j << l.elastic_start_j
                 << l.elastic_end_j << l.kinetic_start_j << l.kinetic_end_j;
  }
  Bits& operator<<(const sim::GrainProbe& p) {
    const sim::GrainWork& w = p.work;
    *this << p.ledger << p.norm_strain << w.contacts_turning << w.grains_turning << w.out_of_balance
          << w.gap_left();
    return *this << p.angle << p.norm_pa << std::int64_t{p.at_rest} << std::int64_t{p.stopped}
                 << p.stress.axial << p.stress.radial << p.strain.axial << p.strain.radial
                 << w.lagrangian << w.stress_part << w.volume_part << w.transport_part
                 << w.normalised << w.normal_part << w.tangential_part << w.non_permanent_part
                 << w.fixed_frame << w.boundary_part << w.non_permanent_share() << p.most_kinetic_j
                 << p.sliding_share << p.steps << p.unbalanced << p.stress_error_pa;
  }
  Bits& operator<<(const sim::PerturbationPoint& p) {
    return *this << p.time_s << p.path_stress_pa << p.stress_share << p.p_pa << p.axial_strain
                 << p.kinetic_energy_j << p.unbalanced;
  }
  Bits& operator<<(const lab::ReportedGrains& g) {
    return *this << g.grains << g.smallest_m << g.median_m << g.largest_m
                 << g.law.stiffness_over_diameter_pa << g.law.tangential_ratio
                 << g.law.friction_angle << g.law.density_kg_per_m3 << g.law.damping
                 << g.time_step_s << static_cast<std::int64_t>(g.seed)
                 << g.compaction_friction.value_or(-1) << g.compaction_pressure.value_or(-1)
                 << g.porosity_wanted.value_or(-1) << std::int64_t{g.trials} << g.measures;
  }
  Bits& operator<<(const lab::ReportedGrainPath& came) {
    *this << came.path.ratio << came.path.strain_rate_per_s << came.path.load_rate_pa_per_s
          << std::int64_t{came.path.samples} << std::int64_t{came.marks_stored};
    for (const auto& point : came.points) *this << point;
    for (const auto& mark : came.marks) *this << mark.at.value_or(sim::GrainPathPoint{});
    return *this;
  }
  Bits& operator<<(const lab::ReportedGrainRest& came) {
    const auto& settling = came.rest.settling;
    return *this << std::int64_t{came.strain_held} << std::int64_t{came.rest.at_rest}
                 << settling.steps << settling.unbalanced << settling.stress_error_pa
                 << came.rest.path_stress_pa;
  }
  Bits& operator<<(const lab::ReportedGrainRose& came) {
    *this << std::int64_t{came.kind == sim::ProbeKind::strain} << came.norm_strain;
    *this << came.norm_pa << came.made.stress.axial << came.made.stress.radial
          << std::int64_t{came.parts_stored} << came.made.rose.null_probe;
    for (const double angle : came.made.angles) *this << angle;
    for (const auto& probe : came.made.rose.probes) *this << probe;
    return *this;
  }
  Bits& operator<<(const lab::ReportedPerturbation& came) {
    *this << came.how.ratio << came.how.load_step_pa << came.how.kinetic_energy_j
          << came.how.floating_share << static_cast<std::int64_t>(came.how.seed) << came.grains_hit
          << came.most_kinetic_j << std::int64_t{came.seed_stored};
    for (const auto& point : came.points) *this << point;
    return *this;
  }
  Bits& operator<<(const lab::ReportedGrainStage& stage) {
    *this << stage.before << stage.after << stage.strain_before.axial << stage.strain_before.radial
          << stage.seconds << stage.steps << stage.ledger.value_or(sim::GrainLedger{})
          << std::int64_t{stage.ledger.has_value()}
          << static_cast<std::int64_t>(stage.came.index());
    std::visit([&](const auto& came) { *this << came; }, stage.came);
    return *this;
  }
  friend bool operator==(const Bits&, const Bits&) = default;

 private:
  std::vector<std::uint64_t> bits_;
};

template <class T>
Bits bits(const T& value) {
  Bits all;
  all << value;
  return all;
}

std::int64_t record_grains(const std::string& path, std::size_t stages, bool finish = true) {
  db::GrainRecorder recorder(path, programme());
  recorder.made(ran().made);
  for (std::size_t k = 0; k < stages; ++k) recorder.ended(ran().results.at(k));
  return finish ? recorder.finish() : recorder.id();
}

}  // namespace

TEST_CASE("a run of grains comes back from the database to the bit") {
  testing::TemporaryFolder folder;
  const auto id = record_grains(folder.file("t.db"), 7);
  const db::StoredGrainRun run = db::GrainStore(folder.file("t.db")).load(id);
  CHECK(run.id == id);
  CHECK(run.status == db::TestStatus::complete);
  CHECK(run.recorded_at.size() == 20);
  CHECK(run.whole);
  CHECK(run.report.programme == "small");
  CHECK(run.report.source == "g.toml");
  REQUIRE(run.report.specimen);
  CHECK(run.report.specimen->state_file.empty());
  CHECK(run.report.specimen->law.reading == ran().made.state.law.reading);
  CHECK(bits(*run.report.specimen) == bits(lab::reported(programme().grains, ran().made)));
  REQUIRE(run.report.stages.size() == 7);
  for (std::size_t k = 0; k < 7; ++k) {
    const auto& read = run.report.stages[k];
    const auto truth = lab::reported(ran().results[k]);
    INFO(truth.name);
    CHECK(read.name == truth.name);
    CHECK(read.action == truth.action);
    CHECK(read.from == truth.from);
    CHECK(bits(read) == bits(truth));
  }
}

TEST_CASE("probes by strain come back to the bit, without a norm of stress") {
  testing::TemporaryFolder folder;
  lab::GrainStageResult result = ran().results.at(3);
  lab::GrainStage stage = *result.stage;
  auto& how = std::get<lab::GrainProbeStage>(stage.work).probing;
  how.kind = sim::ProbeKind::strain;
  how.norm_strain = 3e-6;
  for (auto& probe : std::get<lab::GrainRose>(result.outcome).rose.probes) {
    probe.norm_strain = 3e-6;
    probe.norm_pa = 0;
  }
  result.stage = &stage;
  {
    db::GrainRecorder recorder(folder.file("t.db"), programme());
    recorder.made(ran().made);
    recorder.ended(result);
    recorder.finish();
  }
  const auto run = db::GrainStore(folder.file("t.db")).load(1);
  CHECK(bits(run.report.stages.at(0)) == bits(lab::reported(result)));
  auto d = db::open_for_reading(folder.file("t.db"));
  CHECK(d.execAndGet("SELECT count(*) FROM grain_probes WHERE norm_kPa IS NULL").getInt() == 5);
  CHECK(d.execAndGet("SELECT norm_strain FROM grain_roses").getDouble() == 3e-6);
}

TEST_CASE("the energy of stages and probes is stored, and its rows add up") {
  testing::TemporaryFolder folder;
  record_grains(folder.file("t.db"), 7);
  auto d = db::open_for_reading(folder.file("t.db"));
  // Six stages have one, the rose has one for each of its five probes.
  CHECK(d.execAndGet("SELECT count(*) FROM grain_energies").getInt() == 11);
  CHECK(d.execAndGet("SELECT count(*) FROM grain_momenta").getInt() == 33);
  CHECK(d.execAndGet("SELECT count(*) FROM grain_energies WHERE abs(walls_J - (elastic_end_J - "
                     "elastic_start_J) - (kinetic_end_J - kinetic_start_J) - friction_J - "
                     "damping_J - stopped_J - error_J) < 1e-12 AND abs(error_J) < 1e-3 * "
                     "(abs(walls_J) + elastic_end_J + kinetic_end_J)")
            .getInt() == 11);
  CHECK(d.execAndGet("SELECT count(*) FROM grain_momenta WHERE abs(start_kg_m_per_s + "
                     "walls_kg_m_per_s + damping_kg_m_per_s - stopped_kg_m_per_s - "
                     "end_kg_m_per_s) < 1e-12")
            .getInt() == 33);
  CHECK(d.execAndGet("SELECT count(*) FROM grain_gaps g JOIN grain_probes p USING (run_id, stage, "
                     "number) WHERE abs(p.work_microscopic_J_per_m3 - p.work_lagrangian_J_per_m3 "
                     "- g.contacts_turning_J_per_m3 - g.grains_turning_J_per_m3 - "
                     "g.out_of_balance_J_per_m3 - g.left_J_per_m3) < 1e-12")
            .getInt() == 5);
}

TEST_CASE("ends, kinds and marks of a run of grains come back") {
  testing::TemporaryFolder folder;
  record_grains(folder.file("t.db"), 7);
  const auto run = db::GrainStore(folder.file("t.db")).load(1);
  for (std::size_t k : {0, 1, 4}) {
    const auto& read = std::get<lab::ReportedGrainPath>(run.report.stages[k].came);
    const auto truth = lab::reported(ran().results[k]);
    const auto& wanted = std::get<lab::ReportedGrainPath>(truth.came);
    CHECK(read.path.kind == wanted.path.kind);
    CHECK(read.end == wanted.end);
  }
  const auto& marks = std::get<lab::ReportedGrainPath>(run.report.stages[1].came).marks;
  REQUIRE(marks.size() == 2);
  CHECK(marks[0].name == "a point");
  CHECK(marks[0].at);
  CHECK(marks[1].name == "never");
  CHECK_FALSE(marks[1].at);
  CHECK(std::get<lab::ReportedPerturbation>(run.report.stages[6].came).end ==
        std::get<sim::PerturbationResult>(ran().results[6].outcome).end);
}

TEST_CASE("of an interrupted run of grains the stages that had ended are read") {
  testing::TemporaryFolder folder;
  const auto id = record_grains(folder.file("t.db"), 2, false);
  const auto run = db::GrainStore(folder.file("t.db")).load(id);
  CHECK(run.status == db::TestStatus::interrupted);
  REQUIRE(run.report.stages.size() == 2);
  CHECK(run.report.stages[1].name == "drained");
  CHECK(run.whole);
}

TEST_CASE("of several runs of grains each has its own stages; the latest of a name is meant") {
  testing::TemporaryFolder folder;
  record_grains(folder.file("t.db"), 3);
  record_grains(folder.file("t.db"), 5);
  const db::GrainStore store(folder.file("t.db"));
  CHECK(store.all() == std::vector<std::int64_t>{1, 2});
  CHECK(store.load(1).report.stages.size() == 3);
  CHECK(store.load(2).report.stages.size() == 5);
  CHECK(store.find("small") == 2);
  CHECK(store.find("1") == 1);
  CHECK_FALSE(store.find("small_"));
  CHECK_FALSE(store.find("3"));
  CHECK_THROWS_AS(store.load(3), lab::BadInput);
}

TEST_CASE("of a run of grains of an older schema what it did not store is not known") {
  testing::TemporaryFolder folder;
  {
    SQLite::Database d(folder.file("t.db"), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    db::migrate(d, "t.db", 5);
    d.exec(
        "INSERT INTO grain_runs (id, name, source, programme, status, recorded_at, grains, seed, "
        "stiffness_reading, stiffness_over_diameter_MPa, tangential_ratio, friction_angle_deg, "
        "density_kg_per_m3, damping, time_step_s, porosity, void_ratio, coordination, "
        "floating_grains, grains_outside, writer_pid, writer_started, writer_host) VALUES (4, "
        "'old', 'o.toml', '', 'complete', '', 500, 9, 'literal', 356, 0.42, 35, 3000, 0.2, 2e-6, "
        "0.4, 0.66, 3.5, 12, 0, 1, 1, 'h');"
        "INSERT INTO grain_stages VALUES (4, 1, 'path', 'strain_path', 'specimen', 0.8, "
        "'collapse', NULL, 0.41, 3.4, 13, 90, 60, 1e-4, 1e-6, 1000, 2.5), "
        "(4, 2, 'rose', 'probes', 'path', NULL, 'all at rest', 1, 0.41, 3.4, 13, 90, 60, 1e-4, "
        "1e-6, 4000, NULL), (4, 3, 'held', 'equilibrium', 'path', NULL, 'settled', 1, 0.41, 3.4, "
        "13, 90, 60, 1e-4, 1e-6, 700, NULL);"
        "INSERT INTO grain_points VALUES (4, 1, 0, 0.5, -1, 0.6, 0.2, 90, 60, 70, 30, 15, 1e-6, "
        "1e-4, 0.4, 3.4, 2);"
        "INSERT INTO grain_probes VALUES (4, 2, 0, NULL, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, "
        "0.1, 0, 0, 100), (4, 2, 1, 0, 1, 1, 1e-5, 0, 0.01, 0.01, 0.009, 0, 0.001, 0.012, 0.01, "
        "0, 0.5, 0.3, 0.2, 1e-9, 4000)");
  }
  const auto run = db::GrainStore(folder.file("t.db")).load(4);
  CHECK_FALSE(run.whole);
  REQUIRE(run.report.specimen);
  CHECK(run.report.specimen->seed == 9);
  CHECK(run.report.specimen->law.reading == sim::StiffnessReading::literal);
  CHECK(run.report.specimen->law.friction_angle == Approx(0.6108652381980153));
  CHECK(std::isnan(run.report.specimen->median_m));
  CHECK(run.report.specimen->measures.porosity == 0.4);
  CHECK(run.report.specimen->measures.grain_contacts == lab::kNotStored);
  REQUIRE(run.report.stages.size() == 3);
  CHECK(std::isnan(run.report.stages[0].before.porosity));
  CHECK(run.report.stages[0].after.porosity == 0.41);
  CHECK(run.report.stages[0].after.floating_grains == 13);
  CHECK(run.report.stages[0].after.wall_stress_pa[sim::kRadial[1]] == Approx(60e3));
  CHECK(run.report.stages[0].seconds == 2.5);
  const auto& path = std::get<lab::ReportedGrainPath>(run.report.stages[0].came);
  CHECK(path.path.kind == sim::GrainPathKind::strain_path);
  CHECK(path.path.ratio == 0.8);
  CHECK(path.path.samples == 0);
  CHECK(path.path.strain_rate_per_s < 0);
  CHECK(path.end == sim::GrainPathEnd::collapse);
  CHECK_FALSE(path.marks_stored);
  REQUIRE(path.points.size() == 1);
  CHECK(path.points[0].q_pa == Approx(30e3));
  const auto& rose = std::get<lab::ReportedGrainRose>(run.report.stages[1].came);
  CHECK_FALSE(rose.parts_stored);
  CHECK(rose.norm_pa == Approx(1000));
  CHECK(rose.made.stress.axial == Approx(90e3));
  REQUIRE(rose.made.rose.probes.size() == 1);
  CHECK(rose.made.rose.probes[0].work.microscopic() == Approx(0.012));
  CHECK(rose.made.rose.probes[0].work.non_permanent_share() == Approx(0.002));
  CHECK(std::isnan(rose.made.rose.probes[0].stress.axial));
  CHECK(rose.kind == sim::ProbeKind::stress);
  CHECK(std::isnan(rose.made.rose.probes[0].work.boundary_part));
  CHECK(std::isnan(rose.made.rose.probes[0].work.grains_turning));
  CHECK(std::isnan(rose.made.rose.probes[0].ledger.energy_error_share()));
  CHECK(std::isnan(rose.made.rose.probes[0].ledger.momentum_error()));
  CHECK_FALSE(run.report.stages[0].ledger);
  const auto& rest = std::get<lab::ReportedGrainRest>(run.report.stages[2].came);
  CHECK(rest.strain_held);
  CHECK(rest.rest.at_rest);
  CHECK(db::open_for_reading(folder.file("t.db"))
            .execAndGet("SELECT ending FROM grain_stages WHERE number = 3")
            .getString() == "at rest");
  CHECK(rest.rest.settling.steps == lab::kNotStored);
  CHECK(run.report.stages[2].steps == 700);
  CHECK(std::isnan(rest.rest.path_stress_pa));
}
