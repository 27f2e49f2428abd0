// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/grains/state/grain_bytes.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "sim/grains/state/grain_check.hpp"

namespace triax::sim {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::uint64_t kMagic = 0x314e494152475854;  // "TXGRAIN1" as it stands in a file
constexpr std::uint32_t kVersion = 1;

/// FNV-1a, eight bytes at a time and the rest one by one.
std::uint64_t checksum(std::span<const std::byte> bytes) {
  constexpr std::uint64_t kPrime = 0x100000001b3;
  std::uint64_t hash = 0xcbf29ce484222325;
  std::size_t at = 0;
  for (; at + 8 <= bytes.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, 8);
    hash = (hash ^ word) * kPrime;
    hash ^= hash >> 32U;
  }
  for (; at < bytes.size(); ++at)
    hash = (hash ^ std::to_integer<std::uint64_t>(bytes[at])) * kPrime;
  return hash;
}

class Writer {
 public:
  template <class T>
  void operator()(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    append(&value, sizeof value);
  }
  template <class T, class A>
  void operator()(const std::vector<T, A>& values) {
    (*this)(static_cast<std::uint64_t>(values.size()));
    append(values.data(), values.size() * sizeof(T));
  }
  std::vector<std::byte> bytes;

 private:
  void append(const void* data, std::size_t size) {
    const auto* from = static_cast<const std::byte*>(data);
    bytes.insert(bytes.end(), from, from + size);
  }
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}
  template <class T>
  void operator()(T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    take(&value, sizeof value);
  }
  template <class T, class A>
  void operator()(std::vector<T, A>& values) {
    std::uint64_t size = 0;
    (*this)(size);
    if (size > bytes_.size() / sizeof(T)) throw std::invalid_argument("grain state is truncated");
    values.resize(size);
    take(values.data(), size * sizeof(T));
  }
  bool at_end() const { return bytes_.empty(); }

 private:
  void take(void* to, std::size_t size) {
    if (size > bytes_.size()) throw std::invalid_argument("grain state is truncated");
    if (size > 0) std::memcpy(to, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }
  std::span<const std::byte> bytes_;
};

/// Visits every member once, the same way for writing and reading; padding is never visited.
template <class Visit, class State>
void visit_state(Visit& v, State& s) {
  v(s.law.reading), v(s.law.stiffness_over_diameter_pa), v(s.law.tangential_ratio);
  v(s.law.friction_angle), v(s.law.density_kg_per_m3), v(s.law.damping);
  v(s.time_step_s), v(s.margin.listed_m), v(s.margin.near_m);
  v(s.box.low_m), v(s.box.high_m);
  for (auto& d : s.walls.drive) {
    v(d.kind), v(d.leader), v(d.ratio), v(d.strain_rate_per_s);
    v(d.stress_goal_pa), v(d.stress_rate_pa_per_s), v(d.speed_limit_m_per_s);
  }
  v(s.walls.stress_target_pa), v(s.walls.strain_rate_per_s), v(s.walls.learned_rate_per_s);
  v(s.walls.force_n), v(s.walls.stiffness_n_per_m);
  v(s.grains), v(s.ids);
  auto& n = s.neighbours;
  v(n.listed_i), v(n.listed_j);
  v(n.near.listed), v(n.near.i), v(n.near.j);
  for (auto& t : n.near.tangential_n) v(t);
  v(n.near.stiffness_n_per_m), v(n.near.reach_m), v(n.near.half_difference_m);
  for (auto& w : n.listed_at_wall) v(w);
  for (auto& w : n.near_wall) v(w);
  v(n.sorted_at_m), v(n.box_when_sorted.low_m), v(n.box_when_sorted.high_m), v(n.travelled_m);
  v(s.time_s), v(s.steps), v(s.sorts);
}

constexpr std::size_t kHead = sizeof kMagic + sizeof kVersion + sizeof(std::uint64_t);

}  // namespace

std::vector<std::byte> save_grains(const GrainState& state) {
  Writer body;
  visit_state(body, state);
  Writer all;
  all(kMagic);
  all(kVersion);
  all(checksum(body.bytes));
  all.bytes.insert(all.bytes.end(), body.bytes.begin(), body.bytes.end());
  return std::move(all.bytes);
}

GrainState load_grains(std::span<const std::byte> bytes) {
  Reader reader(bytes);
  std::uint64_t magic = 0, sum = 0;
  std::uint32_t version = 0;
  if (bytes.size() < kHead) throw std::invalid_argument("not a grain state");
  reader(magic);
  if (magic != kMagic) throw std::invalid_argument("not a grain state");
  reader(version);
  if (version != kVersion)
    throw std::invalid_argument("grain state of version " + std::to_string(version) +
                                ", this program reads version " + std::to_string(kVersion));
  reader(sum);
  if (checksum(bytes.subspan(kHead)) != sum)
    throw std::invalid_argument("grain state is damaged or truncated");
  GrainState state;
  visit_state(reader, state);
  if (!reader.at_end()) throw std::invalid_argument("grain state has data after its end");
  check(state);
  return state;
}

std::uint64_t fingerprint(const GrainState& state) {
  Writer body;
  visit_state(body, state);
  return checksum(body.bytes);
}

void seal_grains(std::span<std::byte> bytes) {
  if (bytes.size() < kHead) return;
  const std::uint64_t sum = checksum(bytes.subspan(kHead));
  std::memcpy(bytes.data() + kHead - sizeof sum, &sum, sizeof sum);
}

}  // namespace triax::sim
