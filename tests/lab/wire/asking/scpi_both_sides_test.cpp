// SPDX-License-Identifier: GPL-3.0-or-later
// The questions of a personality against an instrument whose SCPI tree comes from the same file.
#include <catch2/catch.hpp>

#include "lab/wire/asking/questions.hpp"
#include "lab/wire/scpi/scpi_conversation.hpp"
#include "lab/wire/scpi/table.hpp"
#include "tests/lab/wire/modbus/tank.hpp"

using namespace triax::lab;
using Catch::Matchers::Contains;

TEST_CASE("what is asked and set by SCPI reaches a device made from the same personality",
          "[asking]") {
  for (const auto* name : {"triax-controller", "triax-frame"}) {
    INFO(name);
    const auto personality = find_personality(name);
    Tank tank(personality, 1000);
    std::vector<ScpiHeader> headers;
    for (const auto& point : personality.points)
      headers.push_back({point.name, point.scpi, point.readable, point.writable, point.help});
    const auto table = scpi_table_of(tank.device, headers);
    ScpiConversation conversation(table, tank.device);
    const auto answer = [&](const Exchange& exchange) {
      std::string reply;
      conversation.take(exchange.request, reply);
      CHECK(exchange.whole(reply) == (exchange.answered ? reply.size() : 0));
      return reply;
    };
    const auto questions = text_questions(personality);
    for (const auto& one : questions->prepare({})) CHECK(answer(one).empty());
    CHECK(personality.complaint_about(questions->identify()->text(answer(*questions->identify())))
              .empty());

    std::vector<PointSetting> settings;
    std::vector<AskedValue> asked;
    double next = 1;
    for (const auto& point : personality.points) {
      if (point.writable) settings.push_back({point.name, next});
      tank.values[point.name] = next++ / 4;
      asked.push_back({point.name, {}});
    }
    const auto read = [&] {
      const auto few = questions->read(asked);
      REQUIRE(few.size() == 1);
      return few[0].exchange.values(answer(few[0].exchange));
    };
    auto values = read();
    for (std::size_t i = 0; i < asked.size(); ++i) CHECK(values[i] == tank.values[asked[i].point]);

    const auto exchanges = questions->set({settings.rbegin(), settings.rend()});
    REQUIRE(exchanges.size() == 2);
    for (const auto& one : exchanges) CHECK(one.values(answer(one)).empty());
    REQUIRE(tank.written.size() == settings.size());
    for (std::size_t i = 0; i < settings.size(); ++i) {
      CHECK(tank.written[i].first == settings[i].point);
      CHECK(tank.written[i].second == settings[i].value);
    }

    // Refused before mode is sent.
    tank.written.clear();
    const auto refused = questions->set({{settings[1].point, 2000}, {"mode", 1}});
    CHECK_THROWS_WITH(refused[0].values(answer(refused[0])), Contains("it reports: -222"));
    CHECK(tank.written.empty());
    // Nothing of it is left for the next setting.
    const auto again = questions->set({{settings[1].point, 20}});
    CHECK(again[0].values(answer(again[0])).empty());
  }
}
