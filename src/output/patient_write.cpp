// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/output/patient_write.hpp"

#include <chrono>
#include <string>
#include <thread>

#include "lab/base/whole_file.hpp"
#include "src/output/notice.hpp"

namespace triax::src {

void write_when_there_is_room(const std::function<void()>& write,
                              const std::function<bool()>& stop) {
  using namespace std::chrono_literals;
  bool waits = false;
  for (;; std::this_thread::sleep_for(250ms)) try {
      write();
      if (waits) notify("disk space is available again; no file is lost");
      return;
    } catch (const lab::NoRoom& full) {
      if (stop && stop()) throw;
      if (!waits) notify(std::string(full.what()) + "; waiting for free disk space");
      waits = true;
    }
}

}  // namespace triax::src
