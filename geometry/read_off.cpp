// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "geometry/triangle_file.hpp"
#include "geometry/word_lines.hpp"

namespace dmp::geometry {

namespace {

/// One OFF file while it is read.
class OffReader {
  public:
    OffReader(std::string_view text, const std::string& file) : lines_(text, '#'), file_(file), size_(text.size()) {}

    TriangleSoup read() {
        read_header();
        for (long long k = 0; k < corner_count_; ++k) read_corner(k);
        for (long long k = 0; k < face_count_; ++k) read_face(k);
        if (lines_.next_with_tokens())
            throw fault("the file goes on after the " + std::to_string(face_count_) + " faces that it states");
        return builder_.finish();
    }

  private:
    [[nodiscard]] InputError fault(const std::string& problem) const {
        return {SourceLocation{file_, lines_.number(), 1}, problem, "export the surface again, as OFF in text"};
    }

    void next_line(const char* what, long long number, long long count) {
        if (lines_.next_with_tokens()) return;
        throw fault(std::string("the file ends before ") + what + " " + std::to_string(number + 1) + " of " +
                    std::to_string(count));
    }

    /// "OFF" and the numbers of corners, faces and edges, on one line or two; the word may be left out.
    void read_header() {
        if (!lines_.next_with_tokens()) throw fault("'" + file_ + "' is no OFF file: it has no lines");
        auto words = lines_.words();
        if (!whole_number_in(words[0])) {
            const std::string_view word = words[0];
            if (!word.ends_with("OFF") || word.find_first_of("4n") != std::string_view::npos ||
                (words.size() > 1 && words[1] == "BINARY"))
                throw fault("'" + file_ + "' is no OFF file of points in 3-D in text");
            words.erase(words.begin());
            if (words.empty()) {
                next_line("its counts", -1, 0);
                words = lines_.words();
            }
        }
        const auto count_at = [&](std::size_t k) {
            return k < words.size() ? whole_number_in(words[k]) : std::nullopt;
        };
        const auto corners = count_at(0), faces = count_at(1);
        if (!corners || !faces || *corners < 0 || *faces < 0)
            throw fault("expected the numbers of corners, faces and edges, found " + in_quotes(lines_.line()));
        // A corner takes "0 0 0" and a line's end, a face "3 0 1 2", at least.
        constexpr std::size_t shortest_corner = 6, shortest_face = 8;
        if (static_cast<std::size_t>(*corners) > size_ / shortest_corner + 1 ||
            static_cast<std::size_t>(*faces) > size_ / shortest_face + 1)
            throw fault("the file states " + std::to_string(*corners) + " corners and " + std::to_string(*faces) +
                        " faces, more than its " + std::to_string(size_) + " bytes can hold");
        corner_count_ = *corners;
        face_count_ = *faces;
    }

    void read_corner(long long k) {
        next_line("corner", k, corner_count_);
        Vec position = Vec::Zero();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto number = axis < lines_.words().size() ? number_in(lines_.words()[axis]) : std::nullopt;
            if (!number) throw fault("expected a corner's three numbers, found " + in_quotes(lines_.line()));
            position[static_cast<Eigen::Index>(axis)] = *number;
        }
        if (!position.allFinite()) throw fault("corner " + std::to_string(k) + " is not finite");
        corners_.push_back(builder_.corner(position));
    }

    void read_face(long long k) {
        next_line("face", k, face_count_);
        const auto& words = lines_.words();
        const auto sides = whole_number_in(words[0]);
        if (!sides || *sides < 3 || static_cast<std::size_t>(*sides) >= words.size())
            throw fault("expected a face, the number of its corners and which they are, found " +
                        in_quotes(lines_.line()));
        face_.clear();
        for (std::size_t c = 1; c <= static_cast<std::size_t>(*sides); ++c) {
            const auto number = whole_number_in(words[c]);
            if (!number || *number < 0 || *number >= corner_count_)
                throw fault("a face has corner " + in_quotes(words[c]) + ", and corners count from 0 to " +
                            std::to_string(corner_count_ - 1));
            face_.push_back(corners_[static_cast<std::size_t>(*number)]);
        }
        if (!builder_.add_polygon(face_))
            throw fault("a face has " + std::to_string(face_.size()) + " corners, too many to split it");
    }

    TokenLines lines_;
    const std::string& file_;
    std::size_t size_;
    SoupBuilder builder_;
    long long corner_count_ = 0, face_count_ = 0;
    std::vector<int> corners_;  ///< the builder's numbers by the file's
    std::vector<int> face_;
};

}  // namespace

TriangleSoup read_off_text(std::string_view text, const std::string& file) { return OffReader(text, file).read(); }

}  // namespace dmp::geometry
