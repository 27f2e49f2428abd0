// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the process of a plug-in may do. docs/umat.md says it for users, and what is not contained.
#include <cstddef>

namespace triax::sim {

/// From here on, for the calling process and until it ends:
///
/// - it leads a process group of its own;
/// - it is killed by the kernel when the other end of the pipe `lifeline` is closed, whichever way
///   the process that holds it comes to its end;
/// - it may have `memory_bytes` of address space beyond what it has, write 256 MB to a file, and
///   leaves no core file;
/// - where the kernel has seccomp filters (x86-64 and arm64): signals to other processes, new
///   processes, other programs, other sessions, the memory of other processes and letting go of
///   `lifeline` are refused (EPERM). Threads are not.
///
/// Ends the process where the other end of `lifeline` is closed already.
void confine_umat(int lifeline, std::size_t memory_bytes);

}  // namespace triax::sim
