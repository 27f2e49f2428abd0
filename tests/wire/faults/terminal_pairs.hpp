// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace triax::lab::test {

/// Serial lines: pairs of pseudo-terminals that socat holds together, each as two paths.
class TerminalPairs {
 public:
  explicit TerminalPairs(int pairs, int number) {
    const auto folder = std::filesystem::temp_directory_path();
    for (int i = 0; i < pairs; ++i) {
      const std::string path = (folder / ("triax-" + std::to_string(::getpid()) + "-" +
                                          std::to_string(number) + "-" + std::to_string(i)))
                                   .string();
      ends_.push_back({path + "a", path + "b"});
      start("PTY,raw,echo=0,link=" + ends_.back().served,
            "PTY,raw,echo=0,link=" + ends_.back().client);
    }
    for (const Ends& one : ends_) await(one);
  }
  ~TerminalPairs() {
    for (const pid_t one : socats_) {
      ::kill(one, SIGTERM);
      ::waitpid(one, nullptr, 0);
    }
  }
  TerminalPairs(const TerminalPairs&) = delete;
  TerminalPairs& operator=(const TerminalPairs&) = delete;

  struct Ends {
    std::string served, client;
  };
  const std::vector<Ends>& ends() const { return ends_; }

 private:
  void start(std::string first, std::string second) {
    std::string name = "socat";
    char* words[] = {name.data(), first.data(), second.data(), nullptr};
    pid_t started = 0;
    // It would hold other trials' sockets open beyond their end.
    posix_spawn_file_actions_t closing;
    ::posix_spawn_file_actions_init(&closing);
    ::posix_spawn_file_actions_addclosefrom_np(&closing, 3);
    const int failed = ::posix_spawnp(&started, "socat", &closing, nullptr, words, environ);
    ::posix_spawn_file_actions_destroy(&closing);
    if (failed != 0) throw std::runtime_error("socat cannot be started");
    socats_.push_back(started);
  }
  static void await(const Ends& one) {
    for (int i = 0; i < 1000; ++i) {
      if (std::filesystem::exists(one.served) && std::filesystem::exists(one.client)) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    throw std::runtime_error("socat made no pair of terminals");
  }
  std::vector<Ends> ends_;
  std::vector<pid_t> socats_;
};

}  // namespace triax::lab::test
