// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/test_run.hpp"

#include <utility>

#include "db/recording/recorder.hpp"
#include "lab/base/bad_input.hpp"

namespace triax::study {

std::int64_t run_test(lab::BackEnd& back_end, const lab::SessionOptions& options, std::string& db,
                      lab::SessionListeners also, db::Patience patience,
                      std::function<void(std::int64_t)> entered, const std::string& writer) {
  db::Recorder recorder(db, std::move(patience), writer);
  recorder.knows(options.earlier);
  if (entered) recorder.when_entered(std::move(entered));
  also.insert(also.begin(), recorder.listener());
  try {
    const std::int64_t id = recorder.finish(lab::run_session(back_end, options, also));
    db = recorder.path();
    return id;
  } catch (const lab::BadInput&) {
    recorder.discard();
    throw;
  }
}

}  // namespace triax::study
