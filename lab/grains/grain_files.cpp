#include "lab/grains/grain_files.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "lab/records/bad_input.hpp"
#include "lab/records/whole_file.hpp"
#include "sim/grains/grain_bytes.hpp"

namespace triax::lab {

void save_state(const std::string& path, const sim::GrainState& state) {
  const auto bytes = sim::save_grains(state);
  WholeFile file(path);
  file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  file.finish();
}

sim::GrainState load_state(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw BadInput(path + ": cannot be read");
  std::ostringstream all;
  all << in.rdbuf();
  const std::string text = all.str();
  try {
    return sim::load_grains(std::as_bytes(std::span(text)));
  } catch (const std::invalid_argument& error) {
    throw BadInput(path + ": " + error.what());
  }
}

}  // namespace triax::lab
