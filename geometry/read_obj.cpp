// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "geometry/triangle_file.hpp"
#include "geometry/word_lines.hpp"

namespace dmp::geometry {

namespace {

/// Statements about looks, names of files, lines and points: nothing of the surface.
constexpr std::array<std::string_view, 22> passed_over{
    "vn",       "vt",  "vp",         "s",         "mg", "usemtl", "mtllib", "usemap", "maplib", "bevel",  "c_interp",
    "d_interp", "lod", "shadow_obj", "trace_obj", "l",  "p",      "call",   "csh",    "scmp",   "cstech", "stech"};

/// One OBJ file while it is read.
class ObjReader {
  public:
    ObjReader(std::string_view text, const std::string& file) : lines_(text, '#', 1, true), file_(file) {}

    TriangleSoup read() {
        while (lines_.next_with_tokens()) {
            const std::string_view first = lines_.words()[0];
            if (first == "v")
                read_corner();
            else if (first == "f" || first == "fo")
                read_face();
            else if (first == "g" || first == "o")
                builder_.begin_group(lines_.words().size() > 1 ? std::string(lines_.words()[1]) : "");
            else if (std::ranges::find(passed_over, first) == passed_over.end())
                throw fault(in_quotes(first, '\'') + " is not read: dmp takes corners (v) and faces (f)",
                            "export the surface as triangles");
        }
        return builder_.finish();
    }

  private:
    [[nodiscard]] InputError fault(const std::string& problem, const std::string& what_to_do) const {
        return {SourceLocation{file_, lines_.number(), 1}, problem, what_to_do};
    }

    void read_corner() {
        Vec position = Vec::Zero();
        const auto& words = lines_.words();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto number = axis + 1 < words.size() ? number_in(words[axis + 1]) : std::nullopt;
            if (!number)
                throw fault("expected three numbers after 'v', found " + in_quotes(lines_.line()),
                            "export the surface again");
            position[static_cast<Eigen::Index>(axis)] = *number;
        }
        if (!position.allFinite())
            throw fault("corner " + std::to_string(corners_.size() + 1) + " is not finite", "export the surface again");
        corners_.push_back(builder_.corner(position));
    }

    /// Corners count from 1, or back from the last one, -1.
    void read_face() {
        const auto& words = lines_.words();
        if (words.size() < 4)
            throw fault("a face has " + std::to_string(words.size() - 1) + " corners", "export the surface again");
        const auto count = static_cast<long long>(corners_.size());
        face_.clear();
        for (std::size_t k = 1; k < words.size(); ++k) {
            const auto number = whole_number_in(words[k].substr(0, words[k].find('/')));
            if (!number)
                throw fault("expected the number of a corner, found " + in_quotes(words[k]),
                            "export the surface again");
            const long long at = *number > 0 ? *number - 1 : count + *number;
            if (*number == 0 || at < 0 || at >= count)
                throw fault("a face has corner " + std::to_string(*number) + ", and there are " +
                                std::to_string(count) + " so far",
                            "export the surface again");
            face_.push_back(corners_[static_cast<std::size_t>(at)]);
        }
        if (!builder_.add_polygon(face_))
            throw fault("a face has " + std::to_string(face_.size()) + " corners, too many to split it",
                        "export the surface as triangles");
    }

    TokenLines lines_;
    const std::string& file_;
    SoupBuilder builder_;
    std::vector<int> corners_;  ///< the builder's numbers by the file's
    std::vector<int> face_;
};

}  // namespace

TriangleSoup read_obj_text(std::string_view text, const std::string& file) { return ObjReader(text, file).read(); }

}  // namespace dmp::geometry
