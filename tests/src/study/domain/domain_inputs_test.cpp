// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/domain/domain_inputs.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

using namespace triax;
using namespace triax::study;

TEST_CASE("the library of a UMAT is found beside its set, and its digest is that of its bytes") {
  const auto folder =
      std::filesystem::temp_directory_path() / ("triax_inputs_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "own.so") << "abc";
  lab::MaterialSet set;
  set.parameters.folder = folder.string();
  set.parameters.texts["umat"] = "own.so";
  set.parameters.texts["name"] = "own.so";  // a word that happens to be a file's name
  CHECK(files_named_by(set) == std::vector{(folder / "own.so").string()});
  const auto digests = digests_of_files(set);
  REQUIRE(digests.size() == 1);
  CHECK(digests[0].first == "umat");
  // FIPS 180-2, appendix B.1
  CHECK(digests[0].second == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  set.parameters.texts["umat"] = "gone.so";
  CHECK(files_named_by(set).empty());
  CHECK(digests_of_files(lab::find_material("inl2/S28-general")).empty());
  std::filesystem::remove_all(folder);
}
