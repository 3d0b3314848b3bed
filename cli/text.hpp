// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dmp::cli {

/// 94567 -> "94 567".
std::string count_text(std::size_t count);
/// "1 particle", "94 567 particles"; the plural is the word with an s.
std::string count_text(std::size_t count, std::string_view word);
/// 0.004 s -> "4 ms", 192 -> "3 min 12 s", 7300 -> "2 h 1 min".
std::string duration_text(double seconds);
/// Bytes in powers of 1024: "1.4 GiB".
std::string bytes_text(double bytes);
/// Four digits and the unit: "2.2 m/s".
std::string quantity_text(double value, std::string_view unit);
/// A relative difference: "+1.3 %", "-0.02 %".
std::string percent_text(double fraction);
/// A part of something: "3.2 %"; "-" where it is not known.
std::string part_text(double part);

/// Rows of as many cells each, below each other, indented by two.
std::string table_text(const std::vector<std::vector<std::string>>& rows);

/// Lines of "  name   text" with the texts below each other.
class Listing {
  public:
    explicit Listing(int indent = 2) : indent_(indent) {}
    void add(std::string name, std::string text) { lines_.emplace_back(std::move(name), std::move(text)); }
    [[nodiscard]] bool empty() const { return lines_.empty(); }
    [[nodiscard]] std::string text() const;
    /// Names and texts; an empty name goes on with the one before.
    [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& lines() const { return lines_; }

  private:
    int indent_;
    std::vector<std::pair<std::string, std::string>> lines_;
};

}  // namespace dmp::cli
