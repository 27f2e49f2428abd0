// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/rows/reversed_rows.hpp"

#include <vector>

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"
#include "lab/base/line_reader.hpp"

using namespace triax::lab;

namespace {

/// Gives its bytes in small pieces and cannot skip without reading.
class SlowSource : public ByteSource {
 public:
  explicit SlowSource(std::string text) : text_(open_memory("slow", std::move(text))) {}
  const std::string& name() const override { return text_->name(); }
  std::uint64_t size() const override { return text_->size(); }
  std::size_t read(std::span<char> into) override {
    return text_->read(into.first(std::min<std::size_t>(into.size(), 3)));
  }
  void rewind() override { text_->rewind(); }

 private:
  std::unique_ptr<ByteSource> text_;
};

std::string all_of(ByteSource& source) {
  std::string out;
  std::vector<char> block(7);
  while (const auto count = source.read(block)) out.append(block.data(), count);
  return out;
}

std::string reversed(const std::string& text, std::int64_t first, std::int64_t last) {
  ReversedRows rows(open_memory("m", text), first, last);
  const std::string once = all_of(rows);
  rows.rewind();
  CHECK(all_of(rows) == once);
  ReversedRows slow(std::make_unique<SlowSource>(text), first, last);
  CHECK(all_of(slow) == once);
  return once;
}

}  // namespace

TEST_CASE("ReversedRows: only the rows change their order") {
  CHECK(reversed("h\n1\n2\n3\nend\n", 2, 4) == "h\n3\n2\n1\nend\n");
  CHECK(reversed("h\r\n1\r\n2\r\n", 2, 3) == "h\r\n2\r\n1\r\n");
}

TEST_CASE("ReversedRows: empty lines and a missing line end are kept apart") {
  CHECK(reversed("h\n1\n\n3", 2, 4) == "h\n3\n\n1\n");
  CHECK(reversed("1\n2", 1, 9) == "2\n1\n");
  CHECK(reversed("\n\n", 1, 2) == "\n\n");
  CHECK(reversed("", 1, 1).empty());
  CHECK(reversed("h\n", 2, 5) == "h\n");
}

TEST_CASE("ReversedRows: lines across blocks are whole") {
  std::string text = "head\n", expected = "head\n";
  for (int i = 0; i < 30'000; ++i) text += std::to_string(i) + ",1.5\n";
  for (int i = 30'000; i-- > 0;) expected += std::to_string(i) + ",1.5\n";
  ReversedRows rows(open_memory("m", text), 2, 30'001);
  CHECK(all_of(rows) == expected);
}

TEST_CASE("ReversedRows: the file is the one that was given") {
  auto file = open_memory("m", "h\n1\n");
  const ByteSource* given = file.get();
  ReversedRows rows(std::move(file), 2, 2);
  CHECK(&rows.file() == given);
}

TEST_CASE("ReversedRows: a line without end is an error, not a memory") {
  ReversedRows rows(open_memory("m", "h\n" + std::string(kMaxLine_bytes * 2, '1')), 2, 2);
  CHECK_THROWS_AS(all_of(rows), BadInput);
}
