// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The numbers by which a loading frame and a pressure/volume controller are told what to do and say
// how they are: points `mode` and `state` of the personalities triax-frame and triax-controller.
#include <string_view>

namespace triax::lab {

/// Modes of a loading frame on the wire, as numbers of its point `mode`.
enum class FrameMode { stop, crosshead, force, dead_load, stress, free };
inline constexpr int kFrameModes = 6;

/// Modes of a pressure/volume controller on the wire, as numbers of its point `mode`.
enum class ControllerMode { hold, ramp, ramp_to_target, flow };
inline constexpr int kControllerModes = 4;

/// What a loading frame says of itself, as numbers of its point `state`.
enum class FrameState { ready, on_stop, end_of_travel, emergency_stop, watchdog, cannot_follow };

/// The word that every identity of a served instrument holds: what it measures is simulated.
inline constexpr std::string_view kSimulatedWord = "simulated";

}  // namespace triax::lab
