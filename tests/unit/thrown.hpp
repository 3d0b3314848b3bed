// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/modules.hpp"

namespace dmp::tests {

/// The whole text of the ErrorKind that `action` throws; other kinds pass.
template <class ErrorKind>
std::string text_thrown(const auto& action) {
    try {
        action();
    } catch (const ErrorKind& error) {
        return error.what();
    }
    return "nothing was thrown";
}

}  // namespace dmp::tests
