// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/umat_worker.hpp"

#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <thread>
#include <vector>

#include "tests/sim/materials/umat_fixture.hpp"

using namespace triax::sim;
using namespace triax::sim::test;

namespace {

UmatPlugin cone(Misbehaviour misbehaviour = Misbehaviour::none) {
  const ParameterSet set = umat_fixture(misbehaviour);
  return {kUmatFixture, "CONE", set.lists.at("properties"), 12, 5};
}

UmatCall a_strain() {
  UmatCall call;
  call.strain_increment[0] = -1e-6;
  return call;
}

/// What the worker says of the first call with strain.
std::string verdict(Misbehaviour misbehaviour, int state_variables = 12) {
  UmatPlugin plugin = cone(misbehaviour);
  plugin.state_variables = state_variables;
  UmatWorker worker(plugin);
  UmatCall call = a_strain();
  const std::string words = worker.call(call);
  // Without strain the fixture behaves: the process was made anew where that was due.
  UmatCall sound;
  CHECK((state_variables < 12 || worker.call(sound).empty()));
  return words;
}

double second_state_variable(Misbehaviour misbehaviour, std::size_t megabytes = 1024) {
  UmatPlugin plugin = cone(misbehaviour);
  plugin.memory_limit_bytes = megabytes << 20U;
  UmatWorker worker(plugin);
  UmatCall call = a_strain();
  CHECK(worker.call(call) == "");
  CHECK(call.stress[0] == Approx(-1e-6 * (kBulk + 4 * kShear / 3)));
  return call.state[1];
}

/// Ends as it was killed: only to be called in a process made for that.
[[noreturn]] void call_and_stay(Misbehaviour misbehaviour) {
  UmatPlugin plugin = cone(misbehaviour);
  plugin.time_limit_s = 100;
  UmatWorker worker(plugin);
  UmatCall call = a_strain();
  worker.call(call);
  _exit(0);
}

}  // namespace

TEST_CASE("a call leaves in the arguments what the plug-in wrote, and nothing if it crashed") {
  if (!umat_fixture_is_there()) return;
  UmatWorker worker(cone());
  UmatCall call;
  call.strain_increment = {-1e-4, 0, 0, 2e-4, 0, 0};
  REQUIRE(worker.call(call).empty());
  CHECK(call.stress[0] == Approx(-1e-4 * (kBulk + 4 * kShear / 3)));
  CHECK(call.stress[3] == Approx(2e-4 * kShear));
  CHECK(call.tangent[3 + 6 * 3] == Approx(kShear));

  UmatWorker fragile(cone(Misbehaviour::null_pointer));
  UmatCall untouched;
  untouched.stress = {-1, -2, -3, 0, 0, 0};
  untouched.strain_increment = {-1e-4, 0, 0, 0, 0, 0};
  CHECK_FALSE(fragile.call(untouched).empty());
  CHECK(untouched.stress[2] == -3);
}

TEST_CASE("calls that do not come back in order are counted, with what happened to the first") {
  if (!umat_fixture_is_there()) return;
  UmatWorker crashes(cone(Misbehaviour::null_pointer)), gives_up(cone(Misbehaviour::xit));
  UmatCall call = a_strain(), sound;
  const long before = umat_ends().calls;
  CHECK(crashes.call(sound) == "");
  CHECK(umat_ends().calls == before);
  CHECK(crashes.call(call) != "");
  CHECK(gives_up.call(call) != "");
  CHECK(umat_ends().calls == before + 2);
  CHECK_FALSE(umat_ends().first.empty());
}

TEST_CASE("several threads may use one plug-in") {
  if (!umat_fixture_is_there()) return;
  UmatWorker worker(cone());
  std::vector<std::thread> threads;
  std::array<int, 4> right{};
  for (std::size_t k = 0; k < right.size(); ++k)
    threads.emplace_back([&, k] {
      for (int i = 0; i < 500; ++i) {
        UmatCall call;
        call.strain_increment[3] = 1e-6 * static_cast<double>(k + 1);
        if (worker.call(call).empty() &&
            std::abs(call.stress[3] - kShear * call.strain_increment[3]) < 1e-12)
          ++right[k];
      }
    });
  for (auto& thread : threads) thread.join();
  for (const int count : right) CHECK(count == 500);
}

