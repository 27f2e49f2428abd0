// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/umat_confinement.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <vector>

namespace triax::sim {
namespace {

/// Most that a plug-in may write into one file: an endless print ends here.
constexpr rlim_t kMostOutput = 256U << 20U;

void limit(__rlimit_resource resource, rlim_t most) {
  rlimit now{};
  if (getrlimit(resource, &now) != 0) return;
  now.rlim_cur = now.rlim_max = std::min(most, now.rlim_max);
  setrlimit(resource, &now);
}

std::size_t address_space_bytes() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// A pipe without a writer makes the kernel send SIGKILL, which no plug-in can put off. (The signal
/// that PR_SET_PDEATHSIG sends at the death of the parent comes when the thread that forked ends.)
void hold_on_to(int lifeline) {
  fcntl(lifeline, F_SETOWN, getpid());
  fcntl(lifeline, F_SETSIG, SIGKILL);
  fcntl(lifeline, F_SETFL, O_ASYNC | O_NONBLOCK);
  pollfd closed{lifeline, 0, 0};
  if (poll(&closed, 1, 0) > 0) _exit(0);
}

#if defined(__x86_64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kArchitecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kArchitecture = 0;
#endif

/// To other processes, by their number: the first argument.
constexpr std::uint32_t kSignals[] = {SYS_kill, SYS_tkill, SYS_tgkill, SYS_rt_sigqueueinfo,
                                      SYS_rt_tgsigqueueinfo};
constexpr std::uint32_t kRefused[] = {
#if defined(__x86_64__)
    SYS_fork,
    SYS_vfork,
#endif
    SYS_close_range,
    SYS_execve,
    SYS_execveat,
    SYS_setsid,
    SYS_setpgid,
    SYS_ptrace,
    SYS_process_vm_readv,
    SYS_process_vm_writev,
    SYS_pidfd_open,
    SYS_pidfd_send_signal};

/// That could let go of the lifeline, a descriptor, their first argument; close_range is not
/// needed.
constexpr std::uint32_t kOfDescriptors[] = {SYS_close, SYS_fcntl, SYS_ioctl};
/// That would put another file in its place, their second argument.
constexpr std::uint32_t kOntoDescriptors[] = {
#if defined(__x86_64__)
    SYS_dup2,
#endif
    SYS_dup3};

constexpr std::uint32_t kAllow = SECCOMP_RET_ALLOW, kNotPermitted = SECCOMP_RET_ERRNO | EPERM;

/// The filter: a program that the kernel runs at every system call.
std::vector<sock_filter> allowed_calls(int lifeline) {
  std::vector<sock_filter> f;
  const auto load = [&](std::size_t at) {
    f.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(at)));
  };
  const auto answer = [&](std::uint32_t what) { f.push_back(BPF_STMT(BPF_RET | BPF_K, what)); };
  /// Where the test fails, what follows in `lines` lines is left out.
  const auto only_if = [&](unsigned test, std::uint32_t value, unsigned char lines) {
    f.push_back(BPF_JUMP(static_cast<std::uint16_t>(BPF_JMP | BPF_K | test), value, 0, lines));
  };
  constexpr std::size_t kNumber = offsetof(seccomp_data, nr), kArch = offsetof(seccomp_data, arch);
  constexpr std::size_t kFirst = offsetof(seccomp_data, args),  // its lower half
      kSecond = kFirst + sizeof(std::uint64_t);
  const auto refuse_for = [&](std::uint32_t call, std::size_t argument, int value) {
    only_if(BPF_JEQ, call, 4);
    load(argument);
    only_if(BPF_JEQ, static_cast<std::uint32_t>(value), 1);
    answer(kNotPermitted);
    answer(kAllow);
  };
  load(kArch);
  f.push_back(BPF_JUMP(BPF_JMP | BPF_K | BPF_JEQ, kArchitecture, 1, 0));
  answer(kNotPermitted);
  load(kNumber);
#if defined(__x86_64__)
  only_if(BPF_JGE, 0x4000'0000, 1);  // the same calls by the numbers of x32
  answer(kNotPermitted);
#endif
  for (const std::uint32_t call : kRefused) {
    only_if(BPF_JEQ, call, 1);
    answer(kNotPermitted);
  }
  only_if(BPF_JEQ, SYS_clone3, 1);  // its flags are out of sight; the C library falls back to clone
  answer(SECCOMP_RET_ERRNO | ENOSYS);
  only_if(BPF_JEQ, SYS_clone, 4);
  load(kFirst);
  only_if(BPF_JSET, CLONE_THREAD, 1);
  answer(kAllow);
  answer(kNotPermitted);
  for (const std::uint32_t call : kSignals) {
    only_if(BPF_JEQ, call, 4);
    load(kFirst);
    only_if(BPF_JEQ, static_cast<std::uint32_t>(getpid()), 1);
    answer(kAllow);
    answer(kNotPermitted);
  }
  for (const std::uint32_t call : kOfDescriptors) refuse_for(call, kFirst, lifeline);
  for (const std::uint32_t call : kOntoDescriptors) refuse_for(call, kSecond, lifeline);
  answer(kAllow);
  return f;
}

}  // namespace

void confine_umat(int lifeline, std::size_t memory_bytes) {
  setpgid(0, 0);
  hold_on_to(lifeline);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, kMostOutput);
  limit(RLIMIT_AS, address_space_bytes() + memory_bytes);
  prctl(PR_SET_DUMPABLE, 0);
  if (kArchitecture == 0) return;
  auto filter = allowed_calls(lifeline);
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0)
    syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program);
}

}  // namespace triax::sim
