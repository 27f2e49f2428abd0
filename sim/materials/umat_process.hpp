// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "sim/materials/umat_exchange.hpp"

namespace triax::sim {

/// Life of the process that runs a plug-in, from fork() to its end: loads the library, answers
/// calls until `finish`, confined as process_confinement.hpp says. What the plug-in prints goes to
/// the file descriptor `output`. `lifeline` is the end for reading of a pipe to which only the
/// other process can write: it is closed with that process, and this one does not outlive it.
[[noreturn]] void run_umat(const UmatPlugin& plugin, UmatExchange& exchange, int output,
                           int lifeline);

}  // namespace triax::sim
