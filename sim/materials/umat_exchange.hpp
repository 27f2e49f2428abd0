// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <semaphore.h>

#include <atomic>
#include <cstring>
#include <string_view>

#include "sim/materials/umat_arguments.hpp"

namespace triax::sim {

/// How far the process that runs a plug-in has come.
enum class UmatStage : int {
  loading,
  refused,     ///< the library cannot be used: `message`
  ready,       ///< waits for a call
  calling,     ///< inside the plug-in
  objected,    ///< came back from the plug-in, which reported an error: `message`
  xit,         ///< the plug-in called XIT, or STDB_ABQERR to stop
  exited,      ///< the plug-in ended the process: STOP or exit, `exit_status`
  trespassed,  ///< it went beyond one of its arguments, `trespass`, and its process ended
};

/// Memory that triax and the plug-in's process share. Whose turn it is goes through the semaphores;
/// each side writes only in its turn. What comes back is never taken for sound: a plug-in may have
/// written over it.
struct UmatExchange {
  sem_t asked;
  sem_t answered;
  std::atomic<UmatStage> stage = UmatStage::loading;
  std::atomic<bool> finish = false;
  int exit_status = 0;
  UmatArguments::Beside trespass{};
  std::array<char, 512> message{};
  UmatCall call;

  void say(std::string_view text) {
    const std::size_t length = std::min(text.size(), message.size() - 1);
    std::memcpy(message.data(), text.data(), length);
    message[length] = '\0';
  }
  std::string said() const { return {message.data(), strnlen(message.data(), message.size())}; }
};

/// A post comes within microseconds while a path is being run: looking for it a while costs less
/// than a sleep of the process. Where others are at work on the machine looking is in vain, and
/// soon done hardly any more. True if it came.
bool spin_for(sem_t& semaphore);

}  // namespace triax::sim
