// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "lab/base/bad_input.hpp"
#include "lab/base/whole_file.hpp"
#include "src/output/written_files.hpp"

namespace triax::src {

namespace {

void require(bool written) {
  if (!written && errno == EPIPE) throw ClosedPipe();
  if (!written)
    throw lab::WorkFailed(
        fmt::format("standard output cannot be written: {}", std::strerror(errno)));
}

/// What passes bytes on and keeps none: nothing there to be replaced, nothing to appear whole.
bool passes_on(const std::string& path) {
  struct stat present {};
  return ::stat(path.c_str(), &present) == 0 &&
         (S_ISCHR(present.st_mode) || S_ISFIFO(present.st_mode));
}

void write_straight(const std::string& path, std::string_view bytes) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  const bool written = descriptor >= 0 && lab::write_all(descriptor, bytes);
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!written) throw lab::WorkFailed(lab::describe_write_error(path, error));
}

}  // namespace

void print(std::string_view text) {
  put(text);
  require(std::fflush(stdout) == 0);
}

void put(std::string_view text) {
  if (text.empty()) return;  // fwrite must not be given the null of an empty view
  require(std::fwrite(text.data(), 1, text.size(), stdout) == text.size());
}

void write_file(const std::string& path, std::string_view bytes) {
  if (path == "-") return print(bytes);
  if (passes_on(path)) return write_straight(path, bytes);
  const WrittenFile noted(path);
  lab::WholeFile file(path);
  file.write(bytes);
  file.finish();
  noted.is_there();
}

}  // namespace triax::src
