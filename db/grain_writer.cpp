#include "db/grain_writer.hpp"

#include <SQLiteCpp/Statement.h>

#include <algorithm>
#include <numbers>

#include "db/columns.hpp"
#include "db/writer_identity.hpp"
#include "lab/grains/grain_words.hpp"
#include "sim/grains/state/triaxial_axes.hpp"

namespace triax::db {
namespace {

using SQLite::Statement;

std::string places(int count) {
  std::string text = "?";
  for (int k = 1; k < count; ++k) text += ",?";
  return text;
}

class StageRows {
 public:
  StageRows(SQLite::Database& database, std::int64_t run, std::int64_t stage)
      : database_(database), run_(run), stage_(stage) {}

  void operator()(const sim::GrainPathResult& path) {
    Statement insert(database_, "INSERT INTO grain_points VALUES (" + places(17) + ")");
    for (std::size_t k = 0; k < path.points.size(); ++k) {
      const sim::GrainPathPoint& p = path.points[k];
      row(insert, k)
          .number(p.time_s)
          .si(p.strain.axial, "%")
          .si(p.strain.radial, "%")
          .si(p.volumetric_strain, "%")
          .si(p.stress.axial, "kPa")
          .si(p.stress.radial, "kPa")
          .si(p.p_pa, "kPa")
          .si(p.q_pa, "kPa")
          .si(p.path_stress_pa, "kPa")
          .number(p.kinetic_energy_j)
          .number(p.unbalanced)
          .number(p.porosity)
          .number(p.coordination)
          .si(p.sliding_share, "%")
          .run();
    }
  }
  void operator()(const lab::GrainRest&) {}
  void operator()(const lab::GrainRose& rose) {
    Statement insert(database_, "INSERT INTO grain_probes VALUES (" + places(21) + ")");
    probe(insert, 0, rose.rose.null_probe, std::nullopt);
    for (std::size_t k = 0; k < rose.rose.probes.size(); ++k)
      probe(insert, k + 1, rose.rose.probes[k], rose.rose.probes[k].angle);
  }
  void operator()(const sim::PerturbationResult& result) {
    Statement insert(database_,
                     "INSERT INTO grain_perturbation_points VALUES (" + places(10) + ")");
    for (std::size_t k = 0; k < result.points.size(); ++k) {
      const sim::PerturbationPoint& p = result.points[k];
      row(insert, k)
          .number(p.time_s)
          .si(p.path_stress_pa, "kPa")
          .number(p.stress_share)
          .si(p.p_pa, "kPa")
          .si(p.axial_strain, "%")
          .number(p.kinetic_energy_j)
          .number(p.unbalanced)
          .run();
    }
  }
  void perturbation(const sim::Perturbation& how, const sim::PerturbationResult& result) {
    Statement insert(database_, "INSERT INTO grain_perturbations VALUES (" + places(6) + ")");
    Binder(insert)
        .integer(run_)
        .integer(stage_)
        .number(how.load_step_pa)
        .number(how.kinetic_energy_j)
        .integer(result.grains_hit)
        .number(result.most_kinetic_j)
        .run();
  }

 private:
  Binder row(Statement& insert, std::size_t number) {
    Binder binder(insert);
    binder.integer(run_).integer(stage_).integer(static_cast<std::int64_t>(number));
    return binder;
  }
  void probe(Statement& insert, std::size_t number, const sim::GrainProbe& p,
             std::optional<double> angle) {
    const sim::GrainWork& w = p.work;
    row(insert, number)
        .si(angle, "deg")
        .si(p.norm_pa, "kPa")
        .integer(p.settled ? 1 : 0)
        .number(p.strain.axial)
        .number(p.strain.radial)
        .number(w.lagrangian)
        .number(w.eulerian())
        .number(w.stress_part)
        .number(w.volume_part)
        .number(w.transport_part)
        .number(w.microscopic())
        .number(w.fixed_frame)
        .number(w.boundary_part)
        .number(w.normalised)
        .si(p.sliding_share, "%")
        .si(w.non_permanent_share(), "%")
        .number(p.most_kinetic_j)
        .integer(p.steps)
        .run();
  }

