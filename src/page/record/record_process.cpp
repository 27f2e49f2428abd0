// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/record/record_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <malloc.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "db/recording/spool.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/base/whole_file.hpp"
#include "sim/materials/process_confinement.hpp"
#include "src/page/http/gate.hpp"
#include "src/page/request/request.hpp"

namespace triax::src {
namespace {

namespace fs = std::filesystem;

/// Descriptors of the process, which has no others but the standard streams.
enum : int { kUploadDescriptor = STDERR_FILENO + 1, kLifelineDescriptor, kResultDescriptor };

/// Address space: batches of readings, a head of 4 MB, shared texts of a workbook and stacks of
/// threads take a quarter of it.
constexpr std::size_t kRecordMemory_bytes = std::size_t{1} << 30;
/// A database takes about six bytes for each byte of a record, packed or not.
constexpr std::uint64_t kDatabaseBytesPerRecordByte = 32;
constexpr std::uint64_t kMinDatabaseGrowth_bytes = std::uint64_t{1} << 30;
constexpr std::size_t kMaxResult_bytes = std::size_t{16} << 20;

std::string system_error(const char* what) {
  return fmt::format("the process that reads the record cannot be started ({}): {}", what,
                     strerrordesc_np(errno));
}

/// Closes it at the end.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }
  /// Takes another one in its place.
  void set(int number) {
    close();
    number_ = number;
  }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

struct Pipe {
  Descriptor read, write;
  /// `read_flags` are those of the end that is read. A process writes more than a pipe holds, and
  /// waits until it is read.
  explicit Pipe(int read_flags) {
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw lab::WorkFailed(system_error("pipe"));
    read.set(ends[0]);
    write.set(ends[1]);
    if (::fcntl(read.number(), F_SETFL, read_flags) != 0)
      throw lab::WorkFailed(system_error("fcntl"));
  }
};

/// The same file under a number above those that the process is given, none of which may be
/// overwritten before it is copied.
int above_given(int descriptor) {
  const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, kResultDescriptor + 1);
  if (copy < 0) throw lab::WorkFailed(system_error("fcntl"));
  return copy;
}

/// Starts this program with the arguments, the three descriptors and no others, as the leader of a
/// process group, with default signals.
pid_t start_process(std::vector<std::string> arguments, int upload, int lifeline, int result) {
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  const Descriptor from_upload(above_given(upload)), from_lifeline(above_given(lifeline)),
      from_result(above_given(result));
  posix_spawn_file_actions_t files{};
  posix_spawn_file_actions_init(&files);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO})
    posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_RDWR, 0);
  posix_spawn_file_actions_adddup2(&files, from_upload.number(), kUploadDescriptor);
  posix_spawn_file_actions_adddup2(&files, from_lifeline.number(), kLifelineDescriptor);
  posix_spawn_file_actions_adddup2(&files, from_result.number(), kResultDescriptor);
  posix_spawn_file_actions_addclosefrom_np(&files, kResultDescriptor + 1);
  posix_spawnattr_t attributes{};
  posix_spawnattr_init(&attributes);
  sigset_t all, none;
  sigfillset(&all);
  sigemptyset(&none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  pid_t process = 0;
  errno = ::posix_spawn(&process, "/proc/self/exe", &files, &attributes, argv.data(), environ);
  const std::string failure = errno == 0 ? "" : system_error("posix_spawn");
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (!failure.empty()) throw lab::WorkFailed(failure);
  return process;
}

/// The process, killed and reaped at the latest with this object.
class RecordProcess {
 public:
  RecordProcess(std::vector<std::string> arguments, const Upload& upload)
      : process_(start_process(std::move(arguments), upload.descriptor(), lifeline_.read.number(),
                               result_.write.number())) {
    lifeline_.read.close();
    result_.write.close();
  }
  ~RecordProcess() { end(); }
  RecordProcess(const RecordProcess&) = delete;
  RecordProcess& operator=(const RecordProcess&) = delete;

  /// Its result, so far as it came until it ended or `stop` returned true.
  std::string result(const std::function<bool()>& stop) const {
    constexpr int kPoll_ms = 100;
    std::string text;
    std::vector<char> part(std::size_t{64} << 10);
    while (!stop() && text.size() < kMaxResult_bytes) {
      pollfd ready{result_.read.number(), POLLIN, 0};
      if (::poll(&ready, 1, kPoll_ms) <= 0) continue;
      const ssize_t count = ::read(ready.fd, part.data(), part.size());
      if (count == 0) break;
      if (count > 0) text.append(part.data(), static_cast<std::size_t>(count));
    }
    return text;
  }
  /// Kills it if it still runs; its status as waitpid() gives it.
  int end() {
    if (process_ == 0) return status_;
    ::kill(-process_, SIGKILL);
    while (::waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
    }
    process_ = 0;
    return status_;
  }

