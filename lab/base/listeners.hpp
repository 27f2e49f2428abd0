// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A listener is a plain struct of std::functions, any of which may be empty. notify() calls the
// functions of a list in its order, in its own thread. It does not catch what they throw.
#include <algorithm>
#include <functional>
#include <vector>

namespace triax::lab {

/// Calls `what` of every listener that has it, in order.
template <class Listener, class... Arguments, class... Given>
void notify(const std::vector<Listener>& listeners,
            std::function<void(Arguments...)> Listener::*what, const Given&... given) {
  for (const Listener& listener : listeners)
    if (listener.*what) (listener.*what)(given...);
}

/// Whether anybody would hear `what`.
template <class Listener, class... Arguments>
bool is_heard(const std::vector<Listener>& listeners,
              std::function<void(Arguments...)> Listener::*what) {
  return std::ranges::any_of(
      listeners, [what](const Listener& listener) { return static_cast<bool>(listener.*what); });
}

}  // namespace triax::lab
