// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/writer_identity.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

using namespace triax;

TEST_CASE("this process is alive, the same number with another start is not") {
  db::WriterIdentity writer = db::this_process();
  CHECK(writer.pid == getpid());
  CHECK(writer.started > 0);
  CHECK(db::may_be_alive(writer));
  ++writer.started;
  CHECK_FALSE(db::may_be_alive(writer));
}

TEST_CASE("a process that has ended is not alive, even before its parent noticed") {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  siginfo_t info;
  waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT);
  const db::WriterIdentity writer{child, 1, db::this_process().host};
  CHECK_FALSE(db::may_be_alive(writer));
  waitpid(child, nullptr, 0);
  CHECK_FALSE(db::may_be_alive(writer));
}

TEST_CASE("what runs on another host cannot be called dead") {
  CHECK(db::may_be_alive({1, 1, "another.host.example"}));
}
