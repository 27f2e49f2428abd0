#include "src/commands/output_guard.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "lab/records/bad_input.hpp"

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
