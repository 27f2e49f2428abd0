#include "src/study/triaxial/test_run.hpp"

#include "db/recorder.hpp"
#include "lab/base/bad_input.hpp"

namespace triax::study {

std::int64_t run_test(lab::BackEnd& back_end, const lab::SessionOptions& options,
                      const std::string& db, const std::function<void(lab::Session&)>& also) {
  lab::Session session;
  db::Recorder recorder(db);
  recorder.listen(session);
  if (also) also(session);
  try {
    return recorder.finish(session.run(back_end, options));
  } catch (const lab::BadInput&) {
    recorder.discard();
    throw;
  }
}

}  // namespace triax::study
