// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/api/routes.hpp"

#include <SQLiteCpp/Database.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <filesystem>
#include <future>

#include "db/catalogue.hpp"
#include "db/recording/recorder.hpp"
#include "lab/base/bad_input.hpp"
#include "src/study/json_parts.hpp"
#include "tests/db/fake_session.hpp"
#include "tests/db/temporary_folder.hpp"

using namespace triax;
using namespace triax::src;
using study::Json;

namespace {

/// A database of its own, asked as a browser asks.
struct Asked {
  triax::testing::TemporaryFolder folder;
  std::string db = folder.file("routes.db");
  PageLaboratory laboratory{db, ""};

  PageAnswer get(const std::string& target) {
    return answer(laboratory, {.post = false, .target = *parse_target(target)});
  }
  PageAnswer post(const std::string& target, const Json& body) {
    return answer(laboratory, {.post = true, .target = *parse_target(target), .body = body.dump()});
  }
  Json send(const std::string& target, const std::string& bytes) {
    PageRequest request{.post = true, .target = *parse_target(target)};
    request.upload = std::make_shared<Upload>(std::filesystem::path(db).parent_path().string());
    request.upload->write(bytes);
    return Json::parse(answer(laboratory, request).body);
  }
  Json json(const std::string& target) { return Json::parse(get(target).body); }
  unsigned refusal(const std::string& target, bool post = false) {
    try {
      post ? this->post(target, Json::object()) : get(target);
    } catch (const Refused& refused) {
      return refused.status();
    }
    return 0;
  }
};

std::string raw_record() {
  std::string record =
      "time_s,axial_displacement_mm,axial_force_kN,cell_pressure_kPa,pore_pressure_kPa,"
      "back_volume_mm3\n";
  for (int i = 0; i < 300; ++i)
    record += std::to_string(i) + ',' + std::to_string(i * 0.01) + ',' +
              std::to_string(i * 0.0005) + ",600," + std::to_string(500 + 0.1 * i) + ",0\n";
  return record;
}

}  // namespace

TEST_CASE("without a database there are no tests, and nothing is made") {
  Asked page;
  CHECK(page.json("/api/tests")["tests"].empty());
  CHECK(page.folder.is_empty());
}

