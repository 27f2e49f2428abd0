// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The arguments of a UMAT, each in memory of its own, so that an index out of range is found where
// it happens instead of changing another argument:
//
//   page without access | guard values | the argument | page without access
//
// What reads or writes past the end, or more than a page before the start, is stopped on the spot
// (SIGSEGV, whose address `beside` explains); what is written just before the start is found by
// `written_before` after the call. A stray access within a page of an argument meets nothing else.
#include <array>
#include <cstddef>
#include <optional>

#include "sim/materials/umat_plugin.hpp"

namespace triax::sim {

/// In the order of the subroutine.
enum class UmatArgument : std::size_t {
  stress,
  statev,
  ddsdde,
  sse,
  spd,
  scd,
  rpl,
  ddsddt,
  drplde,
  drpldt,
  stran,
  dstran,
  time,
  dtime,
  temp,
  dtemp,
  predef,
  dpred,
  cmname,
  ndi,
  nshr,
  ntens,
  nstatv,
  props,
  nprops,
  coords,
  drot,
  pnewdt,
  celent,
  dfgrd0,
  dfgrd1,
  noel,
  npt,
  layer,
  kspt,
  kstep,
  kinc
};
inline constexpr std::size_t kUmatArguments = 37;

/// An argument as messages name it: "STATEV", and how many values it has.
struct UmatArgumentText {
  const char* name;
  std::size_t values;
};
UmatArgumentText text_of(UmatArgument argument, const UmatPlugin& plugin);

class UmatArguments {
 public:
  /// Throws std::bad_alloc. The plug-in must outlive this object.
  explicit UmatArguments(const UmatPlugin& plugin);
  ~UmatArguments();
  UmatArguments(const UmatArguments&) = delete;
  UmatArguments& operator=(const UmatArguments&) = delete;

  /// Calls `routine`, a UMAT as Fortran compiles it, with the inputs of `call` and puts what it
  /// leaves in STRESS, STATEV, DDSDDE and PNEWDT there.
  void call(void* routine, UmatCall& call);

  /// The argument before whose first value the last call wrote.
  std::optional<UmatArgument> written_before() const;

  struct Beside {
    UmatArgument argument;
    bool behind;  ///< past its last value; otherwise before its first
  };
  /// The argument whose pages without access hold this address. Allocates nothing: for a signal
  /// handler.
  std::optional<Beside> beside(const void* address) const;

 private:
  struct Place {
    std::byte* map = nullptr;  ///< the first page without access
    std::size_t mapped = 0;    ///< bytes, with both pages without access
    std::byte* begin = nullptr;
    std::size_t bytes = 0;
  };

  void put_inputs(const UmatCall& call);
  Place& at(UmatArgument argument) { return places_[static_cast<std::size_t>(argument)]; }

  const UmatPlugin& plugin_;
  std::array<Place, kUmatArguments> places_;
};

}  // namespace triax::sim
