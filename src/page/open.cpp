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
#include "lab/base/whole_file.hpp"
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
  lab::check_folder_of(path);
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
        "connections to other computers are not encrypted: use --listen only in a network that you "
        "trust");
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
      .purpose = "Serve the web interface",
      .description =
          {"Prints an address for the browser of this machine. The web interface shows the tests "
           "of the database, imports records that are dropped on it, runs programmes on the "
           "virtual apparatus and draws them while they run. Everything is part of the program: no "
           "other server and no external content is needed.",
           "The address works once, within an hour. It gives access to one browser, for at most 7 "
           "days. The access ends earlier if that browser is not used for 12 hours. That browser "
           "can request another address, and Enter in the terminal of `triax open` prints one. "
           "Other clients have no access. However, a "
           "browser sends its access cookie to every server on this machine that it visits, "
           "whatever the port: do not visit servers of other people on this machine with that "
           "browser.",
           "With RIG.toml, programmes can be run on the instruments of that rig, as with `triax "
           "run`. A test that another triax records in the same database is shown while it runs.",
           "Ctrl-C stops it: running tests are stopped in an orderly way and stored."},
      .diagnostics = {{"cannot listen at ...",
                       "choose another port or address: another program uses the port, or the "
                       "address is not of this machine"},
                      {"--listen 0.0.0.0: ...", "give the name or address that browsers use"}},
      .examples = {{"triax open", "serve the tests of triax.db in the current folder"},
                   {"triax open --db sand.db --port 8080",
                    "serve another database, always at the same port"},
                   {"triax open bench.toml", "serve with the rig on the bench"},
                   {"triax open --listen lab-pc", "serve to browsers of the local network"}},
      .set_up = [](CLI::App& app) -> std::function<void()> {
        const auto o = std::make_shared<OpenOptions>();
        app.add_option("RIG.toml", o->rig, "rig file, to run programmes on its instruments")
            ->type_name("");
        add_db(app, o->db);
        app.add_option("--port", o->port, "port to listen at [any free port]")
            ->check(CLI::Range(1, 65535).description(""))
            ->type_name("N");
        app.add_option("--listen", o->listen,
                       "name or address of this machine, for browsers of other machines "
                       "(repeatable) [this machine only]")
            ->type_name("ADDRESS")
            ->allow_extra_args(false);
        return [o] { run_open(*o); };
      }};
}

}  // namespace triax::src
