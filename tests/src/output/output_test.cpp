// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/output.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <filesystem>

#include "lab/base/bad_input.hpp"

using namespace triax;

TEST_CASE("a pipe is written straight and stays a pipe; a full device is told; a folder refused") {
  const auto folder =
      std::filesystem::temp_directory_path() / ("triax_output_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const std::string pipe = (folder / "pipe").string();
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  src::write_file(pipe, "through");
  std::array<char, 16> found{};
  CHECK(::read(reader, found.data(), found.size()) == 7);
  CHECK(std::string(found.data()) == "through");
  ::close(reader);
  CHECK(std::filesystem::is_fifo(pipe));
  CHECK_THROWS_AS(src::write_file("/dev/full", "x"), lab::WorkFailed);
  CHECK_THROWS_AS(src::write_file(folder.string(), "x"), lab::BadInput);
  std::filesystem::remove_all(folder);
}
