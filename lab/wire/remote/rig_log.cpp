// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/remote/rig_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/base/whole_file.hpp"
#include "lab/records/metadata.hpp"
#include "lab/results/reading.hpp"
#include "lab/rig/missed_readings.hpp"
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
      throw BadInput(path, 0, "file exists already; give the name of a new file");
    if (descriptor_ < 0 && errno == ENOENT) check_folder_of(path);
    if (descriptor_ < 0) fail();
  }
  ~GrowingFile() { ::close(descriptor_); }
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  void write(const std::string& text) const {
    if (!write_all(descriptor_, text)) fail();
  }

 private:
  [[noreturn]] void fail() const { throw WorkFailed(describe_write_error(path_, errno)); }
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

class RigLogRun {
 public:
  RigLogRun(const RigFile& rig, const std::string& path, const RigLogOptions& options)
      : options_(options),
        columns_(columns_of(rig)),
        instruments_(loop_, rig, [](const auto&) { return std::vector<std::string>(); }) {
    if (columns_.empty()) throw BadInput(rig.file, 0, "the rig has no readable channel");
    const std::string missing = instruments_.connect(kConnect_s, options.stop);
    if (std::ranges::none_of(instruments_.all(), [](const auto& one) { return one->ready(); }))
      throw WorkFailed(fmt::format("{}: no instrument responded{}", rig.file, missing));
    file_.emplace(path);
    file_->write(head_of(rig, instruments_, columns_));
    logged_.simulated = instruments_.simulated();
    start_s_ = loop_.now_s();
  }

  RigLogged run();

 private:
  bool is_stopped() const { return options_.stop && options_.stop(); }
  double time_s() const { return loop_.now_s() - start_s_; }
  void write_row(double due_s);
  void report(double time_s, const std::vector<std::string>& sentences) const {
    for (const std::string& sentence : sentences)
      if (options_.say) options_.say(fmt::format("at {:.1f} s: {}", time_s, sentence));
  }

  const RigLogOptions& options_;
  std::vector<LogColumn> columns_;
  LineLoop loop_;
  WireInstruments instruments_;
  std::optional<GrowingFile> file_;
  RigLogged logged_;
  Absences absences_;
  InstrumentClocks clocks_;
  MissedReadings missed_;
  double start_s_ = 0;
};

/// Reads all channels now, as the row that was due at `due_s`.
void RigLogRun::write_row(double due_s) {
  std::map<std::string, double> values;
  const auto take = [&](const WireInstrument& one, const WireInstrument::Scan& scan) {
    absences_.take(one, scan.why);
    if (scan.stamp_s)
      clocks_.take(one.described().name, *scan.stamp_s, scan.sent_s, scan.answered_s);
    for (std::size_t i = 0; i < scan.channels.size(); ++i)
      values[one.described().channels[i].name] = scan.channels[i].value;
  };
  const double time_s = instruments_.scan(take) - start_s_;
  std::string row = fmt::format("{:.4f},1", time_s);
  for (const LogColumn& column : columns_) {
    const double value = values[column.channel] * column.factor;
    logged_.missing_cells += std::isnan(value) ? 1 : 0;
    row += std::isnan(value) ? "," : fmt::format(",{:.10g}", value);
  }
  file_->write(row + '\n');
  ++logged_.readings;
  if (const auto gap = missed_.add(due_s, time_s, options_.interval_s)) report(time_s, {*gap});
  report(time_s, clocks_.news());
  report(time_s, absences_.news(time_s));
  if (options_.progressed) options_.progressed(logged_.readings, time_s);
}

RigLogged RigLogRun::run() {
  const double interval_s = options_.interval_s;
  double due_s = 0;
  for (std::int64_t number = 0; !logged_.stopped;) {
    const double planned_s = static_cast<double>(number) * interval_s;
    if (options_.for_s > 0 && planned_s > options_.for_s) break;
    if (options_.readings > 0 && logged_.readings >= options_.readings) break;
    loop_.run_until([this] { return is_stopped(); }, start_s_ + planned_s);
    logged_.stopped = is_stopped();
    if (logged_.stopped) break;
    const double begun_s = time_s();
    write_row(due_s);
    // Instants that go by while an answer is awaited are not made up for.
    const auto next_after = [&](double t_s) {
      return static_cast<std::int64_t>(std::floor(t_s / interval_s)) + 1;
    };
    due_s = static_cast<double>(std::max(number + 1, next_after(begun_s))) * interval_s;
    number = std::max(number + 1, next_after(time_s()));
  }
  for (const auto& one : instruments_.all())
    if (const std::string& why = absences_.why(*one); !why.empty())
      logged_.silent.push_back(fmt::format("{}: {}", one->described().name, why));
  return logged_;
}

}  // namespace

RigLogged log_rig(const RigFile& rig, const std::string& path, const RigLogOptions& options) {
  return RigLogRun(rig, path, options).run();
}

}  // namespace triax::lab
