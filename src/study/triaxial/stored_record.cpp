// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/triaxial/stored_record.hpp"

#include <fmt/format.h>

#include "db/store.hpp"
#include "lab/base/bad_input.hpp"

namespace triax::study {

StoredRecord::StoredRecord(const std::string& path, const lab::RecordHeader& header) {
  if (!path.empty()) writer_.emplace(path, header);
}

std::string StoredRecord::write(const lab::BackEnd& rig, const std::string& db, std::int64_t id) {
  if (writer_) try {
      db::Store(db).for_each_scan(id, 1, [this](const lab::Reading& reading, const lab::State&) {
        writer_->write(reading);
      });
      writer_->finish(rig.header(), rig.truth());
    } catch (const lab::WorkFailed& failure) {
      return fmt::format("{}; the test itself is stored", failure.what());
    }
  return {};
}

}  // namespace triax::study
