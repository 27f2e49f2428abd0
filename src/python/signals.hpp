// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <pybind11/pybind11.h>

#include <chrono>

namespace triax::python {

/// Ctrl-C amid a computation that runs without the GIL.
class Signals {
 public:
  /// Looks at most ten times a second. Throws KeyboardInterrupt (or what a handler of the user's
  /// raised) in the main thread; in others Python has nothing to tell. Pre-condition: this thread
  /// does not hold the GIL. Gives false, so that it can stand where a study asks whether to stop.
  bool look() {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return false;
    next_ = now + std::chrono::milliseconds(100);
    const pybind11::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    return false;
  }

 private:
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now();
};

}  // namespace triax::python
