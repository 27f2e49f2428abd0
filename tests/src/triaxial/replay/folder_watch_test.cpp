// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay/folder_watch.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "src/triaxial/replay/folder_replay.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using namespace std::chrono_literals;
using Paths = std::vector<std::string>;

namespace {

void append(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::app) << text;
}

}  // namespace

TEST_CASE("FolderWatch: gives a file once it has been unchanged for two seconds") {
  const testing::TemporaryFolder folder;
  const std::string a = folder.file("a.csv"), b = folder.file("b.csv");
  Paths files{a, b};
  src::FolderWatch watch([&files] { return files; });
  const auto start = src::FolderWatch::Clock::now();
  append(a, "1");
  CHECK(watch.settled(start).empty());
  CHECK(watch.settled(start + 1900ms).empty());
  append(a, "2");  // still written
  CHECK(watch.settled(start + 2000ms).empty());
  CHECK(watch.settled(start + 3900ms).empty());
  append(b, "1");
  CHECK(watch.settled(start + 4000ms) == Paths{a});
  CHECK(watch.settled(start + 5000ms).empty());
  CHECK(watch.settled(start + 6000ms) == Paths{b});
  append(a, "3");
  CHECK(watch.settled(start + 7000ms).empty());
  CHECK(watch.settled(start + 9000ms) == Paths{a});

  std::filesystem::remove(a);  // and comes back, with the same size
  CHECK(watch.settled(start + 10s).empty());
  append(a, "123");
  CHECK(watch.settled(start + 11s).empty());
  CHECK(watch.settled(start + 13s) == Paths{a});
  watch.repeat(a, start + 13s, 10s);
  CHECK(watch.settled(start + 20s).empty());
  CHECK(watch.settled(start + 23s) == Paths{a});
  watch.repeat(folder.file("never"), start, 1s);
}

TEST_CASE("files_of_folder: leaves out what is no record of its own") {
  const testing::TemporaryFolder folder;
  for (const char* name : {"b.csv", "a.txt", ".hidden.csv", "b.toml", "t.db", "t.db-wal", "c.csv~",
                           "t.db.waiting-12", "notes.pdf"})
    append(folder.file(name), "x");
  std::filesystem::create_directory(folder.file("inner.csv"));
  CHECK(src::files_of_folder(folder.file("")) ==
        Paths{folder.file("a.txt"), folder.file("b.csv"), folder.file("notes.pdf")});
  CHECK_THROWS_AS(src::files_of_folder(folder.file("none")), lab::BadInput);
}
