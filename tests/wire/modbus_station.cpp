// SPDX-License-Identifier: GPL-3.0-or-later
// What foreign clients and servers are held against.
//     modbus_station serve LINK...          a pressure/volume controller of unit 3 and one of unit
//     4 at each link modbus_station ask PERSONALITY LINK [POINT=VALUE]... [POINT...]
// "serve" prints each link as it is, then every value that is written, until its input ends. "ask"
// prints the identity, what it set and what it read.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <map>
#include <span>

#include "lab/base/text.hpp"
#include "lab/wire/asking/questions.hpp"
#include "lab/wire/line/line.hpp"
#include "lab/wire/line/wire_server.hpp"
#include "lab/wire/modbus/modbus_conversation.hpp"

using namespace triax::lab;

namespace {

/// Keeps what is written; what can only be read counts up from the unit's number.
WireDevice memory_device(const Personality& personality, int unit,
                         std::map<std::string, double>& values) {
  WireDevice device{.name = fmt::format("unit {}", unit),
                    .identity = fmt::format("{},{},1.0", personality.identity.begins, unit)};
  double next = unit;
  for (const auto& point : personality.points) {
    if (!point.writable) values[point.name] = next++;
    Point made{.name = point.name, .read = [&values, name = point.name] { return values[name]; }};
    if (point.writable)
      made.write = [&values, unit, name = point.name](double value) {
        if (value > 3000) throw Refused(Refused::Why::out_of_range, "more than 3000");
        values[name] = value;
        fmt::print("unit {}: {} = {}\n", unit, name, value);
        std::fflush(stdout);
      };
    device.points.push_back(std::move(made));
  }
  return device;
}

int serve(std::span<char*> links) {
  const auto personality = find_personality("triax-controller");
  const RegisterMap map(personality);
  std::map<std::string, double> third, fourth;
  const auto three = memory_device(personality, 3, third),
             four = memory_device(personality, 4, fourth);
  const std::vector<ModbusUnit> units{{3, &map, &three}, {4, &map, &four}};
  LineLoop loop;
  WireServer server(loop);
  for (const char* text : links) {
    const auto link = parse_link(text);
    const auto conversation = [&units, link]() -> std::unique_ptr<Conversation> {
      if (link.kind == LinkAddress::Kind::modbus_tcp)
        return std::make_unique<ModbusTcpConversation>(units);
      return std::make_unique<ModbusRtuConversation>(units, link.baud);
    };
    fmt::print("{}\n", to_text(server.listen(link, conversation)));
  }
  std::fflush(stdout);
  const auto input_ended = [] {
    char byte = 0;
    return read(STDIN_FILENO, &byte, 1) == 0;
  };
  // The input is looked at without waiting for it.
  while (true) {
    loop.run_for(0.05);
    fd_set set;
    FD_ZERO(&set);
    FD_SET(STDIN_FILENO, &set);
    timeval none{};
    if (select(1, &set, nullptr, nullptr, &none) > 0 && input_ended()) return 0;
  }
}

/// The answer, or the end of the program.
Asked answer(LineLoop& loop, Line& line, const Exchange& exchange, double deadline_s) {
  std::optional<Asked> came;
  line.ask(exchange, loop.now_s() + deadline_s, [&](const Asked& asked) { came = asked; });
  loop.run_until([&] { return came.has_value(); }, loop.now_s() + deadline_s + 1);
  if (came && came->kind == Asked::Kind::answered) return *came;
  fmt::print("no answer: {}\n", came ? came->why : "nothing came");
  std::exit(1);
}

int ask(const std::string& name, const std::string& text, std::span<char*> wishes) {
  const auto personality = find_personality(name);
  const auto link = parse_link(text);
  const auto questions = questions_for(personality, link);
  LineLoop loop;
  Line line(loop, link, {.pause_s = personality.pause_s});
  std::optional<std::string> opened;
  line.open(loop.now_s() + 2, [&](const std::string& why) { opened = why; });
  loop.run_until([&] { return opened.has_value(); }, loop.now_s() + 3);
  if (opened != "") return fmt::print("not open: {}\n", opened.value_or("")), 1;
  const auto asked = [&](const Exchange& exchange) {
    return answer(loop, line, exchange, personality.deadline_s);
  };
  std::vector<AskedValue> wanted;
  std::vector<PointSetting> settings;
  for (const std::string wish : wishes) {
    const auto equals = wish.find('=');
    const auto point = wish.substr(0, equals);
    if (equals == std::string::npos) {
      const auto at = whole_text_as<int>(point);
      wanted.push_back(at ? AskedValue{{}, at} : AskedValue{point, {}});
    } else {
      settings.push_back({point, whole_text_as<double>(wish.substr(equals + 1)).value()});
    }
  }
  for (const auto& exchange : questions->prepare(wanted)) asked(exchange);
  if (const auto identify = questions->identify())
    fmt::print("identity: {}\n", asked(*identify).text);
  for (const auto& exchange : questions->set(settings)) asked(exchange);
  for (const auto& question : questions->read(wanted)) {
    const auto values = asked(question.exchange).values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto& one = wanted[question.places[i]];
      fmt::print("{} = {}\n", one.at ? fmt::to_string(*one.at) : one.point, values[i]);
    }
  }
  return 0;
}

}  // namespace

int main(int count, char** words) {
  const std::span<char*> all(words, static_cast<std::size_t>(count));
  try {
    if (count > 2 && std::string_view(all[1]) == "serve") return serve(all.subspan(2));
    if (count > 3 && std::string_view(all[1]) == "ask") return ask(all[2], all[3], all.subspan(4));
  } catch (const std::exception& error) {
    fmt::print("{}\n", error.what());
    return 2;
  }
  return 2;
}