 private:
  Pipe lifeline_{0}, result_{O_NONBLOCK};
  pid_t process_ = 0;
  int status_ = 0;
};

/// Of a whole result, "ok LENGTH\n" or "failed LENGTH\n" and a text of that length.
struct Result {
  bool ok = false;
  std::string text;
};

std::string line_of(const Result& result) {
  return fmt::format("{} {}\n{}", result.ok ? "ok" : "failed", result.text.size(), result.text);
}

/// Empty if a part is missing.
std::optional<Result> parse_result(const std::string& line) {
  const auto blank = line.find(' '), end = line.find('\n');
  if (blank == std::string::npos || end == std::string::npos || end < blank) return std::nullopt;
  Result result{line.substr(0, blank) == "ok", line.substr(end + 1)};
  if (line_of(result) != line) return std::nullopt;
  return result;
}

[[noreturn]] void throw_for_end(int status) {
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU || signal == SIGKILL)
    throw Refused(413,
                  "the record needs too much time or memory to be read here; use `triax replay`, "
                  "which has no limit");
  if (signal == SIGXFSZ)
    throw Refused(413,
                  "the record would make the database too large for the web interface; use `triax "
                  "replay`, which has no limit");
  throw lab::WorkFailed("the process that read the record ended without a result" +
                        (signal == 0 ? std::string() : fmt::format(" (signal {})", signal)));
}

std::uint64_t max_file_bytes(const RecordToRead& record, const Upload& upload) {
  std::error_code none;
  const auto now = fs::exists(record.db, none) ? fs::file_size(record.db, none) : 0;
  return now + kMinDatabaseGrowth_bytes + kDatabaseBytesPerRecordByte * upload.size();
}

std::vector<std::string> arguments_for(const RecordToRead& record, const Upload& upload,
                                       std::uint64_t cpu_s) {
  std::vector<std::string> arguments = {"triax",
                                        kReadRecordCommand,
                                        record.db,
                                        record.name,
                                        record.writer,
                                        std::to_string(max_file_bytes(record, upload)),
                                        std::to_string(cpu_s),
                                        std::string(name_of(record.task)),
                                        record.dialect,
                                        record.sheet};
  for (const auto& [key, value] : record.sets) arguments.insert(arguments.end(), {key, value});
  return arguments;
}

Result result_of(const RecordToRead& record, const Upload& upload) {
  try {
    return {true, read_record(record, upload)};
  } catch (const std::bad_alloc&) {
    return {false,
            fmt::format("the record needs more than {} MB of memory", kRecordMemory_bytes >> 20)};
  } catch (const std::exception& error) {
    return {false, error.what()};
  }
}

}  // namespace

std::string read_record_apart(RecordToRead record, const Upload& upload, std::uint64_t cpu_s,
                              const std::function<bool()>& stop) {
  record.writer = random_word();
  const bool was_there = fs::exists(record.db);
  RecordProcess process(arguments_for(record, upload, cpu_s), upload);
  const std::string text = process.result(stop);
  const int status = process.end();
  const auto result = parse_result(text);
  if (result && result->ok) return result->text;
  if (record.task == RecordTask::replay) db::discard_left_test(record.db, record.writer, was_there);
  if (result) throw lab::WorkFailed(result->text);
  if (stop()) throw Refused(503, "reading the record was stopped; nothing is stored");
  throw_for_end(status);
}

[[noreturn]] void run_record_process(const std::vector<std::string>& arguments) {
  constexpr std::size_t kNamed = 8;
  const auto number = [&](std::size_t i) {
    return lab::whole_text_as<std::uint64_t>(arguments[i]).value_or(0);
  };
  if (arguments.size() < kNamed || arguments.size() % 2 != kNamed % 2) ::_exit(2);
  RecordToRead record{arguments[0], arguments[1], {}, arguments[2]};
  record.task = find_record_task(arguments[5]).value_or(RecordTask::replay);
  record.dialect = arguments[6];
  record.sheet = arguments[7];
  for (std::size_t i = kNamed; i < arguments.size(); i += 2)
    record.sets.emplace_back(arguments[i], arguments[i + 1]);
  ::signal(SIGXFSZ, SIG_DFL);     // main() ignores it
  if (::nice(10) < 0) errno = 0;  // the page and the tests that run come first
  ::mallopt(M_ARENA_MAX, 2);      // each reserves 64 MB of address space
  sim::confine_process(
      kLifelineDescriptor,
      {.memory_bytes = kRecordMemory_bytes, .file_bytes = number(3), .cpu_s = number(4)});
  const Upload upload(kUploadDescriptor);
  const bool written = lab::write_all(kResultDescriptor, line_of(result_of(record, upload)));
  ::_exit(written ? 0 : 1);  // what exit() would run (a leak check) the confinement does not allow
}

}  // namespace triax::src
