// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/materials/umat_exchange.hpp"

namespace triax::sim {

/// Life of the process that runs a plug-in, from fork() to its end: loads the library, answers
/// calls until `finish`. What the plug-in prints goes to the file descriptor `output`. `parent` is
/// watched: the process does not outlive it.
[[noreturn]] void run_umat(const UmatPlugin& plugin, UmatExchange& exchange, int output,
                           int parent);

}  // namespace triax::sim
