// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/base/digest.hpp"

#include <catch2/catch.hpp>

using namespace triax::lab;

namespace {
std::string digest_of_text(const std::string& bytes) { return sha256(*open_memory("m", bytes)); }
}  // namespace

TEST_CASE("digests are those of the standard's examples (FIPS 180-4)") {
  CHECK(digest_of_text("abc") ==
        "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(digest_of_text("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  // Longer than one block of reading.
  CHECK(digest_of_text(std::string(1000000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("all bytes count wherever the source stood, and it stands at its start again") {
  const auto source = open_memory("m", "abc");
  char first = 0;
  source->read(std::span(&first, 1));
  CHECK(sha256(*source) == digest_of_text("abc"));
  source->read(std::span(&first, 1));
  CHECK(first == 'a');
}
