// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/byte_source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "lab/base/bad_input.hpp"

namespace triax::lab {
namespace {

class FileSource : public ByteSource {
 public:
  explicit FileSource(const std::string& path) : name_(path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) cannot_open();
    if (S_ISDIR(status.st_mode)) throw BadInput(path, 0, "is a folder; expected a file");
    if (!S_ISREG(status.st_mode))
      throw BadInput(path, 0, "is not a regular file; expected a file on disk");
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) cannot_open();
    size_ = static_cast<std::uint64_t>(status.st_size);
  }
  ~FileSource() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;

  const std::string& name() const override { return name_; }
  std::uint64_t size() const override { return size_; }
  std::size_t read(std::span<char> into) override {
    ssize_t count = 0;
    do {
      count = ::pread(descriptor_, into.data(), into.size(), static_cast<off_t>(at_));
    } while (count < 0 && errno == EINTR);
    if (count < 0) throw WorkFailed(name_ + ": cannot be read: " + std::strerror(errno));
    at_ += static_cast<std::uint64_t>(count);
    return static_cast<std::size_t>(count);
  }
  void rewind() override { at_ = 0; }
  std::unique_ptr<ByteSource> duplicate() const override {
    const int descriptor = ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
    if (descriptor < 0) return nullptr;
    return std::unique_ptr<FileSource>(new FileSource(name_, descriptor, size_));
  }
  bool is_seekable() const override { return true; }
  void skip(std::uint64_t count) override { at_ += count; }

 private:
  FileSource(std::string name, int descriptor, std::uint64_t size)
      : name_(std::move(name)), descriptor_(descriptor), size_(size) {}
  [[noreturn]] void cannot_open() const { throw BadInput(name_, 0, describe_open_error(errno)); }

  std::string name_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::uint64_t at_ = 0;  ///< of the next byte; a duplicate has its own
};

class MemorySource : public ByteSource {
 public:
  MemorySource(std::string name, std::string bytes)
      : name_(std::move(name)), bytes_(std::move(bytes)) {}
  const std::string& name() const override { return name_; }
  std::uint64_t size() const override { return bytes_.size(); }
  std::size_t read(std::span<char> into) override {
    const auto count = std::min(into.size(), bytes_.size() - at_);
    std::copy_n(bytes_.data() + at_, count, into.data());
    at_ += count;
    return count;
  }
  void rewind() override { at_ = 0; }
  bool is_seekable() const override { return true; }
  void skip(std::uint64_t count) override {
    at_ += static_cast<std::size_t>(std::min<std::uint64_t>(count, bytes_.size() - at_));
  }

 private:
  std::string name_;
  std::string bytes_;
  std::size_t at_ = 0;
};

}  // namespace

void ByteSource::skip(std::uint64_t count) {
  std::array<char, 4096> block{};
  while (count > 0) {
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(count, block.size()));
    const auto taken = read({block.data(), part});
    if (taken == 0) return;
    count -= taken;
  }
}

std::string describe_open_error(int error) {
  return error == ENOENT ? "file does not exist"
                         : std::string("cannot be opened: ") + std::strerror(error);
}

std::unique_ptr<ByteSource> open_file(const std::string& path) {
  return std::make_unique<FileSource>(path);
}

std::unique_ptr<ByteSource> open_memory(std::string name, std::string bytes) {
  return std::make_unique<MemorySource>(std::move(name), std::move(bytes));
}

}  // namespace triax::lab
