// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What one browser, and all of them together, may take of this program.
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace triax::src {

struct PageLimits {
  std::uint32_t header_bytes = 16 * 1024;
  std::uint64_t json_bytes = std::uint64_t{1} << 20;
  std::uint64_t record_bytes = std::uint64_t{512} << 20;
  std::size_t connections = 256;
  std::size_t waiting_answers = 64;  ///< of a queue of work, running and waiting
  std::size_t records = 4;           ///< uploads that arrive or are read

  std::chrono::milliseconds header_time{10'000};     ///< for all of a head
  std::chrono::milliseconds idle{60'000};            ///< until the next request has its head
  std::chrono::milliseconds json_time{20'000};       ///< for all of a JSON body
  std::chrono::milliseconds record_quiet{20'000};    ///< between two parts of a record
  std::chrono::milliseconds record_time{1'800'000};  ///< for all of a record
  std::chrono::milliseconds answer_time{300'000};    ///< to compute an answer
  /// To read a record: so much, and as much for each MB of it. A logger's file takes about 0.02 s
  /// for each MB on one core.
  std::chrono::milliseconds record_read_time{30'000}, record_read_time_per_MB{1'000};
  std::chrono::milliseconds write_time{30'000};  ///< for all of an answer, or a part of a stream
  std::chrono::milliseconds heartbeat{15'000};   ///< of a stream

  std::chrono::milliseconds time_to_read(std::uint64_t bytes) const {
    return record_read_time + static_cast<std::int64_t>(bytes >> 20) * record_read_time_per_MB;
  }
};

}  // namespace triax::src
