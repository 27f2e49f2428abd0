// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/grains/grain_files.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "lab/base/bad_input.hpp"
#include "sim/grains/state/grain_bytes.hpp"
#include "tests/sim/grains/packings.hpp"

using namespace triax;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

struct Folder {
  fs::path path = fs::temp_directory_path() / "triax_grain_files_test";
  Folder() {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~Folder() { fs::remove_all(path); }
  std::string file(const char* name) const { return (path / name).string(); }
};

sim::GrainState moving_state() {
  sim::GrainState state = sim::test::lattice(4);
  sim::test::shake(state, 0.1);
  sim::Grains grains(state);
  grains.step(30);
  return grains.state();
}

}  // namespace

TEST_CASE("a state that was saved and loaded goes on bit for bit") {
  const Folder folder;
  const sim::GrainState state = moving_state();
  lab::save_state(folder.file("a.state"), state);
  sim::Grains original(state), loaded(lab::load_state(folder.file("a.state")));
  original.step(200);
  loaded.step(200);
  CHECK(sim::test::same_bits(original.state(), loaded.state()));
  // Nothing else lies there.
  CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);
}

TEST_CASE("a state that cannot be written leaves nothing") {
  const Folder folder;
  CHECK_THROWS_AS(lab::save_state(folder.path.string(), moving_state()), lab::BadInput);
  CHECK_THROWS_AS(lab::save_state(folder.file("no/such/folder"), moving_state()), lab::BadInput);
  CHECK(fs::is_empty(folder.path));
}

TEST_CASE("a file that is no state is refused in one line that names it") {
  const Folder folder;
  const std::string path = folder.file("a.state");
  const auto refused = [&](const std::string& words) {
    try {
      lab::load_state(path);
    } catch (const lab::BadInput& error) {
      const std::string message = error.what();
      INFO(message);
      CHECK(message.rfind(path + ": ", 0) == 0);
      CHECK(message.find(words) != std::string::npos);
      CHECK(message.find('\n') == std::string::npos);
      return;
    }
    FAIL("accepted; should have said: " << words);
  };
  const auto put = [&](std::string_view bytes) { std::ofstream(path, std::ios::binary) << bytes; };
  refused("file does not exist");
  put("");
  refused("not a grain state");
  put("TXGRAIN1 but nothing else that would be a state");
  refused("version");
  lab::save_state(path, moving_state());
  fs::resize_file(path, fs::file_size(path) - 1);
  refused("truncated");
  fs::resize_file(path, lab::kLargestStateFile + 1);
  refused("larger than 4 GiB");
  fs::remove(path);
  fs::create_directory(path);
  refused("is not a regular file");
  CHECK_THROWS_WITH(lab::load_state("/dev/null"), Contains("/dev/null: is not a regular file"));

  // With a right checksum, too.
  fs::remove(path);
  sim::GrainState bad = moving_state();
  bad.grains[5].radius = -1;
  lab::save_state(path, bad);
  refused("a radius must be above 0");
}
