#include "src/commands/grains.hpp"

#include <fmt/format.h>

#include <memory>
#include <thread>

#include "db/grain_recorder.hpp"
#include "lab/grains/grain_files.hpp"
#include "lab/grains/grain_programme_reader.hpp"
#include "lab/records/bad_input.hpp"
#include "src/commands/interruption.hpp"
#include "src/commands/output_guard.hpp"
#include "src/commands/shared_options.hpp"
#include "src/output/output.hpp"
#include "src/output/task_progress.hpp"

namespace triax::src {
namespace {

struct Options {
  std::string programme;
  std::string db = "triax.db";
  std::string output;
  int threads = 0;
  bool json = false;
};

void run(const Options& o) {
  const lab::GrainProgramme programme = lab::load_grain_programme(o.programme);
  refuse_overwriting("--db", o.db, programme.files, "what the programme is read from");
  const Interruption interruption;
  TaskProgress progress(static_cast<int>(programme.stages.size()) + 1);
  progress.next("specimen");
  db::GrainRecorder recorder(o.db, programme);
  lab::GrainListener listener;
  listener.made = [&](const lab::GrainsMade& made) { recorder.made(made); };
  listener.begins = [&](const lab::GrainStage& stage, const sim::GrainState&) {
    progress.next(stage.name);
  };
  listener.ends = [&](const lab::GrainStage& stage, const sim::GrainState& state,
                      const lab::GrainStageResult& result) {
    recorder.ended(result);
    if (stage.save)
      lab::save_state(fmt::format("{}_{}.grains", o.output, lab::in_file_name(stage.name)), state);
  };
  listener.progress = [&](double share, const std::string& what) {
    progress.show(share, what);
    return !interruption.requested();
  };
  const int threads =
      o.threads > 0 ? o.threads : static_cast<int>(std::thread::hardware_concurrency());
  if (!lab::run_grains(programme, threads, listener))
    throw lab::WorkFailed("interrupted; the stages before are in the database");
  print(fmt::format("run {}\n", recorder.finish()));
}

}  // namespace

Command grains_command() {
  return {
      .name = "grains",
      .purpose = "run a programme on a specimen of grains (discrete elements)",
      .description = {},
      .diagnostics = {},
      .examples = {},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<Options>();
        app.add_option("PROGRAMME.toml", o->programme, "programme file")->required()->type_name("");
        app.add_option("--output", o->output, "files named PREFIX...")->type_name("PREFIX");
        app.add_option("--threads", o->threads, "threads [all cores]")
            ->check(CLI::Range(1, 64).description(""))
            ->type_name("N");
        add_db(app, o->db);
        add_json(app, o->json);
        return [o] { run(*o); };
      }};
}

}  // namespace triax::src
