// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/grains/grain_run.hpp"

#include "db/recording/grain_recorder.hpp"
#include "src/study/grains/grain_pieces.hpp"

namespace triax::study {

std::optional<db::StoredGrainRun> run_grains(const lab::GrainProgramme& programme,
                                             const lab::GrainRunOptions& options,
                                             const std::string& db, const lab::GrainListener& also,
                                             db::Patience patience) {
  std::optional<db::GrainRecorder> recorder(std::in_place, db, programme, std::move(patience));
  if (lab::run_grains(programme, options, {recorder->listener(), also})) recorder->finish();
  const std::int64_t id = recorder->id();
  const std::string path = recorder->path();
  recorder.reset();  // marks a run that did not finish
  if (id == 0) return std::nullopt;
  return db::GrainStore(path).load(id);
}

db::StoredGrainRun merge_grains(const lab::GrainProgramme& programme, int threads,
                                const std::string& db, const std::vector<std::string>& pieces,
                                db::Patience patience) {
  const lab::GrainsMade made = specimen_alone(programme, threads);
  const lab::GrainStageResult result = merge_grain_pieces(programme, made, pieces);
  db::GrainRecorder recorder(db, programme, std::move(patience));
  recorder.made(made);
  recorder.ended(result);
  const std::int64_t id = recorder.finish();
  return db::GrainStore(recorder.path()).load(id);
}

}  // namespace triax::study
