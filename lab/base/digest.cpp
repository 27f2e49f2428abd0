// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/digest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <openssl/evp.h>

#include <array>
#include <memory>
#include <vector>

#include "lab/base/bad_input.hpp"

namespace triax::lab {

std::string sha256(ByteSource& source) {
  constexpr std::size_t kBlock = 1U << 16;
  std::vector<char> block(kBlock);
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> hash(EVP_MD_CTX_new(),
                                                                     &EVP_MD_CTX_free);
  bool good = hash && EVP_DigestInit_ex(hash.get(), EVP_sha256(), nullptr) == 1;
  source.rewind();
  while (const std::size_t count = source.read(block))
    good = good && EVP_DigestUpdate(hash.get(), block.data(), count) == 1;
  source.rewind();
  std::array<unsigned char, 32> digest{};
  if (!good || EVP_DigestFinal_ex(hash.get(), digest.data(), nullptr) != 1)
    throw WorkFailed("libcrypto does not provide SHA-256");
  return fmt::format("{:02x}", fmt::join(digest, ""));
}

}  // namespace triax::lab
