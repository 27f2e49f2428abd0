// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/output_guard.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "lab/base/bad_input.hpp"

using namespace triax;
using Catch::Matchers::Contains;

TEST_CASE("an output is refused under every name of a kept file, and only then") {
  const auto folder =
      std::filesystem::temp_directory_path() / ("triax_guard_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder / "inner");
  const auto path = [&](const char* name) { return (folder / name).string(); };
  std::ofstream(path("a.db")) << "x";
  std::filesystem::create_symlink("a.db", path("soft.db"));
  std::filesystem::create_hard_link(path("a.db"), path("hard.db"));
  const auto refused = [&](const std::string& output, const std::string& db) {
    try {
      src::refuse_overwriting("--output", output, src::database_files(db), "the database");
    } catch (const lab::BadInput& error) {
      CHECK_THAT(error.what(), Contains("--output " + output) && Contains("the database"));
      return true;
    }
    return false;
  };
  for (const char* name : {"a.db", "soft.db", "hard.db", "inner/../a.db", "a.db-wal", "a.db-shm"})
    CHECK(refused(path(name), path("a.db")));
  CHECK(refused(path("a.db-wal"), path("soft.db")));
  CHECK(refused(path("new.db"), path("inner/../new.db")));
  CHECK_FALSE(refused(path("b.db"), path("a.db")));
  CHECK_FALSE(refused("-", path("a.db")));
  CHECK_FALSE(refused("", path("a.db")));
  std::filesystem::remove_all(folder);
}

TEST_CASE("a folder for the output: one that is there, one that can be made, and none of both") {
  const auto base =
      std::filesystem::temp_directory_path() / ("triax_folder_" + std::to_string(::getpid()));
  std::filesystem::create_directories(base / "there" / "probe.svg");
  std::ofstream(base / "file") << "x";
  const auto check = [&](const std::string& name, const std::string& command) {
    const std::string folder = (base / name).string();
    src::check_folder("--output", folder, src::files_of_prefix(src::prefix_in(folder, command)));
    CHECK((std::filesystem::exists(folder) == (name == "there")));  // looking makes nothing
  };
  CHECK_NOTHROW(check("there", "domain"));
  CHECK_NOTHROW(check("none/yet", "domain"));
  CHECK_THROWS_WITH(check("there", "probe"), Contains("probe.svg is a folder"));
  CHECK_THROWS_WITH(check("file", "probe"), Contains("is a file; expected a folder"));
  CHECK_THROWS_WITH(check("file/deep", "probe"), Contains("file is a file; expected a folder"));
  CHECK_NOTHROW(src::check_folder("--output", "", {"x"}));
  CHECK(src::prefix_in("", "probe").empty());
  src::make_folder("--output", (base / "a/b").string());
  CHECK(std::filesystem::is_directory(base / "a/b"));
  CHECK_THROWS_WITH(src::make_folder("--output", (base / "file/b").string()),
                    Contains("file/b: folder cannot be created: Not a directory"));
  std::filesystem::remove_all(base);
}

TEST_CASE("targets are looked at before the work: folders, missing folders, a name that is none") {
  const auto folder =
      std::filesystem::temp_directory_path() / ("triax_targets_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder / "x.svg");
  const auto check = [&](const std::string& prefix) {
    const std::string output = (folder / prefix).string();
    src::check_targets("--output", output, src::files_of_prefix(output, {"", "_cones"}));
  };
  CHECK_NOTHROW(check("y"));
  CHECK_THROWS_WITH(check("x"), Contains("x.svg is a folder"));
  CHECK_THROWS_AS(check("x"), lab::BadInput);
  CHECK_THROWS_WITH(check("none/y"), Contains("none does not exist; create it first"));
  CHECK_THROWS_AS(check("x.svg/"), lab::BadInput);
  CHECK_NOTHROW(src::check_targets("--output", "-", {"-"}));
  CHECK_NOTHROW(src::check_targets("--output", "", {".csv"}));
  CHECK_NOTHROW(src::check_targets("--output", "/dev/null", {"/dev/null"}));
  std::filesystem::create_symlink("none/there", folder / "z.csv");
  CHECK_THROWS_AS(check("z"), lab::BadInput);
  const auto files = src::files_of_prefix("p", {"", "_cones"});
  CHECK(files.size() == 10);
  CHECK(files.back() == "p_cones.pdf");
  std::filesystem::remove_all(folder);
}
