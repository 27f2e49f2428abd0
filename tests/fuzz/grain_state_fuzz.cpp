// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a state of grains, with a right checksum so that they get past it: read, or refused
// in words. What is read can be written again, and the engine goes on from it with the same result
// whatever the instruction set.
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "sim/grains/engine/grains.hpp"
#include "sim/grains/state/grain_bytes.hpp"
#include "sim/grains/state/grain_measures.hpp"

namespace {

using namespace triax::sim;

/// Empty if the engine gave up: a grain flew too far in one step.
std::vector<std::byte> gone_on(const GrainState& state, int threads, InstructionSet set) {
  Grains grains(state, threads, set);
  if (grains.step(20) != 20) return {};
  grains.set_margin(state.margin);
  if (grains.step(20) != 20) return {};
  return save_grains(grains.state());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* from = reinterpret_cast<const std::byte*>(data);
  std::vector<std::byte> bytes(from, from + size);
  try {
    load_grains(bytes);
  } catch (const std::invalid_argument&) {  // the one way to refuse
  }
  seal_grains(bytes);
  try {
    const GrainState state = load_grains(bytes);
    if (save_grains(state) != bytes) __builtin_trap();
    const GrainMeasures measures = measure(state);
    if (!(measures.porosity < 1)) __builtin_trap();
    if (gone_on(state, 1, InstructionSet::portable) != gone_on(state, 2, best_instruction_set()))
      __builtin_trap();
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
