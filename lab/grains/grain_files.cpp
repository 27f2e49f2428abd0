// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_files.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "lab/base/bad_input.hpp"
#include "lab/base/whole_file.hpp"
#include "sim/grains/state/grain_bytes.hpp"

namespace triax::lab {

void save_state(const std::string& path, const sim::GrainState& state) {
  const std::vector<std::byte> bytes = sim::save_grains(state);
  if (bytes.size() > kLargestStateFile)
    throw WorkFailed(path + ": the state is larger than 4 GiB, the largest that can be read");
  WholeFile file(path);
  file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  file.finish();
}

sim::GrainState load_state(const std::string& path) {
  std::error_code none;
  const auto status = std::filesystem::status(path, none);
  if (!std::filesystem::exists(status))
    throw BadInput(path, 0, "file does not exist; expected a state saved by triax grains");
  if (!std::filesystem::is_regular_file(status))
    throw BadInput(path, 0, "is not a regular file; expected a state saved by triax grains");
  const std::uintmax_t size = std::filesystem::file_size(path, none);
  if (none || size > kLargestStateFile)
    throw BadInput(path, 0, "is larger than 4 GiB, the largest grain state that can be read");
  std::vector<std::byte> bytes(size);
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!file) throw BadInput(path, 0, "cannot be read");
  try {
    return sim::load_grains(bytes);
  } catch (const std::invalid_argument& error) {
    throw BadInput(path, 0, std::string(error.what()) + "; expected a state saved by triax grains");
  }
}

}  // namespace triax::lab
