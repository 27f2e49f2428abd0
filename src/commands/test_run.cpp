#include "src/commands/test_run.hpp"

#include "db/recorder.hpp"
#include "lab/records/bad_input.hpp"
#include "src/output/progress_bar.hpp"

namespace triax::src {

std::int64_t run_test(lab::BackEnd& back_end, const lab::SessionOptions& options,
                      const std::string& db, const std::string& label,
                      const std::function<void(lab::Session&)>& also) {
  lab::Session session;
  db::Recorder recorder(db);
  ProgressBar bar(label);
  recorder.listen(session);
  QObject::connect(&session, &lab::Session::progressed,
                   [&bar](double fraction) { bar.show(fraction); });
  if (also) also(session);
  try {
    return recorder.finish(session.run(back_end, options));
  } catch (const lab::BadInput&) {
    recorder.discard();
    throw;
  }
}

}  // namespace triax::src
