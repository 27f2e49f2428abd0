// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/umat_process.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <stdio_ext.h>
#include <unistd.h>

#include <cerrno>
#include <cfenv>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "sim/materials/process_confinement.hpp"
#include "sim/materials/umat_host.hpp"

namespace triax::sim {
namespace {

UmatExchange* exchange_at_exit = nullptr;

/// First of all exit handlers: those of triax, whose copy this process is, must not run.
void leave(int status, void*) {
  exchange_at_exit->exit_status = status;
  exchange_at_exit->stage = UmatStage::exited;
  _exit(0);
}

/// Where the plug-in's arguments are; of the one plug-in of this process.
const UmatArguments* arguments_at_fault = nullptr;

/// Beside an argument, this is the plug-in's index out of range. Anything else ends the process as
/// ever.
void explain_fault(int number, siginfo_t* fault, void*) {
  if (arguments_at_fault != nullptr)
    if (const auto beside = arguments_at_fault->beside(fault->si_addr)) {
      exchange_at_exit->trespass = *beside;
      exchange_at_exit->stage = UmatStage::trespassed;
      _exit(0);
    }
  std::signal(number, SIG_DFL);
  std::raise(number);
}

void explain_faults() {
  static std::array<std::byte, 65536> stack_of_handler;  // the plug-in's own may be used up
  stack_t other{};
  other.ss_sp = stack_of_handler.data();
  other.ss_size = stack_of_handler.size();
  sigaltstack(&other, nullptr);
  struct sigaction explain {};
  explain.sa_sigaction = explain_fault;
  explain.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigaction(SIGSEGV, &explain, nullptr);
}

/// How often spin_for looks; after some waits in vain only now and then so long, for others are at
/// work on this machine, and the post cannot come before this process sleeps.
constexpr int kManyLooks = 2000, kFewLooks = 10;
constexpr unsigned kFewInVain = 4, kHopeEvery = 64;

/// An endless print ends here.
constexpr std::uint64_t kMaxOutput_bytes = std::uint64_t{256} << 20;

/// Where the lifeline is kept.
constexpr int kLifeline = STDERR_FILENO + 1;

/// Sheds what belongs to triax: signal handlers, open files, standard streams, exit handlers.
void become_a_worker(UmatExchange& exchange, int output, int lifeline) {
  for (int number = 1; number < NSIG; ++number) std::signal(number, SIG_DFL);
  std::signal(SIGINT, SIG_IGN);  // Ctrl-C is triax's to answer
  std::signal(SIGHUP, SIG_IGN);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  std::fesetenv(FE_DFL_ENV);

  __fpurge(stdout);  // what triax had not yet written is its own to write
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  dup2(lifeline, kLifeline);
  close_range(kLifeline + 1, ~0U, 0);

  exchange_at_exit = &exchange;
  on_exit(leave, nullptr);
  explain_faults();
}

[[noreturn]] void refuse(UmatExchange& exchange, const char* why) {
  exchange.say(why);
  exchange.stage = UmatStage::refused;
  sem_post(&exchange.answered);
  _exit(0);
}

void* load(const UmatPlugin& plugin, UmatExchange& exchange, void*& handle) {
  handle = dlopen(plugin.library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) refuse(exchange, dlerror());
  for (const char* name : {"umat_", "umat", "UMAT"})
    if (void* found = dlsym(handle, name)) return found;
  refuse(exchange, "has no subroutine UMAT (neither umat_ nor umat nor UMAT)");
}

void wait_for(sem_t& semaphore) {
  if (spin_for(semaphore)) return;
  while (sem_wait(&semaphore) != 0 && errno == EINTR) {
  }
}

}  // namespace

bool spin_for(sem_t& semaphore) {
  static const bool alone = sysconf(_SC_NPROCESSORS_ONLN) < 2;
  thread_local unsigned in_vain = 0;  // in a row
  const bool hopeful = !alone && (in_vain < kFewInVain || in_vain % kHopeEvery == 0);
  for (int i = 0; i < (hopeful ? kManyLooks : kFewLooks); ++i) {
    if (sem_trywait(&semaphore) == 0) {
      in_vain = 0;
      return true;
    }
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
  }
  ++in_vain;
  return false;
}

void run_umat(const UmatPlugin& plugin, UmatExchange& exchange, int output, int lifeline) {
  become_a_worker(exchange, output, lifeline);
  umat_host_serve(&exchange);
  UmatArguments arguments(plugin);
  arguments_at_fault = &arguments;
  confine_process(kLifeline,
                  {.memory_bytes = plugin.memory_limit_bytes, .file_bytes = kMaxOutput_bytes});
  void* handle = nullptr;
  void* const umat = load(plugin, exchange, handle);
  exchange.stage = UmatStage::ready;
  sem_post(&exchange.answered);
  for (;;) {
    wait_for(exchange.asked);
    if (exchange.finish) break;
    exchange.stage = UmatStage::calling;
    arguments.call(umat, exchange.call);
    if (const auto harmed = arguments.written_before()) {
      exchange.trespass = {*harmed, false};
      exchange.stage = UmatStage::trespassed;
      _exit(0);
    }
    if (exchange.stage == UmatStage::calling) exchange.stage = UmatStage::ready;
    sem_post(&exchange.answered);
  }
  dlclose(handle);  // lets a Fortran library write out what it holds for its files
  _exit(0);
}

}  // namespace triax::sim
