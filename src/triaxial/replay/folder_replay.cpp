// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay/folder_replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <span>
#include <system_error>
#include <utility>

#include "db/catalogue.hpp"
#include "lab/base/digest.hpp"
#include "lab/base/text.hpp"
#include "lab/records/cells/number_rows.hpp"
#include "src/output/table.hpp"
#include "src/output/terminal.hpp"
#include "src/triaxial/facts/verdict_fact.hpp"

namespace triax::src {
namespace {

namespace fs = std::filesystem;

/// "t.db", "t.db-wal", "t.db.spool-12": of a database.
bool belongs_to_database(const std::string& name) {
  const auto at = name.find(".db");
  if (at == std::string::npos) return false;
  const std::string behind = name.substr(at + 3);
  return behind.empty() || behind.front() == '-' || behind.front() == '.';
}

bool may_be_record(const std::string& name) {
  return !name.starts_with('.') && !name.ends_with('~') && !name.ends_with(".toml") &&
         !belongs_to_database(name);
}

/// The beginning of a file.
class FirstBytes : public lab::ByteSource {
 public:
  FirstBytes(std::unique_ptr<lab::ByteSource> whole, std::uint64_t size)
      : whole_(std::move(whole)), size_(size) {}
  const std::string& name() const override { return whole_->name(); }
  std::uint64_t size() const override { return size_; }
  std::size_t read(std::span<char> into) override {
    const auto count = whole_->read(into.first(std::min<std::uint64_t>(into.size(), size_ - at_)));
    at_ += count;
    return count;
  }
  void rewind() override {
    whole_->rewind();
    at_ = 0;
  }

 private:
  std::unique_ptr<lab::ByteSource> whole_;
  std::uint64_t size_, at_ = 0;
};

/// "line 3: message" for "FOLDER/NAME:3: message": the name is in the table.
std::string without_path(std::string message, const std::string& path) {
  if (!message.starts_with(path + ":")) return message;
  message.erase(0, path.size() + 1);
  const bool has_line = !message.starts_with(' ');
  return (has_line ? "line " : "") + std::string(lab::trimmed(message));
}

std::string kind_word(const FileOutcome& outcome) {
  switch (outcome.kind) {
    case FileOutcome::Kind::stored:
    case FileOutcome::Kind::references:
      return outcome.words;
    case FileOutcome::Kind::read_before:
      return "read before";
    case FileOutcome::Kind::no_record:
      return "no record";
    case FileOutcome::Kind::failed:
      return "failed";
    case FileOutcome::Kind::delayed:
      return "not stored";
  }
  return {};
}

/// "test 4"; "tests 4 to 6".
std::string numbers_of(const FileOutcome& outcome) {
  return outcome.test == outcome.last_test
             ? fmt::format("test {}", outcome.test)
             : fmt::format("tests {} to {}", outcome.test, outcome.last_test);
}

/// "flow"; of several tests "2 flow, 1 none".
std::string results_of(const std::vector<db::StoredTest>& tests) {
  std::map<std::string, int> counts;
  for (const db::StoredTest& test : tests)
    ++counts[verdict_word(test.status, test.summary.collapse.judged
                                           ? std::optional(test.summary.collapse.kind)
                                           : std::nullopt)];
  if (tests.size() == 1) return counts.begin()->first;
  std::vector<std::string> words;
  words.reserve(counts.size());
  for (const auto& [word, count] : counts) words.push_back(fmt::format("{} {}", count, word));
  return lab::joined(words);
}

}  // namespace

std::vector<std::string> files_of_folder(const std::string& folder) {
  std::vector<std::string> files;
  try {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      std::error_code vanished;
      if (entry.is_regular_file(vanished) && may_be_record(entry.path().filename().string()))
        files.push_back(entry.path().string());
    }
  } catch (const fs::filesystem_error& error) {
    throw lab::BadInput(folder, 0, "cannot be read: " + error.code().message());
  }
  std::ranges::sort(files);
  return files;
}

FolderReplay::FolderReplay(const ReplayRequest& request, std::string db)
    : request_(request), db_(std::move(db)) {}

/// The newest complete test with that digest; 0: none. `name` may be empty: any.
std::int64_t FolderReplay::stored_before(const std::string& digest, const std::string& name) const {
  if (!fs::exists(db_)) return 0;
  std::int64_t latest = 0;
  for (const db::ListedTest& test : db::list_tests(db_))
    if (test.digest == digest && test.status == db::TestStatus::complete &&
        (name.empty() || test.name == name))
      latest = test.id;
  return latest;
}

/// The untouched tests of the first part of this file.
std::vector<std::int64_t> FolderReplay::replaced_by(const std::string& path) const {
  const auto found = parts_.find(path);
  if (found == parts_.end()) return {};
  const Part& part = found->second;
  auto whole = lab::open_file(path);
  if (whole->size() <= part.bytes) return {};
  FirstBytes first(std::move(whole), part.bytes);
  if (lab::sha256(first) != part.digest) return {};
  std::vector<std::int64_t> untouched;
  for (const db::ListedTest& test : db::list_tests(db_))
    if (std::ranges::any_of(part.tests, [&](const db::StoredTest& one) {
          return test.id == one.id && test.digest == one.header.digest &&
                 test.name == one.header.name && test.tags.empty() && test.revision == 1;
        }))
      untouched.push_back(test.id);
  return untouched;
}

