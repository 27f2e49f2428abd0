// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the process of a plug-in may do. docs/umat.md says it for users, and what is not contained.
#include <cstddef>

namespace triax::sim {

/// Before the process of a plug-in is made, in the one that makes it: where the kernel has no
/// Landlock, other processes of the same user (not of root) may not look into this one any more;
/// it then leaves no core file.
void hide_from_umats();

/// From here on, for the calling process and until it ends:
///
/// - it leads a process group of its own;
/// - it is killed by the kernel when the other end of the pipe `lifeline` is closed, whichever way
///   the process that holds it comes to its end;
/// - it may have `memory_bytes` of address space beyond what it has, write 256 MB to a file, and
///   leaves no core file;
/// - where the kernel has seccomp filters (x86-64 and arm64): signals to other processes, new
///   processes, other programs, other sessions, limits and memory of other processes, signals
///   that the kernel sends for a file (F_SETOWN, F_SETSIG) and letting go of `lifeline` are
///   refused (EPERM). Threads are not;
/// - where the kernel has Landlock (Linux 5.19): /proc/N of other processes shows neither their
///   memory nor their files.
///
/// Ends the process where the other end of `lifeline` is closed already.
void confine_umat(int lifeline, std::size_t memory_bytes);

}  // namespace triax::sim
