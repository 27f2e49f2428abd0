// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/interruption.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

using triax::src::Interruption;

TEST_CASE(
    "the first signal is a request, one soon after it nothing, a later one kills; before as after "
    "nothing changes") {
  struct sigaction before {};
  sigaction(SIGTERM, nullptr, &before);
  {
    const Interruption interruption;
    CHECK_FALSE(interruption.requested());
    raise(SIGTERM);
    CHECK(interruption.requested());
  }
  {
    const Interruption another;
    CHECK_FALSE(another.requested());
  }
  struct sigaction after {};
  sigaction(SIGTERM, nullptr, &after);
  CHECK(after.sa_handler == before.sa_handler);

  for (const auto orderly : {std::chrono::seconds(0), std::chrono::seconds(60)}) {
    const pid_t child = fork();
    if (child == 0) {
      std::signal(SIGINT, SIG_DFL);
      std::signal(SIGTERM, SIG_DFL);
      const Interruption interruption(orderly);
      raise(SIGTERM);
      raise(SIGINT);
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (orderly.count() == 0)
      CHECK((WIFSIGNALED(status) && WTERMSIG(status) == SIGINT));
    else
      CHECK((WIFEXITED(status) && WEXITSTATUS(status) == 0));
  }
}

TEST_CASE("a signal that was ignored stays ignored") {
  const auto before = std::signal(SIGINT, SIG_IGN);
  {
    const Interruption interruption;
    raise(SIGINT);
    CHECK_FALSE(interruption.requested());
  }
  std::signal(SIGINT, before);
}
