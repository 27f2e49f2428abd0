// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/remote_rig.hpp"

#include <memory>
#include <utility>

#include "lab/rig/rig_header.hpp"

namespace triax::lab {
namespace {

/// What the instruments say belongs to the record.
RecordHeader remote_header(const Programme& programme, const RigFile& rig,
                           const RemoteApparatus& apparatus) {
  RecordHeader header = rig_header(programme, programme.seed);
  header.notes = apparatus.instruments().identities();
  header.notes.insert(header.notes.begin(), {.label = "rig", .text = rig.name});
  if (!apparatus.instruments().simulated()) {
    header.origin = Origin::recorded;
    header.seed.reset();
  }
  return header;
}

}  // namespace

struct RemoteRig::Linked {
  GuardedProgramme programme;
  RecordHeader header;
  std::unique_ptr<RemoteApparatus> apparatus;

  Linked(LineLoop& loop, const RigFile& rig, Programme given, const std::function<bool()>& stop) {
    given.faults.clear();
    programme = with_guard_stages(std::move(given));
    apparatus = std::make_unique<RemoteApparatus>(loop, rig, programme.programme, stop);
    apparatus->connect(kConnect_s);
    header = remote_header(programme.programme, rig, *apparatus);
  }
};

RemoteRig::RemoteRig(LineLoop& loop, const RigFile& rig, const Programme& programme,
                     const std::function<bool()>& stop)
    : RemoteRig(Linked(loop, rig, programme, stop)) {}

RemoteRig::RemoteRig(Linked linked)
    : RigSoftware(linked.programme, std::move(linked.header), std::move(linked.apparatus)) {}

}  // namespace triax::lab
