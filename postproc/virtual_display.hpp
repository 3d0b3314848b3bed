// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

namespace dmp::postproc {

/// A display to draw pictures on: the one of $DISPLAY where it is on this machine and can draw OpenGL, otherwise an
/// invisible one (Xvfb) started for this object's lifetime. VTK aborts the program on a display it cannot open,
/// so it must not be asked to draw without `usable()`.
///
/// Sets DISPLAY while it lives, and puts it back. The server ends with this object, or with the program.
class VirtualDisplay {
  public:
    VirtualDisplay();
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    [[nodiscard]] bool usable() const { return problem_.empty(); }
    /// Why nothing can be drawn and what to do about it; empty when usable.
    [[nodiscard]] const std::string& problem() const { return problem_; }
    /// Process id of the server started here, -1 where the given display serves.
    [[nodiscard]] pid_t server() const { return server_; }

  private:
    void start_server(const std::string& program);
    void stop_server();

    std::optional<std::string> display_before_;
    std::string problem_;
    pid_t server_ = -1;
};

}  // namespace dmp::postproc
