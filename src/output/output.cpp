#include "src/output/output.hpp"

#include <fmt/format.h>

#include <QSaveFile>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "lab/records/bad_input.hpp"

namespace triax::src {

namespace {

void require(bool written) {
  if (!written)
    throw lab::WorkFailed(fmt::format("cannot write to standard output: {}", std::strerror(errno)));
}

}  // namespace

void print(std::string_view text) {
  put(text);
  require(std::fflush(stdout) == 0);
}

void put(std::string_view text) {
  require(std::fwrite(text.data(), 1, text.size(), stdout) == text.size());
}

void write_file(const std::string& path, std::string_view bytes) {
  if (path == "-") return print(bytes);
  QSaveFile file(QString::fromStdString(path));
  const auto size = static_cast<qint64>(bytes.size());
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes.data(), size) != size || !file.commit())
    throw lab::WorkFailed(
        fmt::format("{}: cannot be written: {}", path, file.errorString().toStdString()));
}

}  // namespace triax::src
