// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/whole_file.hpp"

#include <fcntl.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "lab/base/bad_input.hpp"
#include "lab/base/toml_reader.hpp"

using namespace triax::lab;
namespace fs = std::filesystem;

namespace {
struct Folder {
  fs::path path = fs::temp_directory_path() / ("triax_whole_" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  std::string operator/(const char* name) const { return (path / name).string(); }
  std::ptrdiff_t files() const { return std::distance(fs::directory_iterator(path), {}); }
};

void put(const std::string& path, const std::string& text) {
  WholeFile file(path);
  file.write(text);
  file.finish();
}
}  // namespace

TEST_CASE("a file appears with finish() and replaces an older one, whose permissions stay") {
  const Folder folder;
  put(folder / "a", "old");
  ::chmod((folder / "a").c_str(), 0600);
  {
    WholeFile file(folder / "a");
    file.write("new");
    CHECK(read_text_file(folder / "a") == "old");
    file.finish();
  }
  CHECK(read_text_file(folder / "a") == "new");
  CHECK(fs::status(folder / "a").permissions() == fs::perms(0600));
  CHECK(folder.files() == 1);
  { WholeFile(folder / "b").write("lost"); }
  CHECK(folder.files() == 1);
}

TEST_CASE("a new file never has another name, which a kill would leave behind") {
  const Folder folder;
  const int watch = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  REQUIRE(::inotify_add_watch(watch, folder.path.c_str(), IN_CREATE | IN_MOVED_TO) >= 0);
  put(folder / "a", "x");
  alignas(inotify_event) std::array<char, 4096> events{};
  const auto told = ::read(watch, events.data(), events.size());
  ::close(watch);
  const auto* const first = reinterpret_cast<const inotify_event*>(events.data());
  REQUIRE(told > 0);
  CHECK(first->name == std::string("a"));
  CHECK(told == static_cast<std::ptrdiff_t>(sizeof *first + first->len));
}

TEST_CASE("a new file has the permissions that the user's mask leaves") {
  const Folder folder;
  const auto before = ::umask(027);
  put(folder / "a", "x");
  ::umask(before);
  CHECK(fs::status(folder / "a").permissions() == fs::perms(0640));
}

TEST_CASE("a symbolic link stays a link; what it points at is written, also if that is new") {
  const Folder folder;
  put(folder / "real", "old");
  fs::create_symlink("real", folder / "link");
  fs::create_symlink("fresh", folder / "dangling");
  put(folder / "link", "new");
  put(folder / "dangling", "first");
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(fs::is_symlink(folder / "dangling"));
  CHECK(read_text_file(folder / "real") == "new");
  CHECK(read_text_file(folder / "fresh") == "first");
  CHECK(behind_links(folder / "dangling") == folder / "fresh");
}

TEST_CASE("what is no regular file is refused and stays what it is") {
  const Folder folder;
  ::mkfifo((folder / "pipe").c_str(), 0600);
  CHECK_THROWS_AS(WholeFile(folder / "pipe"), BadInput);
  CHECK_THROWS_AS(WholeFile("/dev/null"), BadInput);
  CHECK_THROWS_AS(WholeFile(folder.path.string()), BadInput);
  CHECK(fs::is_fifo(folder / "pipe"));
  CHECK_THROWS_WITH(WholeFile(folder / "none/a"), Catch::EndsWith("create it first"));
}

TEST_CASE("all bytes reach a descriptor, and a full device is told") {
  const Folder folder;
  const int full = ::open("/dev/full", O_WRONLY);
  REQUIRE(full >= 0);
  CHECK_FALSE(write_all(full, "x"));
  CHECK(errno == ENOSPC);
  ::close(full);
  const int file = ::open((folder / "a").c_str(), O_WRONLY | O_CREAT, 0600);
  CHECK(write_all(file, std::string(100000, 'a')));
  ::close(file);
  CHECK(fs::file_size(folder / "a") == 100000);
}
