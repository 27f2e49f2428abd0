// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/tests.hpp"

#include <fmt/format.h>

#include <CLI/Validators.hpp>
#include <algorithm>
#include <array>
#include <memory>

#include "db/catalogue.hpp"
#include "db/recording/repair.hpp"
#include "db/recording/silent_writers.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "src/cli/shared_options.hpp"
#include "src/output/notice.hpp"
#include "src/output/output.hpp"
#include "src/output/progress_bar.hpp"
#include "src/output/table.hpp"
#include "src/output/words.hpp"
#include "src/study/correction/correct_test.hpp"
#include "src/triaxial/facts/verdict_fact.hpp"
#include "src/triaxial/json_report.hpp"
#include "src/triaxial/left_waiting.hpp"
#include "src/triaxial/test_list.hpp"
#include "src/triaxial/text_report.hpp"

namespace triax::src {
namespace {

struct TestsOptions {
  std::string action = "list";
  std::vector<std::string> words;
  std::string tag;
  std::string db = "triax.db";
  bool json = false;
};

/// A name could be that of a test with another number: what changes a test asks for its number.
std::int64_t id_of(const std::string& word) {
  if (const auto id = lab::whole_text_as<std::int64_t>(word)) return *id;
  throw lab::BadInput(fmt::format("{} is not the number of a test; `triax tests` lists all tests",
                                  lab::excerpt(word)));
}

std::vector<db::ListedTest> only(const TestsOptions& o, std::int64_t id) {
  auto tests = db::list_tests(o.db);
  std::erase_if(tests, [id](const db::ListedTest& test) { return test.id != id; });
  return tests;
}

/// What one test is after a change: in words, or as the list has it.
void print_changed(const TestsOptions& o, std::int64_t id, const std::string& sentence) {
  print(o.json ? test_list_json(only(o, id)) : without_controls(sentence));
}

std::vector<std::string> behind_the_first(const std::vector<std::string>& words) {
  return {words.begin() + 1, words.end()};
}

void run_list(const TestsOptions& o) {
  const auto tests = db::list_tests(o.db, o.tag);
  if (o.json) return print(test_list_json(tests));
  if (!tests.empty()) return print(test_list_text(tests));
  print(o.tag.empty() ? std::string("The database holds no test.\n")
                      : fmt::format("No test has the tag {}.\n", lab::excerpt(o.tag)));
}

void run_show(const TestsOptions& o) {
  db::StoredTest test = db::Store(o.db).load(id_of(o.words.front()));
  if (o.json) return print(json_in_short(test));
  test.header.name = on_one_line(std::move(test.header.name));
  print(without_controls(text_of(brief_content(test))));
}

void run_rename(const TestsOptions& o) {
  const std::int64_t id = id_of(o.words[0]);
  const std::string before = db::rename_test(o.db, id, o.words[1]);
  print_changed(o, id,
                fmt::format("test {} {} is now called {}\n", id, lab::excerpt(before),
                            lab::excerpt(lab::trimmed(o.words[1]))));
}

std::string in_words(const db::RevisedValue& value) {
  const auto shown = [](const std::string& text) {
    return text.empty() ? std::string("unknown") : text;
  };
  return fmt::format("  {}: {} -> {}\n", value.key, shown(value.before), shown(value.after));
}

void run_set(const TestsOptions& o) {
  const std::int64_t id = id_of(o.words.front());
  const auto values = key_values(behind_the_first(o.words), "specimen.height_mm=140");
  ProgressBar bar(fmt::format("test {}", id));
  const auto corrected =
      study::correct_test(o.db, id, values, [&bar](double fraction) { bar.show(fraction); });
  std::string sentences;
  for (const auto& test : only(o, id)) {
    if (corrected.revision == 0)
      sentences =
          fmt::format("{} has these values already; nothing was changed\n", test_in_words(test));
    else
      sentences = fmt::format("{} is now revision {}: {}\n", test_in_words(test),
                              corrected.revision, verdict_word(test.status, test.kind));
  }
  for (const auto& value : corrected.values) sentences += in_words(value);
  print_changed(o, id, sentences);
}

void print_tags(const TestsOptions& o, std::int64_t id) {
  std::string sentences;
  for (const auto& test : only(o, id))
    sentences += fmt::format("tags of {}: {}\n", test_in_words(test),
                             test.tags.empty() ? "none" : lab::joined(test.tags));
  print_changed(o, id, sentences);
}

void run_tag(const TestsOptions& o) {
  const std::int64_t id = id_of(o.words.front());
  db::tag_test(o.db, id, behind_the_first(o.words));
  print_tags(o, id);
}

void run_untag(const TestsOptions& o) {
  const std::int64_t id = id_of(o.words.front());
  db::untag_test(o.db, id, behind_the_first(o.words));
  print_tags(o, id);
}

void run_remove(const TestsOptions& o) {
  std::vector<std::int64_t> ids;
  for (const auto& word : o.words) ids.push_back(id_of(word));
  const auto removed =
      db::remove_tests(o.db, ids, db::silent_writers({o.db}, {.say = notify, .tests = ids}));
  if (o.json) return print(test_list_json(removed));
  std::string sentences;
  for (const auto& test : removed)
    sentences += fmt::format("removed {}: {} readings\n", test_in_words(test), test.readings);
  print(sentences);
}

void run_repair(const TestsOptions& o) {
  const db::Repaired repaired = db::repair(o.db, {.say = notify});
  if (o.json) return print(test_list_json(repaired.tests));
  std::string sentences;
  for (const auto& test : repaired.tests)
    sentences += fmt::format("{}: {}, {} readings\n", test_in_words(test),
                             status_in_words(test.status, test.sign_of_life), test.readings);
  for (const auto& run : repaired.runs) sentences += fmt::format("grain {}: interrupted\n", run);
  print(sentences.empty() ? "Nothing to repair: all running tests have a heartbeat.\n" : sentences);
}

struct Action {
  std::string_view name;
  const char* takes;  ///< as typed
  std::size_t least, most;
  void (*run)(const TestsOptions&);
};

constexpr std::size_t kAny = 1000000;
constexpr auto kActions = std::to_array<Action>({
    {"list", "no ID; use --tag TAG to select tests", 0, 0, run_list},
    {"show", "ID, the number of one test", 1, 1, run_show},
    {"rename", "ID NAME; put a name of several words in quotes", 2, 2, run_rename},
    {"set", "ID KEY=VALUE..., the number of one test and the values to correct", 2, kAny, run_set},
    {"tag", "ID TAG..., the number of one test and its new tags", 2, kAny, run_tag},
    {"untag", "ID TAG..., the number of one test and the tags to remove", 2, kAny, run_untag},
    {"remove", "ID..., the numbers of one or more tests", 1, kAny, run_remove},
    {"repair", "no ID; it repairs all tests", 0, 0, run_repair},
});

std::vector<std::string> action_names() {
  std::vector<std::string> names(kActions.size());
  std::ranges::transform(kActions, names.begin(),
                         [](const Action& action) { return std::string(action.name); });
  return names;
}

void run_tests(const TestsOptions& o) {
  const Action& action = *std::ranges::find(kActions, o.action, &Action::name);
  if (o.words.size() < action.least || o.words.size() > action.most)
    throw lab::BadInput(fmt::format("tests {} takes {}", action.name, action.takes));
  if (!o.tag.empty() && o.action != "list")
    throw lab::BadInput(
        "--tag needs the action list; `triax tests tag ID TAG` adds a tag to a test");
  action.run(o);
  tell_of_gaps(o.db);
}

}  // namespace

Command tests_command() {
  return {
      .name = "tests",
      .purpose = "List, show, correct, rename, tag, remove or repair stored tests",
      .description =
          {"Without an action, the tests are listed: number, name, origin, type of test, "
           "assessment, number of readings, time of storage and tags. show ID prints a summary of "
           "one test: its file with the SHA-256 digest, tags, specimen, assessment and warnings.",
           "set ID KEY=VALUE... corrects values of a test, with the keys of replay --set: "
           "specimen.height_mm, stages.2.role, labels.borehole and others. The test is reduced and "
           "assessed again from its stored readings and gets a new revision under the same number. "
           "The readings do not change. KEY= sets a value back to that of revision 1. show lists "
           "all revisions with their dates and values.",
           "rename ID NAME renames a test. tag ID TAG... and untag ID TAG... add and remove tags, "
           "and --tag lists the tests with a tag. remove ID... deletes tests with all of their "
           "readings, without asking for confirmation, either all of them or none. A test that is "
           "still being recorded is not removed.",
           "A test that is being recorded has a heartbeat every two seconds. After 20 s without a "
           "heartbeat the list shows it as interrupted, but the database does not change. repair "
           "marks tests and grain runs as interrupted if their program has no heartbeat, imports "
           "readings from "
           "spool files beside the database, and migrates an older database to the current schema. "
           "repair and remove wait up to 6 s for a heartbeat and do not depend on the clock. A "
           "program that was only delayed resumes its test.",
           "Tests are identified by their number here, because several can have the same name. A "
           "file that is replayed again is stored as a new test, with a warning. Statistics (query "
           "collapse_points, instability_line, figures of several tests) count it once, with its "
           "latest complete replay."},
      .diagnostics = {{"FILE: test N does not exist; ...",
                       "list the numbers with triax tests; nothing was changed"},
                      {"... is still being recorded; ...",
                       "stop the program that records it, or wait; nothing was changed"},
                      {"test N was stored by an older triax, and its stored readings do not give "
                       "its stored result; ...",
                       "replay the file of this test with --set"}},
      .examples = {{"triax tests", "list all tests, one per line"},
                   {"triax tests --tag loose --json", "list the tests with a tag, for a script"},
                   {"triax tests set 3 specimen.height_mm=140.2 labels.borehole=B3",
                    "correct values of test 3 and assess it again"},
                   {"triax tests rename 3 \"CSU 26\"", "rename test 3"},
                   {"triax tests tag 3 loose thesis", "add two tags to test 3"},
                   {"triax tests remove 1 2", "delete two tests from the database"},
                   {"triax tests repair", "mark tests whose program was killed"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<TestsOptions>();
        const auto actions = action_names();
        app.add_option("ACTION", o->action, "action [list]")
            ->check(CLI::IsMember(actions).description(""))
            ->type_name(lab::joined(actions, "|"));
        app.add_option("ID", o->words,
                       "number of the test (remove: one or more; rename: ID NAME; set: ID "
                       "KEY=VALUE...; tag, untag: ID TAG...)")
            ->type_name("");
        app.add_option("--tag", o->tag, "list only tests with this tag")->type_name("TAG");
        add_db(app, o->db);
        add_json(app, o->json);
        return [o] { run_tests(*o); };
      }};
}

}  // namespace triax::src
