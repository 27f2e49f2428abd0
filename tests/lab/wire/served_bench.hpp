// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A virtual rig on free ports, served by a thread of its own, and the file with which a client
// reaches it.
#include <atomic>
#include <future>
#include <string>
#include <thread>

#include "lab/programmes/programme_reader.hpp"
#include "lab/wire/remote/control_line.hpp"
#include "lab/wire/rig_file.hpp"
#include "lab/wire/served/served_rig.hpp"
#include "tests/lab/programmes/programme_text.hpp"

namespace triax::lab::test {

/// A scanner for the transducers; frame and controllers at `link` "tcp://127.0.0.1:0" or
/// "modbus-tcp://127.0.0.1:0/1".
inline std::string rig_text(const std::string& link = "tcp://127.0.0.1:0") {
  const auto channel = [](const std::string& quantity, const std::string& at,
                          const std::string& unit, const std::string& gain) {
    return "[[instruments.channels]]\nquantity = \"" + quantity + "\"\nat = \"" + at +
           "\"\nunit = \"" + unit + "\"\ncalibration = {gain = " + gain +
           ", date = \"2026-03-17\"}\n";
  };
  const auto drive = [&link](const std::string& name, const std::string& personality,
                             const std::string& role) {
    return "[[instruments]]\nname = \"" + name + "\"\nlink = \"" + link + "\"\npersonality = \"" +
           personality + "\"\nrole = \"" + role + "\"\n";
  };
  return "[rig]\nname = \"bench\"\n[plant]\nprogramme = \"p.toml\"\ncontrol = "
         "\"tcp://127.0.0.1:0\"\nwatchdog_s = 1.0\n"
         "[[instruments]]\nname = \"scanner\"\nlink = \"tcp://127.0.0.1:0\"\npersonality = "
         "\"34970A\"\n" +
         channel("axial_displacement", "101", "mm", "5.0") +
         channel("axial_force", "102", "N", "1000.0") +
         channel("cell_pressure", "103", "kPa", "200.0") +
         channel("pore_pressure", "105", "kPa", "-100.0") + drive("frame", "triax-frame", "frame") +
         drive("cell", "triax-controller", "cell") +
         channel("cell_volume", "volume_mm3", "mm3", "1.0") +
         drive("back", "triax-controller", "back") +
         channel("back_pressure", "pressure_kPa", "kPa", "1.0") +
         channel("back_volume", "volume_mm3", "mm3", "1.0");
}

class ServedBench {
 public:
  ServedBench(const Programme& programme, const std::string& rig, const ServingOptions& options)
      : client(parse_rig_file(rig, "rig.toml")), served_(client) {
    std::promise<std::vector<ServedRig::Open>> open;
    auto opened = open.get_future();
    thread_ = std::thread([this, programme, options, &open] {
      LineLoop loop;
      const ServedRig rig_on_the_wire(loop, served_, programme, options);
      open.set_value(rig_on_the_wire.open());
      loop.run_until([this] { return over_.load(); }, 1e9);
    });
    const auto links = opened.get();
    for (std::size_t i = 0; i < client.instruments.size(); ++i)
      client.instruments[i].link = links[i].link;
    client.plant->control = links.back().link;
  }
  ~ServedBench() {
    over_ = true;
    thread_.join();
  }
  ServedBench(const ServedBench&) = delete;
  ServedBench& operator=(const ServedBench&) = delete;

  RigFile client;  ///< with the ports that were taken

 private:
  const RigFile served_;
  std::atomic<bool> over_ = false;
  std::thread thread_;
};

/// Tells the rig's control; what it refuses fails the test.
inline void tell(ControlLine& control, const std::string& command) {
  const std::string answer = control.ask(command + ";:SYST:ERR?");
  if (answer.rfind("0,", 0) != 0) throw std::runtime_error(command + ": " + answer);
}

}  // namespace triax::lab::test