TEST_CASE("an index out of range is an error that names the argument, at either end and far off") {
  if (!umat_fixture_is_there()) return;
  using Catch::Contains;
  const std::string past = "reads or writes past the last value of ";
  const std::string before = "reads or writes before the first value of ";
  CHECK_THAT(verdict(Misbehaviour::past_state),
             Contains(past + "STATEV, which has 12 values; check state_variables"));
  CHECK_THAT(verdict(Misbehaviour::far_past_state), Contains(past + "STATEV"));
  CHECK_THAT(verdict(Misbehaviour::before_state), Contains(before + "STATEV"));
  CHECK_THAT(verdict(Misbehaviour::before_stress), Contains(before + "STRESS, which has 6 values"));
  CHECK_THAT(verdict(Misbehaviour::past_tangent), Contains(past + "DDSDDE, which has 36 values"));
  CHECK_THAT(verdict(Misbehaviour::past_properties),
             Contains(past + "PROPS, which has 6 values; check that properties is complete"));
  CHECK_THAT(verdict(Misbehaviour::writes_past_properties), Contains(past + "PROPS"));
  CHECK_THAT(verdict(Misbehaviour::before_properties), Contains(before + "PROPS"));
  CHECK_THAT(verdict(Misbehaviour::before_tangent), Contains(before + "DDSDDE"));
  CHECK_THAT(verdict(Misbehaviour::past_stress), Contains(past + "STRESS"));
  // Declared with fewer state variables than it uses: 5, 1 and none.
  for (const int declared : {5, 1, 0})
    CHECK_THAT(verdict(Misbehaviour::none, declared), Contains(past + "STATEV"));
  CHECK(verdict(Misbehaviour::none).empty());
}

TEST_CASE("a plug-in can neither signal triax nor make other processes nor leave its group") {
  if (!umat_fixture_is_there()) return;
  CHECK(second_state_variable(Misbehaviour::none) == 0);
  CHECK(second_state_variable(Misbehaviour::signals_triax) == -1);
  CHECK(second_state_variable(Misbehaviour::forks) == -1);
  CHECK(second_state_variable(Misbehaviour::own_session) == -1);
}

TEST_CASE(
    "a plug-in can neither have the kernel signal triax, nor set its limits, nor see into it") {
  if (!umat_fixture_is_there()) return;
  CHECK(second_state_variable(Misbehaviour::owns_file_for_triax) == -1);
  CHECK(second_state_variable(Misbehaviour::signal_of_file) == -1);
  CHECK(second_state_variable(Misbehaviour::owns_device_for_triax) == -1);
  CHECK(second_state_variable(Misbehaviour::limits_triax) == -1);
  if (geteuid() == 0 && syscall(SYS_landlock_create_ruleset, nullptr, 0, 1) < 2) {
    WARN("skipped: this kernel has no Landlock, and root may look into every process");
    return;
  }
  CHECK(second_state_variable(Misbehaviour::opens_memory_of_triax) == -1);
  // Root has CAP_PERFMON, which lets new kernels tell the layout (not the content) of memory.
  if (geteuid() != 0) CHECK(second_state_variable(Misbehaviour::reads_maps_of_triax) == -1);
}

// The allocator of the address sanitizer ends a process whose request is refused.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TRIAX_REFUSED_MEMORY_ENDS
#endif
#endif

#ifndef TRIAX_REFUSED_MEMORY_ENDS
TEST_CASE("a plug-in has the memory that it is given") {
  if (!umat_fixture_is_there()) return;
  CHECK(second_state_variable(Misbehaviour::allocates, 1024) == 1);
  CHECK(second_state_variable(Misbehaviour::allocates, 128) == 0);
}
#endif