TEST_CASE("list_of_tests: a database whose tables are not there yet has no tests") {
  Asked page;
  const SQLite::Database begun(page.db, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  CHECK(page.json("/api/tests")["tests"].empty());
}

TEST_CASE("a record that lacks the specimen is asked for exactly that, and then right") {
  Asked page;
  Json told = page.send("/api/records?name=raw.csv", raw_record());
  CHECK(told["test"].is_null());
  CHECK(told["error"].is_null());
  REQUIRE(told["missing"].size() == 2);
  CHECK(told["missing"][0]["key"] == "specimen.height_mm");
  CHECK(told["missing"][0]["unit"] == "mm");
  CHECK(told["missing"][1]["key"] == "specimen.diameter_mm");
  CHECK(page.folder.is_empty());
  told = page.send(
      "/api/records?name=raw.csv&set=specimen.height_mm%3D140&set=specimen.diameter_mm%3D70",
      raw_record());
  CHECK(told["test"] == 1);
  CHECK(told["missing"].empty());

  const Json all = page.json("/api/tests");
  REQUIRE(all["tests"].size() == 1);
  CHECK(all["tests"][0]["test"]["source"] == "raw.csv");
  CHECK(all["tests"][0]["specimen"]["height_mm"] == 140);
  CHECK(all["tests"][0]["warnings"].is_number());
  const Json test = page.json("/api/tests/1");
  CHECK(test["test"]["readings"] == 300);
  CHECK(test["stages"].size() == 1);
  CHECK(test["facts"].size() > 3);
  CHECK(test["live"]["running"] == false);
  const Json window = page.json("/api/tests/1/window?from=10&to=19&columns=q_kPa,time_s&work=1");
  CHECK(window["columns"]["reading"].size() == 10);
  CHECK(window["columns"]["time_s"][0] == 10);
  CHECK(window["columns"].size() == 3);
  const auto outlined = page.json("/api/tests/1/outline")["columns"]["q_kPa"].size();
  CHECK(outlined > 0);
  CHECK(outlined <= 100);
  const auto csv = page.get("/api/tests/1/export?format=csv");
  CHECK(csv.body.find("pore_pressure_kPa") != std::string::npos);
  CHECK(page.json("/api/tests/1/export?format=json")["test"]["id"] == 1);
}

TEST_CASE("import: proposal, chosen dialect, preview and replay of a table") {
  Asked page;
  std::string table = "Zeit;Dehnung;q;Druck\n;%;kPa;kPa\n";
  for (int i = 0; i < 60; ++i)
    table += std::to_string(10 * i) + ';' + std::to_string(0.1 * i) + ';' + std::to_string(2 * i) +
             ';' + std::to_string(200 + i) + '\n';
  CHECK(page.send("/api/records?name=a.csv", table)["test"].is_null());
  const Json proposal = page.send("/api/records/proposal?name=a.csv", table);
  REQUIRE(proposal["error"].is_null());
  CHECK(proposal["own"] == false);
  REQUIRE(proposal["tables"][0]["columns"].size() == 4);
  CHECK(proposal["tables"][0]["rows"][1][2] == "2");
  Json choices = {{"name", "a"}, {"separator", "semicolon"}};
  choices["columns"] = Json::array();
  int position = 0;
  for (const auto& [quantity, unit] : {std::pair{"time", "s"},
                                       {"axial_strain", "%"},
                                       {"deviator_stress", "kPa"},
                                       {"pore_pressure", "kPa"}})
    choices["columns"].push_back(
        {{"quantity", quantity}, {"position", ++position}, {"unit", unit}});
  choices["values"] = {{"cell_pressure", 500}};
  const Json written = Json::parse(page.post("/api/dialects", choices).body);
  CHECK(written["file"].is_null());
  std::string query = "?name=a.csv";
  for (const char c : "\n" + written["dialect"].get<std::string>())
    query += c == '\n' ? "&dialect=" : c == '%' ? "%25" : std::string(1, c);
  const Json preview = page.send("/api/records/preview" + query, table);
  REQUIRE(preview["error"].is_null());
  CHECK(preview["readings"] == 60);
  CHECK(preview["path"]["p_eff_kPa"][0].get<double>() == Approx(300));
  CHECK(preview["path"]["q_kPa"].back().get<double>() == Approx(118));
  CHECK(page.folder.is_empty());
  CHECK(page.send("/api/records" + query, table)["test"] == 1);

  choices["key"] = proposal["key"];
  const Json kept = Json::parse(page.post("/api/dialects", choices).body);
  CHECK(std::filesystem::exists(kept["file"].get<std::string>()));
  const Json again = page.send("/api/records?name=b.csv&set=test.cell_pressure_kPa%3D400",
                               table + "600;6;99;261\n");
  CHECK(again["test"] == 2);
  CHECK(again["recognised"]["dialect"] == "a");
  CHECK(page.send("/api/records?name=b.csv", table)["test"].is_null());  // values are not kept
}

TEST_CASE("import: choices that are no dialect are refused") {
  Asked page;
  const Json column = {{"quantity", "time"}, {"position", 1}};
  const auto refuses = [&](const Json& body) {
    try {
      page.post("/api/dialects", body);
      return false;
    } catch (const Refused& refused) {
      return refused.status() == 400;
    }
  };
  CHECK_FALSE(refuses({{"name", "x"}, {"columns", {column}}}));
  CHECK(refuses(Json::object()));
  CHECK(refuses({{"columns", 1}}));
  CHECK(refuses({{"columns", Json::array()}}));
  CHECK(refuses({{"columns", {1}}}));
  CHECK(refuses({{"columns", Json::array_t(300, column)}}));
  CHECK(refuses({{"columns", {column, column}}}));
  for (const char* quantity : {"nothing", "time = 1\n[test]\nx", ""})
    CHECK(refuses({{"columns", {{{"quantity", quantity}, {"position", 1}}}}}));
  for (const double position : {-1.0, 0.0, 1.5, 1e9})
    CHECK(refuses({{"columns", {{{"quantity", "time"}, {"position", position}}}}}));
  for (const char* key : {"../../../tmp/x", "a", "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"})
    CHECK(refuses({{"columns", {column}}, {"key", key}}));
  CHECK(refuses({{"columns", {column}}, {"values", {{"time", 1}}}}));
  CHECK(refuses({{"columns", {column}}, {"values", {{"x = 1\ny", 1}}}}));
  CHECK(refuses({{"columns", {column}}, {"separator", "nothing"}}));
  CHECK(page.folder.is_empty());
}

TEST_CASE("export_of: a download without room in memory is refused") {
  Asked page;
  page.send("/api/records?name=one.csv&set=specimen.height_mm%3D140&set=specimen.diameter_mm%3D70",
            raw_record());
  const std::string csv = "/api/tests/1/export?format=csv";
  {
    const auto others = page.laboratory.budget.take(page.laboratory.budget.most());
    CHECK(page.refusal(csv) == 503);
  }
  const auto sent = page.get(csv);
  CHECK(page.laboratory.budget.taken() >= sent.body.size());
}

TEST_CASE("probe: the directions of all states are limited") {
  Asked page;
  Json probe = {{"material", "inl2/S28-general"}, {"void_ratio", 1.086}, {"p_kPa", 70}};
  probe["eta"] = std::vector<double>(11, 0.5);
  probe["step_deg"] = 0.1;
  CHECK_THROWS_AS(page.post("/api/probe", probe), Refused);
  probe["step_deg"] = 1;
  CHECK(page.post("/api/probe", probe).status == 200);
}

TEST_CASE("what was kept of a test does not outlive it") {
  Asked page;
  const std::string set = "&set=specimen.height_mm%3D140&set=specimen.diameter_mm%3D70";
  page.send("/api/records?name=one.csv" + set, raw_record());
  CHECK(page.json("/api/tests")["tests"][0]["test"]["name"] == "one");
  db::rename_test(page.db, 1, "renamed");
  db::tag_test(page.db, 1, {"loose"});
  const Json after = page.json("/api/tests")["tests"][0]["test"];
  CHECK(after["name"] == "renamed");
  CHECK(after["tags"] == Json::array({"loose"}));
}

TEST_CASE("a test that was looked at while it ran is whole when it is over") {
  Asked page;
  db::Recorder recorder(page.db);
  std::promise<std::int64_t> entered;
  recorder.when_entered([&entered](std::int64_t id) { entered.set_value(id); });
  const auto listener = recorder.listener();
  listener.started(triax::testing::raw_header("looked at"));
  triax::testing::send_scans(listener, 0, 12000);  // more than a batch: a part is there
  REQUIRE(entered.get_future().get() == 1);
  const std::string window = "/api/tests/1/window?columns=q_kPa&work=1";
  CHECK(page.json("/api/tests")["running"] == Json::array({1}));
  CHECK(page.json(window)["columns"]["reading"].size() > 0);
  page.get("/api/tests/1/outline");
  triax::testing::send_scans(listener, 12000, 500);
  CHECK(recorder.finish({}) == 1);
  CHECK(page.json(window)["columns"]["reading"].back() == 12499);
  CHECK(page.json(window)["last"] == 12499);
  CHECK(page.json("/api/tests/1/outline")["columns"]["reading"].back() == 12499);
}

TEST_CASE("no domain is computed for a program that ends") {
  Asked page;
  page.laboratory.ending = true;
  // Looked at now and then: one that is done before that is given.
  CHECK_THROWS_AS(page.post("/api/domain", {{"material", "inl2/S28-general"},
                                            {"void_ratio", 1.086},
                                            {"columns", 200},
                                            {"rows", 200},
                                            {"directions", 720}}),
                  lab::WorkFailed);
}

TEST_CASE("queue_of: orders, uploads and computing do not wait for each other") {
  const auto queue = [](const char* target, bool post) {
    return queue_of({.post = post, .target = *parse_target(target)});
  };
  for (const char* order : {"/api/runs/1/hold", "/api/runs/1/resume", "/api/runs/1/stop"}) {
    CHECK(queue(order, true) == WorkQueue::orders);
    CHECK(queue(order, false) == WorkQueue::light);
  }
  for (const char* heavy : {"/api/runs", "/api/probe", "/api/domain"})
    CHECK(queue(heavy, true) == WorkQueue::heavy);
  for (const char* heavy : {"/api/tests/1/export?format=csv", "/api/tests/1/sheet"})
    CHECK(queue(heavy, false) == WorkQueue::heavy);
  for (const char* drawing : {"/api/tests/1/window", "/api/tests/1/outline"})
    CHECK(queue(drawing, false) == WorkQueue::drawing);
  CHECK(queue("/api/records?name=x", true) == WorkQueue::records);
  for (const char* light : {"/", "/api/tests", "/api/tests/1", "/api/materials", "/nothing"})
    CHECK(queue(light, false) == WorkQueue::light);
}

TEST_CASE("answer: work for a cancelled request ends") {
  Asked page;
  page.send("/api/records?name=one.csv&set=specimen.height_mm%3D140&set=specimen.diameter_mm%3D70",
            raw_record());
  const auto cancelled = std::make_shared<std::atomic<Cancelled>>(Cancelled::client_gone);
  const auto status = [&](const char* target, const Json& body) {
    try {
      answer(page.laboratory, {.post = !body.is_null(),
                               .target = *parse_target(target),
                               .body = body.dump(),
                               .cancelled = cancelled});
    } catch (const Refused& refused) {
      return refused.status();
    }
    return 0U;
  };
  const Json material = {{"material", "inl2/S28-general"}, {"void_ratio", 1.086}};
  Json probe = material, domain = material;
  probe.update({{"p_kPa", 70}, {"eta", {0.5, 0.6}}});
  domain.update({{"columns", 200}, {"rows", 200}, {"directions", 720}});
  CHECK(status("/api/probe", probe) == 503);
  CHECK(status("/api/domain", domain) == 503);
  CHECK(status("/api/tests/1/export?format=csv", nullptr) == 503);
}

TEST_CASE("what is not there, not so or not a number is refused in words") {
  Asked page;
  page.send("/api/records?name=one.csv&set=specimen.height_mm%3D140&set=specimen.diameter_mm%3D70",
            raw_record());
  for (const char* target : {"/api", "/api/tests/2", "/api/tests/0", "/api/tests/x",
                             "/api/tests/1/x", "/web/none.js", "/web", "/web/index.html/x", "/x"})
    CHECK(page.refusal(target) == 404);
  for (const char* target : {"/api/tests/1/window?columns=x", "/api/tests/1/window?pixels=0",
                             "/api/tests/1/window?from=1.5", "/api/tests/1/export?format=exe",
                             "/api/tests/1/live?after=x"})
    CHECK(page.refusal(target) == 400);
  CHECK(page.refusal("/api/runs") == 405);
  CHECK(page.refusal("/api/tests", true) == 405);
  CHECK(page.refusal("/api/runs", true) == 400);
  CHECK(page.refusal("/api/probe", true) == 400);
  CHECK(page.refusal("/api/runs/1/hold", true) == 400);
}

TEST_CASE("the page itself is inside the program") {
  Asked page;
  const auto index = page.get("/");
  CHECK(index.type == "text/html; charset=utf-8");
  CHECK(index.body.find("<!doctype html>") == 0);
  // Every file that it names is there.
  std::size_t at = 0;
  int named = 0;
  while ((at = index.body.find("\"/web/", at)) != std::string::npos) {
    const auto end = index.body.find('"', at + 1);
    CHECK(page.get(index.body.substr(at + 1, end - at - 1)).status == 200);
    at = end;
    ++named;
  }
  CHECK(named >= 2);
}

TEST_CASE("studies answer what the commands print, and name what is wrong") {
  Asked page;
  const Json probe = Json::parse(page.post("/api/probe", {{"material", "inl2/S28-general"},
                                                          {"void_ratio", 1.086},
                                                          {"p_kPa", 70},
                                                          {"eta", 0.6}})
                                     .body);
  CHECK(probe["material"]["name"] == "inl2/S28-general");
  const Json domain = Json::parse(page.post("/api/domain", {{"material", "inl2/S28-general"},
                                                            {"void_ratio", 1.086},
                                                            {"columns", 5},
                                                            {"rows", 6},
                                                            {"directions", 36}})
                                      .body);
  CHECK(domain["grid"]["columns"] == 5);
  CHECK(domain["states"].size() == 30);
  CHECK_THROWS_AS(page.post("/api/probe", {{"material", "none"}, {"p_kPa", 70}, {"eta", 0.6}}),
                  lab::BadInput);
  CHECK_THROWS_AS(
      page.post("/api/domain",
                {{"material", "inl2/S28-general"}, {"void_ratio", 1.086}, {"columns", 100000}}),
      Refused);
}
