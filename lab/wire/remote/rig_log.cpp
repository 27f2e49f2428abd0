// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/rig_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <map>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/base/whole_file.hpp"
#include "lab/records/metadata.hpp"
#include "lab/results/reading.hpp"
#include "lab/wire/remote/absences.hpp"
#include "lab/wire/remote/instrument_clocks.hpp"
#include "lab/wire/remote/wire_instruments.hpp"

namespace triax::lab {
namespace {

constexpr double kConnect_s = 10;

/// A file that grows by whole rows.
class GrowingFile {
 public:
  explicit GrowingFile(const std::string& path)
      : path_(path),
        descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND, 0666)) {
    if (descriptor_ < 0 && errno == EEXIST)
      throw BadInput(path, 0, "is there already: a log begins a file of its own");
    if (descriptor_ < 0) fail();
  }
  ~GrowingFile() { ::close(descriptor_); }
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  void write(const std::string& text) const {
    if (!write_all(descriptor_, text)) fail();
  }

 private:
  [[noreturn]] void fail() const {
    throw WorkFailed(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
  }
  std::string path_;
  int descriptor_;
};

/// A column of the file: where its value comes from and in which unit it stands there.
struct LogColumn {
  std::string heading;
  std::string channel;
  double factor = 1;  ///< from the channel's unit to the column's
};

std::vector<LogColumn> columns_of(const RigFile& rig) {
  std::vector<LogColumn> columns;
  for (const auto& row : raw_channels())
    if (const RigChannel* channel = rig.channel(row.quantity))
      columns.push_back({.heading = heading(row.quantity),
                         .channel = channel->name,
                         .factor = channel->scale / sim::find_unit(row.unit)->scale});
  for (const RigInstrument& one : rig.instruments)
    for (const RigChannel& channel : one.channels)
      if (!channel.quantity)
        columns.push_back(
            {.heading = channel.unit.empty() ? channel.name : channel.name + "_" + channel.unit,
             .channel = channel.name});
  return columns;
}

std::string head_of(const RigFile& rig, const WireInstruments& instruments,
                    const std::vector<LogColumn>& columns) {
  RecordHeader header;
  header.name = rig.name;
  header.origin = instruments.simulated() ? Origin::simulated : Origin::recorded;
  std::string text = as_comment(metadata_toml(header));
  for (const Note& note : instruments.identities())
    text += fmt::format("## {}: {}\n", note.label, note.text);
  text += "time_s,stage";
  for (const LogColumn& column : columns) text += "," + column.heading;
  return text + '\n';
}

}  // namespace

RigLogged log_rig(const RigFile& rig, const std::string& path, const RigLogOptions& o) {
  const std::vector<LogColumn> columns = columns_of(rig);
  if (columns.empty()) throw BadInput(rig.file, 0, "the rig has no channel that could be read");
  LineLoop loop;
  WireInstruments instruments(loop, rig, [](const auto&) { return std::vector<std::string>(); });
  const std::string missing = instruments.connect(kConnect_s, o.stop);
  if (std::ranges::none_of(instruments.all(), [](const auto& one) { return one->ready(); }))
    throw WorkFailed(fmt::format("{}: no instrument is there:{}", rig.file, missing));
  const GrowingFile file(path);
  file.write(head_of(rig, instruments, columns));
  RigLogged logged{.simulated = instruments.simulated()};
  Absences absences;
  InstrumentClocks clocks;
  const auto stopped = [&o] { return o.stop && o.stop(); };
  const double start_s = loop.now_s();
  for (std::int64_t due = 0; !stopped(); ++due) {
    const double due_s = static_cast<double>(due) * o.interval_s;
    if (o.for_s > 0 && due_s > o.for_s) break;
    if (o.readings > 0 && logged.readings >= o.readings) break;
    loop.run_until(stopped, start_s + due_s);
    if (stopped()) break;
    std::map<std::string, double> values;
    const double time_s = instruments.scan([&](const WireInstrument& one,
                                               const WireInstrument::Scan& scan) {
      absences.take(one, scan.why);
      if (scan.stamp_s)
        clocks.take(one.described().name, *scan.stamp_s, scan.sent_s, scan.answered_s);
      for (std::size_t i = 0; i < scan.channels.size(); ++i)
        values[one.described().channels[i].name] = scan.channels[i].value;
    }) - start_s;
    std::string row = fmt::format("{:.4f},1", time_s);
    for (const LogColumn& column : columns) {
      const double value = values[column.channel] * column.factor;
      logged.missing_cells += std::isnan(value) ? 1 : 0;
      row += std::isnan(value) ? "," : fmt::format(",{:.10g}", value);
    }
    file.write(row + '\n');
    ++logged.readings;
    const auto say = [&](const std::vector<std::string>& all) {
      for (const std::string& news : all)
        if (o.say) o.say(fmt::format("at {:.1f} s: {}", time_s, news));
    };
    say(clocks.news());
    say(absences.news(time_s));
    if (o.progressed) o.progressed(logged.readings, time_s);
    // Instants that went by while an answer was awaited are not made up for.
    const double now_s = loop.now_s() - start_s;
    due = std::max(due, static_cast<std::int64_t>(std::floor(now_s / o.interval_s)));
  }
  return logged;
}

}  // namespace triax::lab