  SQLite::Database& database_;
  std::int64_t run_, stage_;
};

std::optional<double> ratio_of(const lab::GrainStage& stage) {
  if (const auto* path = std::get_if<lab::GrainPathStage>(&stage.work))
    return path->path.kind == sim::GrainPathKind::strain_path ? std::optional(path->path.ratio)
                                                              : std::nullopt;
  if (const auto* perturbed = std::get_if<lab::GrainPerturbationStage>(&stage.work))
    return perturbed->perturbation.ratio;
  return std::nullopt;
}

}  // namespace

std::int64_t insert_grain_run(SQLite::Database& database, const lab::GrainProgramme& programme,
                              const lab::GrainsMade& made, const std::string& recorded_at) {
  const lab::GrainSource& source = programme.grains;
  const bool loaded = !source.made();
  const sim::ContactLaw& law = made.state.law;
  const sim::GrainMeasures& m = made.measures;
  const auto if_made = [&](auto value) {
    return loaded ? std::nullopt : std::optional<decltype(value)>(value);
  };
  const WriterIdentity writer = this_process();
  Statement insert(
      database,
      "INSERT INTO grain_runs (name, source, programme, settings, state_file, status, recorded_at, "
      "grains, seed, "
      "compaction_friction_deg, compactions, stiffness_reading, stiffness_over_diameter_MPa, "
      "tangential_ratio, friction_angle_deg, density_kg_per_m3, damping, time_step_s, porosity, "
      "void_ratio, coordination, floating_grains, grains_outside, writer_pid, writer_started, "
      "writer_host) VALUES (?,?,?,?,?,'running'," +
          places(20) + ")");
  Binder(insert)
      .text(programme.name)
      .text(programme.source)
      .text(programme.text)
      .text_or_null(programme.settings)
      .text_or_null(source.state_file.empty() ? source.packing_file : source.state_file)
      .text(recorded_at)
      .integer(static_cast<std::int64_t>(made.state.grains.size()))
      .integer(if_made(static_cast<std::int64_t>(source.seed)))
      .si(if_made(made.compaction_friction_angle), "deg")
      .integer(if_made(static_cast<std::int64_t>(made.trials)))
      .text(lab::word(law.reading))
      .si(law.stiffness_over_diameter_pa, "MPa")
      .number(law.tangential_ratio)
      .si(law.friction_angle, "deg")
      .number(law.density_kg_per_m3)
      .number(law.damping)
      .number(made.state.time_step_s)
      .number(m.porosity)
      .number(m.void_ratio)
      .number(m.coordination)
      .integer(m.floating_grains)
      .integer(m.grains_outside)
      .integer(writer.pid)
      .integer(writer.started)
      .text(writer.host)
      .run();
  return database.getLastInsertRowid();
}

void insert_grain_stage(SQLite::Database& database, std::int64_t run, std::int64_t number,
                        const lab::GrainStageResult& result) {
  const lab::GrainStage& stage = *result.stage;
  const sim::GrainMeasures& m = result.after;
  const auto settled = lab::settled(result);
  Statement insert(database, "INSERT INTO grain_stages VALUES (" + places(17) + ")");
  Binder(insert)
      .integer(run)
      .integer(number)
      .text(stage.name)
      .text(stage.action)
      .text(stage.from)
      .number(ratio_of(stage))
      .text(lab::ending(result))
      .integer(settled ? std::optional<std::int64_t>(*settled ? 1 : 0) : std::nullopt)
      .number(m.porosity)
      .number(m.coordination)
      .integer(m.floating_grains)
      .si(m.wall_stress_pa[sim::kAxial], "kPa")
      .si(0.5 * (m.wall_stress_pa[sim::kRadial[0]] + m.wall_stress_pa[sim::kRadial[1]]), "kPa")
      .number(m.unbalanced)
      .number(m.kinetic_energy_j)
      .integer(result.steps)
      .number(result.seconds > 0 ? std::optional(result.seconds) : std::nullopt)
      .run();
  StageRows rows(database, run, number);
  std::visit(rows, result.outcome);
  if (const auto* work = std::get_if<lab::GrainPerturbationStage>(&stage.work))
    rows.perturbation(work->perturbation, std::get<sim::PerturbationResult>(result.outcome));
}

}  // namespace triax::db
