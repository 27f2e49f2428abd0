// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Limits for a process that handles foreign code or foreign data: the process of a plug-in
// (docs/how-to/laws.md lists them for users, with what is not contained) and the process that reads
// an uploaded record (docs/how-to/browser.md).
#include <cstddef>
#include <cstdint>

namespace triax::sim {

struct ProcessLimits {
  std::size_t memory_bytes = 0;  ///< address space beyond what the process has already
  std::uint64_t file_bytes = 0;  ///< length of any file that it writes
  std::uint64_t cpu_s = 0;       ///< processor time; 0: no limit
};

/// Before the process of a plug-in is made, in the one that makes it: where the kernel has no
/// Landlock, other processes of the same user (not of root) may not look into this one any more;
/// it then leaves no core file.
void hide_from_umats();

/// From here on, for the calling process and until it ends:
///
/// - it leads a process group of its own;
/// - it is killed by the kernel when the other end of the pipe `lifeline` is closed, whichever way
///   the process that holds it comes to its end;
/// - `limits` apply (RLIMIT_AS, RLIMIT_FSIZE, RLIMIT_CPU), and it leaves no core file;
/// - where the kernel has seccomp filters (x86-64 and arm64): signals to other processes, new
///   processes, other programs, other sessions, limits and memory of other processes, signals
///   that the kernel sends for a file (F_SETOWN, F_SETSIG) and letting go of `lifeline` are
///   refused (EPERM). Threads are not;
/// - where the kernel has Landlock (Linux 5.19): /proc/N of other processes shows neither their
///   memory nor their files.
///
/// Ends the process where the other end of `lifeline` is closed already.
void confine_process(int lifeline, const ProcessLimits& limits);

}  // namespace triax::sim
