// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/process_confinement.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <linux/sockios.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <initializer_list>
#include <utility>
#include <vector>

namespace triax::sim {
namespace {

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
constexpr auto kSignals = std::to_array<std::uint32_t>(
    {SYS_kill, SYS_tkill, SYS_tgkill, SYS_rt_sigqueueinfo, SYS_rt_tgsigqueueinfo});
constexpr auto kRefused = std::to_array<std::uint32_t>({
#if defined(__x86_64__)
  SYS_fork, SYS_vfork,
#endif
      SYS_close_range, SYS_execve, SYS_execveat, SYS_setsid, SYS_setpgid, SYS_ptrace,
      SYS_process_vm_readv, SYS_process_vm_writev, SYS_pidfd_open, SYS_pidfd_getfd,
      SYS_pidfd_send_signal, SYS_io_uring_setup
});  // what it carries out passes no filter

/// That would put another file in its place, their second argument.
constexpr auto kOntoDescriptors = std::to_array<std::uint32_t>({
#if defined(__x86_64__)
  SYS_dup2,
#endif
      SYS_dup3
});

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
  /// `found` where one of the arguments has its value, else `otherwise`.
  using Argument = std::pair<std::size_t, std::uint32_t>;
  const auto judge = [&](std::uint32_t call, std::initializer_list<Argument> arguments,
                         std::uint32_t found, std::uint32_t otherwise) {
    only_if(BPF_JEQ, call, static_cast<unsigned char>(3 * arguments.size() + 1));
    for (const auto& [at, value] : arguments) {
      load(at);
      only_if(BPF_JEQ, value, 1);
      answer(found);
    }
    answer(otherwise);
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
  const auto self = static_cast<std::uint32_t>(getpid());
  const auto held = static_cast<std::uint32_t>(lifeline);
  for (const std::uint32_t call : kSignals) judge(call, {{kFirst, self}}, kAllow, kNotPermitted);
  judge(SYS_prlimit64, {{kFirst, 0}, {kFirst, self}}, kAllow, kNotPermitted);
  judge(SYS_close, {{kFirst, held}}, kNotPermitted, kAllow);
  // Whom the kernel sends a signal when a file can be read, and which; the terminal of triax.
  judge(SYS_fcntl,
        {{kFirst, held}, {kSecond, F_SETOWN}, {kSecond, F_SETOWN_EX}, {kSecond, F_SETSIG}},
        kNotPermitted, kAllow);
  judge(SYS_ioctl,
        {{kFirst, held},
         {kSecond, FIOSETOWN},
         {kSecond, SIOCSPGRP},
         {kSecond, TIOCSPGRP},
         {kSecond, TIOCSTI}},
        kNotPermitted, kAllow);
  for (const std::uint32_t call : kOntoDescriptors)
    judge(call, {{kSecond, held}}, kNotPermitted, kAllow);
  answer(kAllow);
  return f;
}

/// What Landlock is asked for: what it would otherwise refuse, everywhere. Left is what comes with
/// any of its domains: memory and files of other processes in /proc (mem, fd/N) stay closed.
constexpr landlock_ruleset_attr kNothingRefused{LANDLOCK_ACCESS_FS_REFER};

/// A descriptor; negative where the kernel has no Landlock of version 2 (Linux 5.19).
int ruleset_of_landlock() {
  return static_cast<int>(
      syscall(SYS_landlock_create_ruleset, &kNothingRefused, sizeof kNothingRefused, 0));
}

void see_no_other_process() {
  const int ruleset = ruleset_of_landlock();
  if (ruleset < 0) return;
  landlock_path_beneath_attr everywhere{};
  everywhere.allowed_access = kNothingRefused.handled_access_fs;
  everywhere.parent_fd = open("/", O_PATH | O_CLOEXEC);
  syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &everywhere, 0);
  syscall(SYS_landlock_restrict_self, ruleset, 0);
  close(everywhere.parent_fd);
  close(ruleset);
}

}  // namespace

void hide_from_umats() {
  const int ruleset = ruleset_of_landlock();
  if (ruleset < 0)
    prctl(PR_SET_DUMPABLE, 0);
  else
    close(ruleset);
}

void confine_process(int lifeline, const ProcessLimits& limits) {
  setpgid(0, 0);
  hold_on_to(lifeline);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, limits.file_bytes);
  limit(RLIMIT_AS, address_space_bytes() + limits.memory_bytes);
  if (limits.cpu_s > 0) limit(RLIMIT_CPU, limits.cpu_s);
  prctl(PR_SET_DUMPABLE, 0);
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return;
  see_no_other_process();
  if (kArchitecture == 0) return;
  auto filter = allowed_calls(lifeline);
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program);
}

}  // namespace triax::sim
