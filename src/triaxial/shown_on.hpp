// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/rig/session_listener.hpp"
#include "src/output/progress_bar.hpp"

namespace triax::src {

/// The bar shows how far the test has come.
inline lab::SessionListener shown_on(ProgressBar& bar) {
  return {.progressed = [&bar](double fraction) { bar.show(fraction); }};
}

}  // namespace triax::src
