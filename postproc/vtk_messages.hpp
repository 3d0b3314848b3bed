// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

namespace dmp::postproc {

/// While it lives, what VTK would print on the terminal is kept here instead.
/// One at a time, or nested like a stack; not for several threads at once.
class VtkMessages {
  public:
    VtkMessages();
    ~VtkMessages();
    VtkMessages(const VtkMessages&) = delete;
    VtkMessages& operator=(const VtkMessages&) = delete;

    /// Errors and warnings since the start, one a line; empty when all went well.
    [[nodiscard]] std::string text() const;

  private:
    struct Keeper;
    std::unique_ptr<Keeper> keeper_;
};

}  // namespace dmp::postproc
