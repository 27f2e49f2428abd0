// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <string>
#include <vector>

#include "sim/law/response.hpp"

namespace triax::sim {

/// What a UMAT is and is given with every call.
struct UmatPlugin {
  std::string library;             ///< as the loader takes it: a path, or a name it searches for
  std::string name;                ///< CMNAME, at most 80 characters
  std::vector<double> properties;  ///< PROPS
  int state_variables = 0;         ///< NSTATV
  double time_limit_s = 10;        ///< for one call, and for loading
  std::size_t memory_limit_bytes = std::size_t{1} << 30U;  ///< that it may ask for
};

/// The arguments of one call that change, in the plug-in's own units and signs: tension positive,
/// order 11, 22, 33, 12, 13, 23, shear strains γ = 2 ε.
struct UmatCall {
  std::array<double, 6> stress{};            ///< STRESS, in and out
  std::array<double, 36> tangent{};          ///< DDSDDE, out, column by column
  std::array<double, 6> strain{};            ///< STRAN
  std::array<double, 6> strain_increment{};  ///< DSTRAN
  double time = 0;                           ///< TIME(1) = TIME(2), s
  double time_step = 0;                      ///< DTIME, s
  double smaller = 1;                        ///< PNEWDT, out
  int increment = 1;                         ///< KINC
  std::array<double, kMostMemory> state{};   ///< STATEV, in and out
};

}  // namespace triax::sim
