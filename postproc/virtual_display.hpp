// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <sys/types.h>

namespace dmp::postproc {

/// A display for rendering: that of $DISPLAY if it is on this machine and supports OpenGL, otherwise a virtual one
/// (Xvfb) that runs during this object's lifetime. VTK aborts the program if it cannot open a display, so nothing may
/// be rendered unless `usable()`.
///
/// Sets DISPLAY during its lifetime and restores it afterwards. The server ends with this object, or with the
/// program.
class VirtualDisplay {
  public:
    VirtualDisplay();
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    [[nodiscard]] bool usable() const { return problem_.empty(); }
    /// Why nothing can be rendered and what to do about it; empty if usable.
    [[nodiscard]] const std::string& problem() const { return problem_; }
    /// Process id of the server started here, -1 if the existing display is used.
    [[nodiscard]] pid_t server() const { return server_; }

  private:
    void start_server(const std::string& program);
    void stop_server();

    std::optional<std::string> display_before_;
    std::string problem_;
    pid_t server_ = -1;
};

}  // namespace dmp::postproc
