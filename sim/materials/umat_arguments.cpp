// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/materials/umat_arguments.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <utility>

namespace triax::sim {
namespace {

constexpr std::size_t kNameLength = 80;

struct UmatArgumentRow {
  const char* name;
  std::size_t values;  ///< of STATEV and PROPS as the plug-in says
  std::size_t value_size;
};
constexpr std::size_t kReal = sizeof(double), kInteger = sizeof(int);
constexpr std::array<UmatArgumentRow, kUmatArguments> kArgumentRows{
    {{"STRESS", 6, kReal},       {"STATEV", 0, kReal},    {"DDSDDE", 36, kReal},
     {"SSE", 1, kReal},          {"SPD", 1, kReal},       {"SCD", 1, kReal},
     {"RPL", 1, kReal},          {"DDSDDT", 6, kReal},    {"DRPLDE", 6, kReal},
     {"DRPLDT", 1, kReal},       {"STRAN", 6, kReal},     {"DSTRAN", 6, kReal},
     {"TIME", 2, kReal},         {"DTIME", 1, kReal},     {"TEMP", 1, kReal},
     {"DTEMP", 1, kReal},        {"PREDEF", 1, kReal},    {"DPRED", 1, kReal},
     {"CMNAME", kNameLength, 1}, {"NDI", 1, kInteger},    {"NSHR", 1, kInteger},
     {"NTENS", 1, kInteger},     {"NSTATV", 1, kInteger}, {"PROPS", 0, kReal},
     {"NPROPS", 1, kInteger},    {"COORDS", 3, kReal},    {"DROT", 9, kReal},
     {"PNEWDT", 1, kReal},       {"CELENT", 1, kReal},    {"DFGRD0", 9, kReal},
     {"DFGRD1", 9, kReal},       {"NOEL", 1, kInteger},   {"NPT", 1, kInteger},
     {"LAYER", 1, kInteger},     {"KSPT", 1, kInteger},   {"KSTEP", 4, kInteger},
     {"KINC", 1, kInteger}}};

/// Two of them are a NaN: read as a number they spoil the result, which is then refused.
constexpr std::uint32_t kGuard = 0x7ff8'5a5a;
constexpr std::size_t kGuards = 64;

std::size_t page_bytes() { return static_cast<std::size_t>(sysconf(_SC_PAGESIZE)); }

/// I + ε, row and column symmetric, from strains of the plug-in's convention.
std::array<double, 9> deformation_gradient(const std::array<double, 6>& strain) {
  const double xy = strain[3] / 2, xz = strain[4] / 2, yz = strain[5] / 2;
  return {1 + strain[0], xy, xz, xy, 1 + strain[1], yz, xz, yz, 1 + strain[2]};
}

/// All arguments by reference; behind them the length of CMNAME, which Fortran hands over unseen.
template <std::size_t... I>
void invoke(void* routine, const std::array<void*, kUmatArguments>& to, std::index_sequence<I...>) {
  using Routine = void (*)(std::enable_if_t<(I < kUmatArguments), void*>..., std::size_t);
  reinterpret_cast<Routine>(routine)(to[I]..., kNameLength);
}

}  // namespace

UmatArgumentText text_of(UmatArgument argument, const UmatPlugin& plugin) {
  const UmatArgumentRow& row = kArgumentRows[static_cast<std::size_t>(argument)];
  if (argument == UmatArgument::statev)
    return {row.name, static_cast<std::size_t>(plugin.state_variables)};
  if (argument == UmatArgument::props) return {row.name, plugin.properties.size()};
  return {row.name, row.values};
}

UmatArguments::UmatArguments(const UmatPlugin& plugin) : plugin_(plugin) {
  const std::size_t page = page_bytes();
  for (std::size_t i = 0; i < kUmatArguments; ++i) {
    Place& place = places_[i];
    place.bytes =
        text_of(static_cast<UmatArgument>(i), plugin).values * kArgumentRows[i].value_size;
    const std::size_t inside = (place.bytes + kGuards * sizeof kGuard + page - 1) / page * page;
    place.mapped = inside + 2 * page;
    void* map = mmap(nullptr, place.mapped, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (map == MAP_FAILED) throw std::bad_alloc();
    place.map = static_cast<std::byte*>(map);
    if (mprotect(place.map + page, inside, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
    place.begin = place.map + page + inside - place.bytes;
    for (std::byte* to = place.map + page; to < place.begin; to += sizeof kGuard)
      std::memcpy(to, &kGuard, sizeof kGuard);
  }
}

UmatArguments::~UmatArguments() {
  for (const Place& place : places_) munmap(place.map, place.mapped);
}

void UmatArguments::put_inputs(const UmatCall& call) {
  using enum UmatArgument;
  for (Place& place : places_) std::memset(place.begin, 0, place.bytes);
  const auto put = [this](UmatArgument argument, const auto& values) {
    std::memcpy(at(argument).begin, std::data(values), at(argument).bytes);
  };
  const auto real = [&](UmatArgument argument, double value) { put(argument, std::array{value}); };
  const auto integer = [&](UmatArgument argument, int value) { put(argument, std::array{value}); };
  std::array<double, 6> end = call.strain;
  for (std::size_t i = 0; i < end.size(); ++i) end[i] += call.strain_increment[i];
  put(stress, call.stress);
  put(statev, call.state);
  put(stran, call.strain);
  put(dstran, call.strain_increment);
  put(time, std::array{call.time, call.time});
  real(dtime, call.time_step);
  std::memset(at(cmname).begin, ' ', kNameLength);
  plugin_.name.copy(reinterpret_cast<char*>(at(cmname).begin), kNameLength);
  integer(ndi, 3);
  integer(nshr, 3);
  integer(ntens, 6);
  integer(nstatv, plugin_.state_variables);
  if (!plugin_.properties.empty()) put(props, plugin_.properties);
  integer(nprops, static_cast<int>(plugin_.properties.size()));
  put(drot, std::array<double, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1});
  real(pnewdt, 1);
  real(celent, 1);
  put(dfgrd0, deformation_gradient(call.strain));
  put(dfgrd1, deformation_gradient(end));
  for (const UmatArgument one : {noel, npt, layer, kspt}) integer(one, 1);
  put(kstep, std::array{1, 0, 0, 0});
  integer(kinc, call.increment);
}

void UmatArguments::call(void* routine, UmatCall& call) {
  using enum UmatArgument;
  put_inputs(call);
  std::array<void*, kUmatArguments> to{};
  for (std::size_t i = 0; i < kUmatArguments; ++i) to[i] = places_[i].begin;
  invoke(routine, to, std::make_index_sequence<kUmatArguments>());
  const auto take = [this](UmatArgument argument, void* out) {
    std::memcpy(out, at(argument).begin, at(argument).bytes);
  };
  take(stress, call.stress.data());
  take(statev, call.state.data());
  take(ddsdde, call.tangent.data());
  take(pnewdt, &call.smaller);
}

std::optional<UmatArgument> UmatArguments::written_before() const {
  std::array<std::uint32_t, kGuards> sound{};
  sound.fill(kGuard);
  for (std::size_t i = 0; i < kUmatArguments; ++i)
    if (std::memcmp(places_[i].begin - sizeof sound, sound.data(), sizeof sound) != 0)
      return static_cast<UmatArgument>(i);
  return {};
}

std::optional<UmatArguments::Beside> UmatArguments::beside(const void* address) const {
  const auto* const to = static_cast<const std::byte*>(address);
  for (std::size_t i = 0; i < kUmatArguments; ++i) {
    const Place& place = places_[i];
    if (to < place.map || to >= place.map + place.mapped) continue;
    return Beside{static_cast<UmatArgument>(i), to >= place.begin};
  }
  return {};
}

}  // namespace triax::sim
