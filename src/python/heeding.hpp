// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <pybind11/pybind11.h>

#include <exception>
#include <string>
#include <utility>

#include "src/python/signals.hpp"

namespace triax::python {

/// A long computation that ends early with what it has: on Ctrl-C, where the user's callback
/// raises, and where it gives False. Pre-condition of tell() and go_on(): this thread does not hold
/// the GIL.
class Heeding {
 public:
  /// `progress`: called with what is under way and its share, or None.
  explicit Heeding(pybind11::object progress) : progress_(std::move(progress)) {}

  void tell(const std::string& what, double share) {
    if (ended_ || progress_.is_none()) return;
    const pybind11::gil_scoped_acquire gil;
    keeping([&] { ended_ = progress_(what, share).is(pybind11::bool_(false)); });
  }

  bool go_on() {
    if (!ended_) keeping([&] { signals_.look(); });
    return !ended_;
  }

  /// Throws what ended it, if that is an exception, with an attribute `best`. Pre-condition: the
  /// GIL is held.
  void raise(const pybind11::object& best) {
    if (!raised_) return;
    try {
      std::rethrow_exception(std::exchange(raised_, nullptr));
    } catch (const pybind11::error_already_set& error) {
      if (PyObject_SetAttrString(error.value().ptr(), "best", best.ptr()) != 0) PyErr_Clear();
      throw;
    }
  }

 private:
  template <class Work>
  void keeping(const Work& work) {
    try {
      work();
    } catch (const pybind11::error_already_set&) {
      raised_ = std::current_exception();
      ended_ = true;
    }
  }

  pybind11::object progress_;
  Signals signals_;
  bool ended_ = false;
  std::exception_ptr raised_;
};

}  // namespace triax::python
