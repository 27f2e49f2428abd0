// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>

namespace triax::db {

/// Who writes a test. A process number alone is used again; with its start time it is not.
struct WriterIdentity {
  std::int64_t pid = 0;
  std::int64_t started = 0;  ///< clock ticks since boot; 0 if there is no such process
  std::string host;
};

WriterIdentity this_process();
/// False only if the writer was on this host and is certainly gone.
bool may_be_alive(const WriterIdentity& writer);

}  // namespace triax::db