TEST_CASE("the process of a plug-in ends with triax, killed or not, whatever it does against it") {
  if (!umat_fixture_is_there()) return;
  const auto misbehaviour = GENERATE(Misbehaviour::ignores_signals, Misbehaviour::closes_all_files,
                                     Misbehaviour::replaces_all_files);
  REQUIRE(prctl(PR_SET_CHILD_SUBREAPER, 1) == 0);  // orphans come to this process
  const pid_t host = fork();
  if (host == 0) call_and_stay(misbehaviour);
  REQUIRE(host > 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  REQUIRE(waitpid(host, nullptr, WNOHANG) == 0);  // waits for the plug-in
  kill(host, SIGKILL);
  CHECK(waitpid(host, nullptr, 0) == host);
  int status = 0;
  pid_t ended = 0;
  for (int i = 0; i < 40 && ended == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ended = waitpid(-1, &status, WNOHANG);
  }
  CHECK(ended > 0);
  CHECK((WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL));
  while (ended == 0) ended = waitpid(-1, &status, 0);  // it ends by itself after 8 s
  prctl(PR_SET_CHILD_SUBREAPER, 0);
}

TEST_CASE(
    "a call that does not end in time is stopped, named with its limit, and its process gone") {
  if (!umat_fixture_is_there()) return;
  for (const auto misbehaviour :
       {Misbehaviour::endless, Misbehaviour::sleeps, Misbehaviour::slow, Misbehaviour::slow_once,
        Misbehaviour::stops_itself, Misbehaviour::ignores_signals}) {
    UmatPlugin plugin = cone(misbehaviour);
    plugin.time_limit_s = 0.6;  // loading takes its time on a busy machine
    UmatWorker worker(plugin);
    for (int again = 0; again < 2; ++again) {
      UmatCall call = a_strain();
      const auto begin = std::chrono::steady_clock::now();
      const std::string words = worker.call(call);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
      INFO(static_cast<int>(misbehaviour) << ": " << words);
      CHECK_THAT(words, Catch::EndsWith("the call did not end within 0.6 s and was stopped; if it "
                                        "is only slow, raise time_limit_s"));
      CHECK(took.count() < 5);
      CHECK(call.stress[0] == 0);
      CHECK(waitpid(-1, nullptr, WNOHANG) == -1);  // no child is left
    }
  }
}

TEST_CASE("a plug-in that is late three times is called no more, even if it answers between") {
  if (!umat_fixture_is_there()) return;
  UmatPlugin plugin = cone(Misbehaviour::endless);
  plugin.time_limit_s = 0.6;  // loading takes its time on a busy machine
  UmatWorker worker(plugin);
  UmatCall call = a_strain(), sound;
  for (int i = 0; i < 3; ++i) {
    CHECK(worker.call(sound) == "");
    CHECK_THAT(worker.call(call), Catch::Contains("the call did not end within 0.6 s"));
  }
  const std::string refused =
      "each of three calls did not end within 0.6 s; it is not called again";
  CHECK_THAT(worker.call(call), Catch::EndsWith(refused));
  CHECK_THAT(worker.call(sound), Catch::EndsWith(refused));
}

TEST_CASE("a slow call within its limit is right, and so is one that is slow only once") {
  if (!umat_fixture_is_there()) return;
  for (const auto misbehaviour : {Misbehaviour::slow, Misbehaviour::slow_once}) {
    UmatWorker worker(cone(misbehaviour));
    for (int again = 0; again < 2; ++again) {
      UmatCall call = a_strain();
      CHECK(worker.call(call) == "");
      CHECK(call.stress[0] == Approx(-1e-6 * (kBulk + 4 * kShear / 3)));
    }
  }
}

TEST_CASE("a plug-in started in a thread works on when that thread has ended") {
  if (!umat_fixture_is_there()) return;
  std::unique_ptr<UmatWorker> worker;
  std::thread([&] { worker = std::make_unique<UmatWorker>(cone()); }).join();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  UmatCall call = a_strain();
  CHECK(worker->call(call) == "");
}
