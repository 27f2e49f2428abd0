// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <map>
#include <optional>
#include <thread>
#include <utility>

#include "lab/programmes/programme_reader.hpp"
#include "lab/rig/rig_header.hpp"
#include "lab/rig/rig_software.hpp"
#include "lab/rig/supervision.hpp"
#include "lab/wire/remote/remote_apparatus.hpp"
#include "lab/wire/scpi/scpi_conversation.hpp"
#include "lab/wire/served/served_rig.hpp"
#include "tests/lab/programmes/programme_text.hpp"
#include "tests/wire/faults/rig_of_trial.hpp"
#include "tests/wire/faults/terminal_pairs.hpp"
#include "tests/wire/faults/trial.hpp"

namespace triax::lab::test {

double trial_now_s() {
  using Clock = std::chrono::steady_clock;
  static const auto start = Clock::now();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

namespace {

/// Everything that is read changes at every tick, and everything is needed.
Programme trial_programme() {
  return read_programme(replaced(programme_text(R"(
[[stages]]
name = "drained shear"
role = "shear"
drainage = "open"
axial = "displacement"
axial_rate_mm_per_min = 1.0
cell_rate_kPa_per_min = 60.0
back_rate_kPa_per_min = 20.0
time_limit_min = 60.0
end = [{quantity = "q_kPa", above = 5000.0}]
)"),
                                 "scan_interval_s = 1.0", "scan_interval_s = 0.5"),
                        "p.toml");
}

/// Ports below those that the system gives out: while a cable is out, nobody else takes its port.
RigFile on_ports_of(const TrialPlan& plan, RigFile rig) {
  constexpr int kFirst = 10'000, kOfOneProgram = 5'400, kPrograms = 4, kOfTrial = 5;
  int port = kFirst + ::getpid() % kPrograms * kOfOneProgram + plan.number * kOfTrial;
  for (RigInstrument& one : rig.instruments) one.link.port = port++;
  rig.plant->control->port = port;
  return rig;
}

/// The served rig in its thread; faults are switched in it at their instants.
class TrialServer {
 public:
  TrialServer(const TrialPlan& plan, const RigFile& rig, const Programme& programme, TrialLog& log)
      : log_(log) {
    std::promise<std::vector<ServedRig::Open>> open;
    auto opened = open.get_future();
    thread_ =
        std::thread([this, &plan, &rig, &programme, &open] { serve(plan, rig, programme, open); });
    links = opened.get();
  }
  ~TrialServer() { end(); }
  void begin() { began_ = true; }
  void end() {
    over_ = true;
    if (thread_.joinable()) thread_.join();
  }
  std::vector<ServedRig::Open> links;

 private:
  void serve(const TrialPlan& plan, const RigFile& rig, const Programme& programme,
             std::promise<std::vector<ServedRig::Open>>& open) {
    LineLoop loop;
    const ServedRig served(loop, rig, programme, {});
    const WireDevice nobody{.name = "trial", .identity = "trial", .points = {}};
    ScpiConversation control(served.control(), nobody);
    std::vector<LineTimer> timers;
    open.set_value(served.open());
    double seen_s = -1, before_s = trial_now_s();
    loop.run_until(
        [&] {
          const double now_s = trial_now_s();
          log_.stall_s = std::max(log_.stall_s, now_s - before_s - 0.05);
          before_s = now_s;
          if (began_ && timers.empty()) plan_faults(plan, loop, control, timers);
          if (std::exchange(seen_s, served.plant().time_s()) != served.plant().time_s())
            log_.plant.push_back({now_s, served.plant().reading(),
                                  served.plant().devices().cell.asked_pa,
                                  served.plant().devices().back.asked_pa,
                                  served.plant().axis().mode == FrameMode::stop});
          return over_.load();
        },
        1e9);
  }

  void tell_tree(ScpiConversation& control, const std::string& command) {
    std::string reply;
    control.take(command + ";:SYST:ERR?\n", reply);
    if (!reply.starts_with("0,")) log_.failed += command + ": " + reply;
  }

  void plan_faults(const TrialPlan& plan, LineLoop& loop, ScpiConversation& control,
                   std::vector<LineTimer>& timers) {
    log_.lasted.assign(plan.wrongs.size(), {0, 0});
    for (std::size_t i = 0; i < plan.wrongs.size(); ++i) {
      const Wrong& one = plan.wrongs[i];
      double at_s = loop.now_s() + one.from_s;
      const auto say = [&](const std::vector<std::string>& commands, double& when) {
        for (const std::string& command : commands) {
          if (command.starts_with('+')) {
            at_s += std::stod(command);
            continue;
          }
          timers.push_back(loop.at(at_s, [this, &control, command, &when] {
            if (when == 0) when = trial_now_s();
            tell_tree(control, command);
          }));
        }
      };
      say(one.on, log_.lasted[i].first);
      at_s = loop.now_s() + one.from_s + one.for_s;
      say(one.off, log_.lasted[i].second);
    }
  }

  TrialLog& log_;
  std::atomic<bool> began_ = false, over_ = false;
  std::thread thread_;
};

/// Logs what passes between rig and software; breaks it where a check is to be tried.
class WatchedApparatus : public Apparatus {
 public:
  WatchedApparatus(std::unique_ptr<RemoteApparatus> inner, TrialLog& log, Broken broken)
      : inner_(std::move(inner)), log_(log), broken_(broken) {}

  void look(Reading& reading) override {
    Look& now = log_.looks.emplace_back();
    now.asked_s = trial_now_s();
    inner_->look(reading);
    now.answered_s = trial_now_s();
    if (broken_ == Broken::held_over && log_.looks.size() > 1)
      for (std::size_t i = 0; i < kRawQuantityCount; ++i)
        if (std::isnan(reading.si[i])) reading.si[i] = log_.looks.end()[-2].reading.si[i];
    if (broken_ == Broken::other_channel)
      std::swap(reading[Quantity::cell_volume], reading[Quantity::back_volume]);
    now.reading = reading;
  }
  const DeviceStates& devices() const override {
    devices_ = inner_->devices();
    if (broken_ == Broken::unsafe) devices_.fault.clear();
    return devices_;
  }
  Ticked tick(const PlantDemand& demand, const Tick& tick) override {
    Ticked done = inner_->tick(demand, tick);
    if (broken_ == Broken::untold) done.events.clear();
    if (broken_ == Broken::identity)
      std::erase_if(done.events, [](const Event& e) {
        return e.detail.find("the identity is") != std::string::npos ||
               e.detail.find("another identity") != std::string::npos;
      });
    log_.looks.back().running = tick.running;
    log_.looks.back().events = done.events;
    log_.looks.back().over_s = trial_now_s();
    return done;
  }
  void rest() override { inner_->rest(); }
  std::vector<std::string> begin_shear() override { return inner_->begin_shear(); }

 private:
  std::unique_ptr<RemoteApparatus> inner_;
  mutable DeviceStates devices_;
  TrialLog& log_;
  Broken broken_;
};

void drive(const TrialPlan& plan, const RigFile& rig, const Programme& programme, TrialLog& log,
           Broken broken, TrialServer& server) {
  LineLoop loop;
  auto remote = std::make_unique<RemoteApparatus>(loop, rig, programme);
  remote->connect(20);
  RigSoftware software(with_guard_stages(programme), rig_header(programme, programme.seed),
                       std::make_unique<WatchedApparatus>(std::move(remote), log, broken));
  server.begin();
  double last_s = 0, begun_s = 0;
  for (const Wrong& one : plan.wrongs) {
    last_s = std::max(last_s, one.from_s + one.for_s);
    begun_s = std::max(begun_s, one.from_s);
  }
  const double began_s = trial_now_s();
  // A device that cannot be told to stop does so by its watchdog, once it is left alone.
  const auto held_s = [&] {
    return std::max(log.safe_s, began_s + begun_s + Supervision::kDeaf_s) + kWatchdog_s + 1;
  };
  Reading reading;
  while (software.next(reading)) {
    for (Event& event : software.events()) {
      if (event.kind == EventKind::safe_state && log.safe_s == 0) log.safe_s = trial_now_s();
      log.events.push_back(std::move(event));
    }
    const double now_s = trial_now_s();
    if (log.safe_s > 0 ? now_s > held_s() : now_s > began_s + last_s + 2.2) return;
  }
  if (log.safe_s > 0)
    std::this_thread::sleep_for(std::chrono::duration<double>(held_s() - trial_now_s()));
}

}  // namespace

TrialLog run_trial(const TrialPlan& plan, Broken broken) {
  TrialLog log;
  const Programme programme = trial_programme();
  RigFile served = on_ports_of(plan, parse_rig_file(rig_of_trial(plan.modbus), "rig.toml"));
  std::optional<TerminalPairs> lines;
  if (plan.serial) {
    lines.emplace(3, plan.number);
    for (std::size_t i = 0; i < 3; ++i)
      served.instruments[i + 1].link =
          parse_link("modbus-rtu://" + lines->ends()[i].served + "?unit=3");
  }
  TrialServer server(plan, served, programme, log);
  RigFile client = served;
  for (std::size_t i = 0; i < client.instruments.size(); ++i) {
    client.instruments[i].link = server.links[i].link;
    if (lines && i > 0) client.instruments[i].link.path = lines->ends()[i - 1].client;
    client.instruments[i].personality.deadline_s = plan.deadline_s;
  }
  client.plant->control = server.links.back().link;
  try {
    drive(plan, client, programme, log, broken, server);
  } catch (const std::exception& error) {
    log.failed += error.what();
  }
  server.end();
  return log;
}

}  // namespace triax::lab::test
