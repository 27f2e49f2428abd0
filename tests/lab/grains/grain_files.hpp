// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// State files of small specimens of grains, in a folder that goes with the test.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "sim/grains/specimens/assembly.hpp"
#include "sim/grains/specimens/grading.hpp"
#include "sim/grains/state/grain_bytes.hpp"

namespace triax::lab::test {

class GrainFolder {
 public:
  GrainFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "triax_grains_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~GrainFolder() { std::filesystem::remove_all(folder_); }
  GrainFolder(const GrainFolder&) = delete;
  GrainFolder& operator=(const GrainFolder&) = delete;

  std::string operator/(const std::string& name) const { return (folder_ / name).string(); }

  /// 500 spheres at 100 kPa, compacted with this friction (rad), in a file of that name.
  std::string make(const std::string& name, double friction_angle, int grains = 500) const {
    sim::Compaction how;
    how.friction_angle = friction_angle;
    how.unbalanced = 5e-4;
    how.pressure_share = 2e-3;
    const auto made = sim::compact(
        sim::make_cloud(sim::draw_diameters(sim::paper_grading(), grains, 7), 8), {}, how);
    return write(name, made.state);
  }
  std::string write(const std::string& name, const sim::GrainState& state) const {
    const auto bytes = sim::save_grains(state);
    std::ofstream(*this / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    return *this / name;
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace triax::lab::test
