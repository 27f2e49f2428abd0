// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/workbook/zip_archive.hpp"

#include <zip.h>

#include <utility>

#include "lab/base/bad_input.hpp"

namespace triax::lab {
namespace {

constexpr zip_int64_t kMostParts = 10'000;
constexpr std::uint64_t kUnpackedBeforeDoubt = std::uint64_t{16} << 20;

[[noreturn]] void no_archive(const std::string& name, int code) {
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  const std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  throw BadInput(name, 0,
                 "begins like a workbook, but is damaged or incomplete: " + text +
                     "; copy or save the file again");
}

}  // namespace

struct ZipPart::Impl {
  std::string name;  ///< of the archive
  zip_file_t* file = nullptr;
  ~Impl() {
    if (file != nullptr) zip_fclose(file);
  }
};

struct ZipArchive::Impl {
  std::string name;
  std::string bytes;  ///< of an archive in memory
  zip_t* archive = nullptr;
  ~Impl() {
    if (archive != nullptr) zip_discard(archive);
  }
  void check_parts() const {
    if (zip_get_num_entries(archive, 0) > kMostParts)
      throw BadInput(name, 0, "an archive of more than 10000 parts, too many for a workbook");
  }
};

ZipPart::ZipPart(std::unique_ptr<Impl> impl, std::uint64_t packed)
    : impl_(std::move(impl)), packed_(packed) {}
ZipPart::~ZipPart() = default;
ZipPart::ZipPart(ZipPart&&) noexcept = default;

std::size_t ZipPart::read(std::span<char> into) {
  const auto count = zip_fread(impl_->file, into.data(), into.size());
  if (count < 0)
    throw BadInput(impl_->name, 0,
                   std::string("the workbook is damaged (") + zip_file_strerror(impl_->file) +
                       "); copy it again");
  unpacked_ += static_cast<std::uint64_t>(count);
  if (unpacked_ > kUnpackedBeforeDoubt && unpacked_ / ZipArchive::kMostPacked > packed_)
    throw BadInput(impl_->name, 0,
                   "a part of it unpacks to more than 300 times its size; reading stopped");
  return static_cast<std::size_t>(count);
}

ZipArchive::ZipArchive(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ZipArchive::~ZipArchive() = default;
ZipArchive::ZipArchive(ZipArchive&&) noexcept = default;

ZipArchive ZipArchive::open(const std::string& path) {
  auto impl = std::make_unique<Impl>();
  impl->name = path;
  int code = 0;
  impl->archive = zip_open(path.c_str(), ZIP_RDONLY, &code);
  if (impl->archive == nullptr) no_archive(path, code);
  impl->check_parts();
  return ZipArchive(std::move(impl));
}

ZipArchive ZipArchive::in_memory(const std::string& name, std::string bytes) {
  auto impl = std::make_unique<Impl>();
  impl->name = name;
  impl->bytes = std::move(bytes);
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source =
      zip_source_buffer_create(impl->bytes.data(), impl->bytes.size(), 0, &error);
  if (source != nullptr) impl->archive = zip_open_from_source(source, ZIP_RDONLY, &error);
  const int code = zip_error_code_zip(&error);
  zip_error_fini(&error);
  if (impl->archive == nullptr) {
    if (source != nullptr) zip_source_free(source);
    no_archive(name, code);
  }
  impl->check_parts();
  return ZipArchive(std::move(impl));
}

const std::string& ZipArchive::name() const { return impl_->name; }

bool ZipArchive::has(const std::string& part) const {
  return zip_name_locate(impl_->archive, part.c_str(), 0) >= 0;
}

bool ZipArchive::has_part_ending(const std::string& ending) const {
  const auto count = zip_get_num_entries(impl_->archive, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* const name = zip_get_name(impl_->archive, static_cast<zip_uint64_t>(i), 0);
    if (name != nullptr && std::string(name).ends_with(ending)) return true;
  }
  return false;
}

ZipPart ZipArchive::part(const std::string& part) const {
  zip_stat_t status;
  zip_stat_init(&status);
  const auto index = zip_name_locate(impl_->archive, part.c_str(), 0);
  if (index < 0) throw BadInput(name(), 0, "the workbook has no part " + part + "; save it again");
  zip_stat_index(impl_->archive, static_cast<zip_uint64_t>(index), 0, &status);
  auto open = std::make_unique<ZipPart::Impl>();
  open->name = name();
  open->file = zip_fopen_index(impl_->archive, static_cast<zip_uint64_t>(index), 0);
  if (open->file == nullptr)
    throw BadInput(name(), 0,
                   "the part " + part + " cannot be unpacked: " + zip_strerror(impl_->archive));
  return {std::move(open), status.comp_size};
}

XmlInput xml_of(const ZipArchive& archive, const std::string& part) {
  const auto shared = std::make_shared<ZipPart>(archive.part(part));
  return {.name = archive.name(),
          .read = [shared](std::span<char> into) { return shared->read(into); },
          .kind = "workbook",
          .remedy = "open it in a spreadsheet and save it again"};
}

}  // namespace triax::lab
