// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An uploaded record is foreign data: a process of its own reads it (docs/how-to/browser.md). The
// process has limits of memory, file length and processor time, cannot start others, runs at low
// priority and does not outlive this program (sim/materials/process_confinement.hpp).
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "src/page/record/record_reading.hpp"

namespace triax::src {

/// As read_record(), in a process of this program that is killed and reaped once `stop` returns
/// true, which is asked ten times a second. `cpu_s` limits its processor time. If the process does
/// not return a result, nothing of the test stays in the database. Throws Refused if it was stopped
/// or exceeded a limit, lab::WorkFailed if it failed. `record.writer` is not used.
std::string read_record_apart(RecordToRead record, const Upload& upload, std::uint64_t cpu_s,
                              const std::function<bool()>& stop);

/// The name of the hidden command that main() forwards to run_record_process().
inline constexpr const char* kReadRecordCommand = "--read-record";
/// Life of that process; `arguments` come after the command's name.
[[noreturn]] void run_record_process(const std::vector<std::string>& arguments);

}  // namespace triax::src
