// SPDX-License-Identifier: GPL-3.0-or-later
// The fuzzers start from tests/fuzz/seeds: each seed gets past the parser that it is for, so that
// what lies behind the first check is reached too.
#include <catch2/catch.hpp>
#include <filesystem>
#include <sstream>

#include "lab/ags/triaxial_results.hpp"
#include "lab/base/toml_reader.hpp"
#include "lab/grains/grain_files.hpp"
#include "lab/grains/grain_packing.hpp"
#include "lab/grains/grain_programme_reader.hpp"
#include "lab/intake/cells/clock_format.hpp"
#include "lab/intake/text/encoding.hpp"
#include "lab/intake/text/structure.hpp"
#include "lab/paths/path_reader.hpp"
#include "lab/programmes/programme_reader.hpp"
#include "lab/records/dialect.hpp"
#include "lab/rig/recorded.hpp"
#include "lab/wire/modbus/frames.hpp"
#include "lab/wire/modbus/pdu.hpp"
#include "tests/fuzz/archive_around.hpp"

using namespace triax::lab;

namespace {
std::vector<std::string> seeds(const std::string& fuzzer) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator("tests/fuzz/seeds/" + fuzzer))
    if (entry.is_regular_file()) paths.push_back(entry.path().string());  // not what was kept
  return paths;
}
}  // namespace

TEST_CASE("the fuzzers' seeds are accepted") {
  for (const auto& path : seeds("programme_fuzz")) CHECK_NOTHROW(load_programme(path));
  for (const auto& path : seeds("path_fuzz")) CHECK_NOTHROW(check_start(load_path(path)));
  for (const auto& path : seeds("grain_state_fuzz")) CHECK_NOTHROW(load_state(path));
  for (const auto& path : seeds("grain_programme_fuzz"))
    if (path.ends_with(".toml"))
      CHECK_NOTHROW(load_grain_programme(path));
    else
      CHECK_NOTHROW(load_packing(path, 2));
  for (const auto& path : seeds("dialect_fuzz"))
    CHECK_NOTHROW(parse_dialect(read_text_file(path), path));
  for (const auto& path : seeds("ags_fuzz"))
    CHECK_FALSE(read_triaxial_results(*open_file(path)).results.empty());
  for (const auto& path : seeds("clock_fuzz")) {
    INFO(path);
    std::istringstream lines(read_text_file(path));
    std::string first;
    std::getline(lines, first);
    const std::vector<std::string_view> cells{first};
    CHECK(find_clock_format(cells, ClockHeading::date).format);
  }
  for (const auto& path : seeds("modbus_fuzz")) {
    INFO(path);
    const auto frame = read_text_file(path).substr(1);
    const bool tcp = path.find("_tcp_") != std::string::npos,
               asked = path.find("asked_") != std::string::npos;
    const auto pdu = tcp ? frame.substr(kTcpHeader) : frame.substr(1, frame.size() - kRtuAround);
    if (!tcp) CHECK(crc_holds(frame));
    if (!path.ends_with("unknown"))
      CHECK((asked ? request_length(pdu) : answer_length(pdu)) == pdu.size());
  }
  for (const auto& path : seeds("workbook_fuzz")) {
    INFO(path);
    const auto rig =
        open_record(open_memory("seed.xlsx", test::archive_around(read_text_file(path))), {});
    Reading reading;
    while (rig->next(reading)) CHECK(reading.number >= 0);
  }
  for (const auto& path : seeds("structure_fuzz"))
    CHECK(find_structure(read_sample(*open_utf8(open_file(path)))).structure);
  std::vector<std::string> dialects;
  for (const auto& path : seeds("record_fuzz")) {
    INFO(path);
    const auto rig = open_record(path, {});
    dialects.push_back(rig->header().dialect);
    Reading reading;
    while (rig->next(reading)) CHECK(reading.number >= 0);
  }
  for (const Dialect& shipped : shipped_dialects())
    CHECK(std::ranges::count(dialects, shipped.name) >= 1);
}
