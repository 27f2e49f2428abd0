// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/page/open.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>

#include "lab/base/bad_input.hpp"
#include "lab/wire/rig_file.hpp"
#include "src/cli/interruption.hpp"
#include "src/cli/shared_options.hpp"
#include "src/output/notice.hpp"
#include "src/output/output.hpp"
#include "src/page/api/routes.hpp"
#include "src/page/http/server.hpp"
#include "src/page/record/record_process.hpp"

namespace triax::src {
namespace {

struct OpenOptions {
  std::string rig, db = "triax.db";
  std::vector<std::string> listen;
  unsigned short port = 0;
};

/// Ends the tests that run, and the work that browsers wait for, before the server goes.
struct OrderlyEnd {
  PageLaboratory& laboratory;
  ~OrderlyEnd() {
    laboratory.ending = true;
    laboratory.desk.close();
    laboratory.live.end();
  }
};

/// Lines that the user enters on standard input.
class EnteredLines {
 public:
  /// Whether something was entered since the last call. Does not wait.
  bool next() {
    // The system stops a process that reads a terminal in whose background it runs.
    if (is_at_end_ || (::isatty(STDIN_FILENO) == 1 && ::tcgetpgrp(STDIN_FILENO) != ::getpgrp()))
      return false;
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (::poll(&input, 1, 0) <= 0) return false;
    std::array<char, 4096> text{};
    is_at_end_ = ::read(STDIN_FILENO, text.data(), text.size()) <= 0;
    return !is_at_end_;
  }

 private:
  bool is_at_end_ = false;
};

void check_database(const std::string& path) {
  if (std::filesystem::exists(path)) db::Store{path};
  const auto folder = std::filesystem::path(path).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder))
    throw lab::BadInput(path, 0, "there is no folder " + folder.string() + "; create it first");
}

void run_open(const OpenOptions& o) {
  check_database(o.db);
  if (!o.rig.empty()) static_cast<void>(lab::load_rig_file(o.rig));
  const Interruption interruption;
  PageLaboratory laboratory(o.db, o.rig);
  const auto folder = std::filesystem::path(o.db).parent_path().string();
  laboratory.read_record = [](const RecordToRead& record, const Upload& upload,
                              const std::function<bool()>& stop) {
    // Twice the time: a record is read by two threads.
    const auto time = 2 * PageLimits{}.time_to_read(upload.size());
    const auto cpu_s = std::chrono::ceil<std::chrono::seconds>(time).count();
    return read_record_apart(record, upload, static_cast<std::uint64_t>(cpu_s), stop);
  };
  PageServer server({.listen = o.listen,
                     .port = o.port,
                     .upload_folder = folder.empty() ? "." : folder,
                     .queue_of = queue_of,
                     .answer = [&laboratory](const PageRequest& request) {
                       return answer(laboratory, request);
                     }});
  const OrderlyEnd end{laboratory};
  laboratory.new_address = [&server] { return server.new_address(); };
  if (!o.listen.empty())
    notify(
        "what browsers of other machines send and are given is not encrypted: listen in a "
        "network that you trust");
  print(fmt::format("{}\n", server.new_address()));
  constexpr std::chrono::milliseconds kLook{100};
  EnteredLines lines;
  while (!interruption.requested()) {
    laboratory.desk.work_for(kLook);
    if (lines.next()) print(fmt::format("{}\n", server.new_address()));
  }
}

}  // namespace

Command open_command() {
  return {
      .name = "open",
      .purpose = "the laboratory in a browser: tests, running tests, trying one, stability",
      .description =
          {"Prints one address; a browser of this machine shows there the tests of the database, "
           "takes in records that are dropped on it, runs programmes on the virtual apparatus and "
           "draws them while they run. Everything is inside the program: no other server, nothing "
           "from elsewhere.",
           "The address works once, within an hour, and lets one browser in: until 12 hours "
           "without "
           "use, and for 7 days at most. That browser can ask for another address, and Enter in "
           "the "
           "terminal of `triax open` prints one. Who has neither is given nothing; but a browser "
           "sends what lets it in to "
           "every server of this machine that it visits, whatever its port: leave servers of other "
           "people on this machine alone with that browser.",
           "With RIG.toml programmes can be run on the instruments of that rig as `triax run` "
           "does. A test that another triax records into the same database is shown while it "
           "runs.",
           "Ctrl-C ends it: tests that it runs are stopped in an orderly way and stored."},
      .diagnostics = {{"cannot listen at ...",
                       "another program has that port, or the address is not this "
                       "machine's"},
                      {"--listen 0.0.0.0: ...", "give the name by which browsers come"}},
      .examples = {{"triax open", "the tests of triax.db in the current folder"},
                   {"triax open --db sand.db --port 8080",
                    "another database, always the same port"},
                   {"triax open bench.toml", "with the rig on the bench"},
                   {"triax open --listen lab-pc", "for browsers of the local network"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<OpenOptions>();
        app.add_option("RIG.toml", o->rig, "instruments that programmes may be run on")
            ->type_name("");
        add_db(app, o->db);
        app.add_option("--port", o->port, "port to listen at [any that is free]")
            ->check(CLI::Range(1, 65535).description(""))
            ->type_name("N");
        app.add_option("--listen", o->listen,
                       "name or address of this machine by which browsers of others come; may be "
                       "repeated [this machine only]")
            ->type_name("ADDRESS")
            ->allow_extra_args(false);
        return [o] { run_open(*o); };
      }};
}

}  // namespace triax::src