FolderReplay::TestOutcomes FolderReplay::read_tests(const std::string& path,
                                                    const std::string& digest,
                                                    const Interruption& interruption) {
  TestOutcomes out;
  const auto read = [&](const TestOfFile& test) {
    std::int64_t before = test.number == 0 ? stored_before(digest, "") : 0;
    if (before == 0) {
      const auto rig = open_to_replay(request_, path, test);
      // The tests of a DIGGS file have the digest of the file.
      const lab::RecordHeader& header = rig->header();
      if (test.number > 0)
        before = stored_before(header.digest, header.digest == digest ? header.name : "");
      if (before == 0) {
        tests_.push_back(replay_record(request_, path, *rig, db_, interruption, test));
        out.stored.push_back(db::Store(db_).load(tests_.back()));
        return;
      }
    }
    out.before.push_back(before);
  };
  study::read_tests(request_.tests_in(path), read, [&](const lab::BadInput& error) {
    out.faults.push_back(without_path(error.what(), path));
  });
  return out;
}

FileOutcome FolderReplay::outcome_of(const TestOutcomes& tests) {
  FileOutcome outcome;
  if (!tests.stored.empty()) {
    outcome.kind = FileOutcome::Kind::stored;
    outcome.test = tests.stored.front().id;
    outcome.last_test = tests.stored.back().id;
    outcome.words = results_of(tests.stored);
  } else if (!tests.before.empty()) {
    outcome.kind = FileOutcome::Kind::read_before;
    outcome.test = tests.before.front();
    outcome.last_test = tests.before.back();
    outcome.words = "read before, unchanged, as " + numbers_of(outcome);
  }
  if (tests.faults.empty()) return outcome;
  outcome.kind = FileOutcome::Kind::failed;
  outcome.words = fmt::format("{} of {} tests could not be read: {}", tests.faults.size(),
                              tests.faults.size() + tests.stored.size() + tests.before.size(),
                              tests.faults.front());
  return outcome;
}

FileOutcome FolderReplay::read_record(const std::string& path, const Interruption& interruption) {
  const auto bytes = lab::open_file(path)->size();
  if (request_.record.dialect.empty() && references_.take(path)) {
    references_.store(db_);
    return {.kind = FileOutcome::Kind::references,
            .words = fmt::format("{} reference results", references_.all().back().results.size())};
  }
  const std::string digest = lab::sha256(*lab::open_file(path));
  TestOutcomes tests = read_tests(path, digest, interruption);
  FileOutcome outcome = outcome_of(tests);
  if (tests.stored.empty()) return outcome;
  const auto replaced = replaced_by(path);
  // The length that was read: a logger may have gone on meanwhile.
  parts_[path] = {std::move(tests.stored), digest, bytes};
  if (replaced.empty()) return outcome;
  db::remove_tests(db_, replaced);
  std::erase_if(tests_, [&](std::int64_t test) {
    return std::ranges::find(replaced, test) != replaced.end();
  });
  outcome.words +=
      fmt::format("; replaces test {}, the first part of this file", fmt::join(replaced, ", "));
  return outcome;
}

FileOutcome FolderReplay::read(const std::string& path, const Interruption& interruption) {
  FileOutcome outcome;
  try {
    outcome = read_record(path, interruption);
  } catch (const lab::BadInput& error) {
    outcome.words = without_path(error.what(), path);
    try {
      if (lab::looks_like_readings(*lab::open_file(path))) outcome.kind = FileOutcome::Kind::failed;
    } catch (const std::exception&) {  // it vanished, or cannot be opened
      outcome.kind = fs::exists(path) ? FileOutcome::Kind::failed : FileOutcome::Kind::no_record;
    }
  } catch (const Stopped&) {
    throw;
  } catch (const lab::WorkFailed& error) {
    outcome.kind = FileOutcome::Kind::delayed;
    outcome.words = error.what();
  }
  outcome.file = fs::path(path).filename().string();
  return outcome;
}

std::string outcome_line(const FileOutcome& outcome) {
  const std::string name = on_one_line(outcome.file), words = on_one_line(outcome.words);
  switch (outcome.kind) {
    case FileOutcome::Kind::stored:
      return fmt::format("{}: {}, {}", name, numbers_of(outcome), words);
    case FileOutcome::Kind::references:
    case FileOutcome::Kind::read_before:
      return fmt::format("{}: {}", name, words);
    default:
      return fmt::format("{}: {}: {}", name, kind_word(outcome), words);
  }
}

std::string outcome_table(const std::vector<FileOutcome>& outcomes) {
  Table table{{{"File"}, {"Outcome"}, {"Test", Align::right}}, {}};
  for (const FileOutcome& outcome : outcomes)
    table.rows.push_back(
        {on_one_line(outcome.file), on_one_line(kind_word(outcome)),
         outcome.test == 0 ? "" : numbers_of(outcome).substr(numbers_of(outcome).find(' ') + 1)});
  const auto count = [&](FileOutcome::Kind kind) {
    return std::ranges::count(outcomes, kind, &FileOutcome::kind);
  };
  return to_text(table, text_width()) +
         fmt::format("\n{} files: {} stored, {} read before, {} failed, {} no records\n",
                     outcomes.size(),
                     count(FileOutcome::Kind::stored) + count(FileOutcome::Kind::references),
                     count(FileOutcome::Kind::read_before),
                     count(FileOutcome::Kind::failed) + count(FileOutcome::Kind::delayed),
                     count(FileOutcome::Kind::no_record));
}

}  // namespace triax::src
