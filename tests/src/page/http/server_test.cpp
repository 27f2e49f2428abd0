// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/http/server.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax;
using namespace triax::src;

namespace {

/// What is wrong with listening there; empty where nothing is.
std::string refusal(std::vector<std::string> listen) {
  try {
    PageServer server({.listen = std::move(listen), .answer = {}});
    return server.port() == 0 ? "no port" : "";
  } catch (const lab::BadInput& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("a name that stands for this machine only is refused, and an address asked for") {
  // A name, not an address, to who reads addresses; the system resolves it to 127.0.0.1 everywhere.
  const std::string told = refusal({"127.1"});
  CHECK(told.find("itself only (127.0.0.1)") != std::string::npos);
  CHECK(told.find("give the address") != std::string::npos);
  CHECK(refusal({"127.0.0.1"}).empty());
  CHECK(refusal({"0.0.0.0"}).find("give the name or the address") != std::string::npos);
}

TEST_CASE("two names of one address are listened to once") {
  CHECK(refusal({"localhost", "127.0.0.1"}).empty());
  CHECK(refusal({"127.0.0.1", "127.0.0.1"}).empty());
}
