// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/live/live_frames.hpp"

#include <fmt/format.h>

#include "db/scans/read_columns.hpp"
#include "src/study/row_json.hpp"
#include "src/study/triaxial/event_json.hpp"

namespace triax::src {
namespace {

using study::Json;

struct StreamEvent {
  const char* name;
  std::string data;
};

StreamEvent event_of(const LiveReading& reading) {
  std::string json = "{\"reading\":" + std::to_string(reading.reading.number);
  std::vector<double> row;
  db::fill_row(reading.reading, reading.state, row);
  for (std::size_t i = 0; i < row.size(); ++i) {
    json += ",\"" + db::read_columns()[i].name + "\":";
    study::append_number(row[i], json);
  }
  const auto told_us =
      std::chrono::duration_cast<std::chrono::microseconds>(reading.told.time_since_epoch());
  if (reading.unread) json += ",\"unread\":true";
  return {"reading", fmt::format("{},\"told_ms\":{:.3f}}}", json,
                                 1e-3 * static_cast<double>(told_us.count()))};
}

StreamEvent event_of(const lab::Event& event) {
  return {"event", study::json_line(study::event_json(event))};
}
StreamEvent event_of(const lab::Forecast& forecast) {
  return {"forecast", study::json_line(study::forecast_json(forecast))};
}

StreamEvent event_of(const lab::SensorFinding& finding) {
  return {"channels", study::json_line({{"channel", lab::heading(finding.channel)},
                                        {"state", to_string(finding.fault)},
                                        {"from", finding.from},
                                        {"until", finding.until ? Json(*finding.until) : Json()},
                                        {"detail", describe(finding)}})};
}

StreamEvent event_of(const lab::StageInfo& stage) {
  return {"stage", study::json_line(study::stage_json(stage))};
}

StreamEvent event_of(const LiveEnd& end) {
  return {"end",
          study::json_line({{"status", end.status}, {"error", study::json_text(end.error)}})};
}

}  // namespace

std::string live_frames(const LiveTaken& taken) {
  std::string frames;
  if (taken.missed)
    frames += fmt::format("event: window\ndata: {{\"from\":{},\"to\":{}}}\n\n", taken.missed->first,
                          taken.missed->second);
  for (const LiveItem& item : taken.items) {
    const StreamEvent one = std::visit([](const auto& what) { return event_of(what); }, item.what);
    frames +=
        fmt::format("id: {}\nevent: {}\ndata: {}\n\n", to_string(item.at), one.name, one.data);
  }
  if (taken.share)
    frames += fmt::format("event: progress\ndata: {{\"share\":{:.4f}}}\n\n", *taken.share);
  return frames;
}

}  // namespace triax::src
