// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/request/upload.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/base/whole_file.hpp"

namespace triax::src {
namespace {

/// Reads by place, so that several may read one file.
class UploadSource : public lab::ByteSource {
 public:
  UploadSource(int descriptor, std::uint64_t size, std::string name)
      : descriptor_(descriptor), size_(size), name_(std::move(name)) {}

  const std::string& name() const override { return name_; }
  std::uint64_t size() const override { return size_; }
  std::size_t read(std::span<char> into) override {
    ssize_t count = 0;
    do {
      count = ::pread(descriptor_, into.data(), into.size(), static_cast<off_t>(at_));
    } while (count < 0 && errno == EINTR);
    if (count < 0) throw lab::WorkFailed(name_ + ": cannot be read: " + std::strerror(errno));
    at_ += static_cast<std::uint64_t>(count);
    return static_cast<std::size_t>(count);
  }
  void rewind() override { at_ = 0; }

 private:
  int descriptor_;
  std::uint64_t size_, at_ = 0;
  std::string name_;
};

}  // namespace

Upload::Upload(const std::string& folder) {
  const std::string where = folder.empty() ? "." : folder;
  descriptor_ = ::open(where.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (descriptor_ < 0) {  // a file system without files that have no name
    std::string path = where + "/.triax-upload-XXXXXX";
    descriptor_ = ::mkostemp(path.data(), O_CLOEXEC);
    if (descriptor_ >= 0) ::unlink(path.c_str());
  }
  if (descriptor_ < 0)
    throw lab::WorkFailed(where + ": the record cannot be stored: " + std::strerror(errno));
}

Upload::Upload(int descriptor) : descriptor_(descriptor) {
  struct stat file {};
  if (::fstat(descriptor, &file) != 0)
    throw lab::WorkFailed(std::string("the record cannot be read: ") + std::strerror(errno));
  size_ = static_cast<std::uint64_t>(file.st_size);
}

Upload::~Upload() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void Upload::write(std::string_view bytes) {
  if (!lab::write_all(descriptor_, bytes))
    throw lab::WorkFailed(std::string("the record cannot be written: ") + std::strerror(errno));
  size_ += bytes.size();
}

std::unique_ptr<lab::ByteSource> Upload::source(const std::string& name) const {
  return std::make_unique<UploadSource>(descriptor_, size_, name);
}

}  // namespace triax::src
