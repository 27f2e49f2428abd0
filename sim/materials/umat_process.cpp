// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/umat_process.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <stdio_ext.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <cfenv>
#include <csignal>
#include <cstdlib>
#include <string>

#include "sim/materials/umat_host.hpp"

namespace triax::sim {
namespace {

/// Most that a plug-in may write into one file: an endless print ends here.
constexpr rlim_t kMostOutput = 256U << 20U;

constexpr int kNameLength = 80;

// Fortran's UMAT as Abaqus calls it; the last argument is the hidden length of CMNAME.
using UmatRoutine = void (*)(double* stress, double* statev, double* ddsdde, double* sse,
                             double* spd, double* scd, double* rpl, double* ddsddt, double* drplde,
                             double* drpldt, const double* stran, const double* dstran,
                             const double* time, const double* dtime, const double* temp,
                             const double* dtemp, const double* predef, const double* dpred,
                             const char* cmname, const int* ndi, const int* nshr, const int* ntens,
                             const int* nstatv, const double* props, const int* nprops,
                             const double* coords, const double* drot, double* pnewdt,
                             const double* celent, const double* dfgrd0, const double* dfgrd1,
                             const int* noel, const int* npt, const int* layer, const int* kspt,
                             const int* kstep, const int* kinc, std::size_t cmname_length);

int watched_parent = 0;

void leave_orphan(int) {
  if (getppid() != watched_parent) _exit(0);
}

UmatExchange* exchange_at_exit = nullptr;

/// First of all exit handlers: those of triax, whose copy this process is, must not run.
void leave(int status, void*) {
  exchange_at_exit->exit_status = status;
  exchange_at_exit->stage = UmatStage::exited;
  _exit(0);
}

void limit(__rlimit_resource resource, rlim_t most) {
  rlimit now{};
  if (getrlimit(resource, &now) != 0) return;
  now.rlim_cur = std::min(most, now.rlim_max);
  setrlimit(resource, &now);
}

/// Sheds what belongs to triax: signal handlers, open files, standard streams, exit handlers.
void become_a_worker(UmatExchange& exchange, int output, int parent) {
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
  close_range(STDERR_FILENO + 1, ~0U, 0);

  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, kMostOutput);
  prctl(PR_SET_DUMPABLE, 0);

  exchange_at_exit = &exchange;
  on_exit(leave, nullptr);

  watched_parent = parent;
  struct sigaction watch {};
  watch.sa_handler = leave_orphan;
  watch.sa_flags = SA_RESTART;
  sigaction(SIGALRM, &watch, nullptr);
  const itimerval each_second{{1, 0}, {1, 0}};
  setitimer(ITIMER_REAL, &each_second, nullptr);
}

[[noreturn]] void refuse(UmatExchange& exchange, const char* why) {
  exchange.say(why);
  exchange.stage = UmatStage::refused;
  sem_post(&exchange.answered);
  _exit(0);
}

UmatRoutine load(const UmatPlugin& plugin, UmatExchange& exchange, void*& handle) {
  handle = dlopen(plugin.library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) refuse(exchange, dlerror());
  for (const char* name : {"umat_", "umat", "UMAT"})
    if (void* found = dlsym(handle, name)) return reinterpret_cast<UmatRoutine>(found);
  refuse(exchange, "has no subroutine UMAT (neither umat_ nor umat nor UMAT)");
}

/// I + ε, row and column symmetric, from strains of the plug-in's convention.
std::array<double, 9> deformation_gradient(const std::array<double, 6>& strain) {
  const double xy = strain[3] / 2, xz = strain[4] / 2, yz = strain[5] / 2;
  return {1 + strain[0], xy, xz, xy, 1 + strain[1], yz, xz, yz, 1 + strain[2]};
}

void call_once(UmatRoutine umat, const UmatPlugin& plugin, UmatCall& c) {
  std::array<char, kNameLength> name{};
  name.fill(' ');
  plugin.name.copy(name.data(), name.size());
  std::vector<double> properties = plugin.properties;
  const int property_count = static_cast<int>(properties.size());
  properties.resize(std::max<std::size_t>(properties.size(), 1));

  std::array<double, 6> end = c.strain;
  for (std::size_t i = 0; i < end.size(); ++i) end[i] += c.strain_increment[i];
  const auto before = deformation_gradient(c.strain), after = deformation_gradient(end);
  const std::array<double, 9> no_rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::array<double, 3> coordinates{};
  const std::array<double, 2> time{c.time, c.time};
  const std::array<int, 4> step{1, 0, 0, 0};
  std::array<double, 6> unused_row{}, unused_column{};
  double sse = 0, spd = 0, scd = 0, rpl = 0, drpldt = 0;
  const double nothing = 0, length = 1;
  const int three = 3, six = 6, one = 1;
  c.tangent.fill(0);
  c.smaller = 1;
  umat(c.stress.data(), c.state.data(), c.tangent.data(), &sse, &spd, &scd, &rpl, unused_row.data(),
       unused_column.data(), &drpldt, c.strain.data(), c.strain_increment.data(), time.data(),
       &c.time_step, &nothing, &nothing, &nothing, &nothing, name.data(), &three, &three, &six,
       &plugin.state_variables, properties.data(), &property_count, coordinates.data(),
       no_rotation.data(), &c.smaller, &length, before.data(), after.data(), &one, &one, &one, &one,
       step.data(), &c.increment, kNameLength);
}

void wait_for(sem_t& semaphore) {
  if (spin_for(semaphore)) return;
  while (sem_wait(&semaphore) != 0 && errno == EINTR) {
  }
}

}  // namespace

bool spin_for(sem_t& semaphore) {
  static const bool alone = sysconf(_SC_NPROCESSORS_ONLN) < 2;
  for (int i = 0; i < (alone ? 1 : 2000); ++i) {
    if (sem_trywait(&semaphore) == 0) return true;
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
  }
  return false;
}

void run_umat(const UmatPlugin& plugin, UmatExchange& exchange, int output, int parent) {
  become_a_worker(exchange, output, parent);
  umat_host_serve(&exchange);
  void* handle = nullptr;
  const UmatRoutine umat = load(plugin, exchange, handle);
  exchange.stage = UmatStage::ready;
  sem_post(&exchange.answered);
  for (;;) {
    wait_for(exchange.asked);
    if (exchange.finish) break;
    exchange.stage = UmatStage::calling;
    call_once(umat, plugin, exchange.call);
    if (exchange.stage == UmatStage::calling) exchange.stage = UmatStage::ready;
    sem_post(&exchange.answered);
  }
  dlclose(handle);  // lets a Fortran library write out what it holds for its files
  _exit(0);
}

}  // namespace triax::sim
