// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/digest.hpp"

#include <QByteArrayView>
#include <QCryptographicHash>
#include <vector>

namespace triax::lab {

std::string sha256(ByteSource& source) {
  constexpr std::size_t kBlock = 1U << 16;
  std::vector<char> block(kBlock);
  QCryptographicHash hash(QCryptographicHash::Sha256);
  source.rewind();
  while (const std::size_t count = source.read(block))
    hash.addData(QByteArrayView(block.data(), static_cast<qsizetype>(count)));
  source.rewind();
  return hash.result().toHex().toStdString();
}

}  // namespace triax::lab
