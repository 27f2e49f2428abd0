// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/sweep_command.hpp"

#include <fmt/format.h>

#include <QDateTime>
#include <algorithm>
#include <cstdio>
#include <exception>

#include "lab/base/bad_input.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "src/cli/interruption.hpp"
#include "src/cli/output_guard.hpp"
#include "src/cli/shared_options.hpp"
#include "src/output/notice.hpp"
#include "src/output/output.hpp"
#include "src/study/sweep/sweep_summary.hpp"
#include "src/triaxial/sweep_progress.hpp"
#include "src/triaxial/sweep_results.hpp"

namespace triax::src {
namespace {

lab::Sweep read_sweep(const std::vector<std::string>& texts) {
  std::vector<lab::SweepAxis> axes;
  axes.reserve(texts.size());
  for (const std::string& text : texts) axes.push_back(lab::read_sweep_axis(text));
  return lab::Sweep(std::move(axes));
}

/// The first test that can be read. All tests have the same keys: where none can be read, the sweep
/// is wrong and not one of its values.
lab::Programme first_readable(const lab::Sweep& sweep, const SweepOptions& o,
                              const std::string& text) {
  // Its own errors without the sweep's.
  static_cast<void>(lab::read_programme(text, o.programme, o.edits));
  std::exception_ptr first;
  for (std::int64_t place = 1; place <= sweep.size(); ++place) {
    try {
      return lab::read_programme(text, o.programme, study::edits_of_member(o.edits, sweep, place));
    } catch (const lab::BadInput& error) {
      if (!first)
        first = std::make_exception_ptr(
            lab::BadInput(fmt::format("--sweep [{}]: {}", sweep.label(place), error.what())));
    }
  }
  std::rethrow_exception(first);
}

std::string name_of_sweep(const lab::Programme& programme) {
  const auto now = QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs);
  return programme.name + ' ' + now.toStdString();
}

std::vector<study::SweepMember> run_all(const study::SweepJob& job) {
  const Interruption interruption;
  SweepProgress progress(job.sweep.size());
  return study::run_sweep(
      job, [&] { return interruption.requested(); },
      [&](const study::SweepCounts& counts) { progress.show(counts); });
}

void complain_of_failures(const lab::Sweep& sweep, const std::vector<study::SweepMember>& members) {
  for (const std::string& text : sweep_failures(sweep, members))
    std::fprintf(stderr, "triax: %s\n", text.c_str());
  const auto sum = study::summary_of(members);
  if (sum.not_run > 0)
    throw lab::WorkFailed(fmt::format(
        "the sweep was stopped by the operator: {} of {} tests are stored", sum.stored, sum.tests));
  if (sum.failed > 0)
    throw lab::WorkFailed(fmt::format("{} of {} tests of the sweep failed", sum.failed, sum.tests));
}

}  // namespace

void run_sweep_command(const SweepOptions& o) {
  const lab::Sweep sweep = read_sweep(o.sweeps);
  const std::string text = lab::read_text_file(o.programme);
  const lab::Programme programme = first_readable(sweep, o, text);
  refuse_overwriting("--db", o.db, programme.files, "part of the programme");
  const auto members = run_all({.file = o.programme,
                                .text = text,
                                .edits = o.edits,
                                .sweep = sweep,
                                .name = name_of_sweep(programme),
                                .db = o.db,
                                .speed = o.speed,
                                .jobs = chosen_jobs(o.jobs),
                                .patience = {.say = notify}});
  if (o.json)
    print_sweep_json(o.db, members);
  else
    print(sweep_text(sweep, members));
  complain_of_failures(sweep, members);
}

}  // namespace triax::src
