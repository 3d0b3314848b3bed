// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

namespace dmp::postproc {

/// Collects the messages that VTK would print to the terminal during this object's lifetime. Only one at a time, or
/// nested like a stack; not for several threads at once.
class VtkMessages {
  public:
    VtkMessages();
    ~VtkMessages();
    VtkMessages(const VtkMessages&) = delete;
    VtkMessages& operator=(const VtkMessages&) = delete;

    /// Errors and warnings since construction, one per line; empty if there were none.
    [[nodiscard]] std::string text() const;

  private:
    struct Keeper;
    std::unique_ptr<Keeper> keeper_;
};

}  // namespace dmp::postproc
