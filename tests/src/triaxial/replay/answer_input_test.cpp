// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay/answer_input.hpp"

#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <string_view>

using namespace triax::src;

namespace {

/// A pipe that gives these bytes and ends.
class ByteInput {
 public:
  explicit ByteInput(std::string_view bytes) {
    REQUIRE(pipe(ends_.data()) == 0);
    REQUIRE(write(ends_[1], bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
  }
  ~ByteInput() {
    close(ends_[0]);
    if (!is_closed_) close(ends_[1]);
  }
  ByteInput(const ByteInput&) = delete;
  ByteInput& operator=(const ByteInput&) = delete;
  void end() {
    close(ends_[1]);
    is_closed_ = true;
  }
  int descriptor() const { return ends_[0]; }

 private:
  std::array<int, 2> ends_{};
  bool is_closed_ = false;
};

}  // namespace

TEST_CASE("AnswerInput: lines, empty lines and a last line without an end") {
  ByteInput bytes("min\n\n300");
  bytes.end();
  const Interruption interruption;
  AnswerInput input(interruption, bytes.descriptor());
  CHECK_FALSE(input.is_terminal());
  CHECK(input.next() == "min");
  CHECK(input.next() == "");
  CHECK(input.next() == "300");
  CHECK_FALSE(input.next());
  CHECK_FALSE(input.next());
}

TEST_CASE("AnswerInput: a long line is cut, the next one is whole") {
  ByteInput bytes(std::string(3 * AnswerInput::kMaxLine_bytes, 'x') + "\nmin\n");
  const Interruption interruption;
  AnswerInput input(interruption, bytes.descriptor());
  CHECK(input.next()->size() == AnswerInput::kMaxLine_bytes);
  CHECK(input.next() == "min");
}

TEST_CASE("AnswerInput: Ctrl-C ends the wait for a line") {
  const ByteInput bytes("mi");
  const Interruption interruption;
  AnswerInput input(interruption, bytes.descriptor());
  std::raise(SIGINT);
  CHECK_FALSE(input.next());
}
