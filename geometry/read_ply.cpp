// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

#include "geometry/triangle_file.hpp"
#include "geometry/word_lines.hpp"

namespace dmp::geometry {

namespace {

enum class Encoding { text, little_endian, big_endian };

struct NumberType {
    std::size_t bytes;
    bool is_float, is_signed;
};

std::optional<NumberType> type_called(std::string_view word) {
    if (word == "char" || word == "int8") return NumberType{1, false, true};
    if (word == "uchar" || word == "uint8") return NumberType{1, false, false};
    if (word == "short" || word == "int16") return NumberType{2, false, true};
    if (word == "ushort" || word == "uint16") return NumberType{2, false, false};
    if (word == "int" || word == "int32") return NumberType{4, false, true};
    if (word == "uint" || word == "uint32") return NumberType{4, false, false};
    if (word == "float" || word == "float32") return NumberType{4, true, true};
    if (word == "double" || word == "float64") return NumberType{8, true, true};
    return std::nullopt;
}

struct Property {
    std::string name;
    NumberType type;
    std::optional<NumberType> length;  ///< of a list: how its length is stored
};

struct Element {
    std::string name;
    long long count;
    std::vector<Property> properties;

    [[nodiscard]] std::string shown() const { return in_quotes(name, '\''); }
    [[nodiscard]] int index_of(std::string_view name_asked) const {
        const auto found = std::ranges::find(properties, name_asked, &Property::name);
        return found == properties.end() ? -1 : static_cast<int>(found - properties.begin());
    }
};

/// The numbers behind the header, one after another.
class Numbers {
  public:
    Numbers(std::string_view body, Encoding encoding, int first_line)
        : body_(body), encoding_(encoding), lines_(body, '\0', first_line) {}

    /// None where the file ends, or a text has no number there.
    std::optional<double> next(const NumberType& type) {
        if (encoding_ == Encoding::text) {
            while (word_ >= lines_.words().size()) {
                if (!lines_.next()) return std::nullopt;
                word_ = 0;
            }
            return number_in(lines_.words()[word_++]);
        }
        if (body_.size() - at_ < type.bytes) return std::nullopt;
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < type.bytes; ++k) {
            const std::size_t byte = encoding_ == Encoding::big_endian ? k : type.bytes - 1 - k;
            bits = bits << 8U | static_cast<unsigned char>(body_[at_ + byte]);
        }
        at_ += type.bytes;
        if (type.is_float)
            return type.bytes == 8 ? std::bit_cast<double>(bits)
                                   : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
        const std::uint64_t sign = std::uint64_t{1} << (8 * type.bytes - 1);
        const auto value = static_cast<double>(bits);
        return type.is_signed && (bits & sign) != 0 ? value - 2 * static_cast<double>(sign) : value;
    }
    /// Whether anything but blanks, line ends and zeros follows.
    [[nodiscard]] bool more_follows() {
        if (encoding_ == Encoding::text) return word_ < lines_.words().size() || lines_.next_with_tokens();
        const std::string_view rest = body_.substr(at_);
        return rest.find_first_not_of(std::string_view(" \t\r\n\0", 5)) != std::string_view::npos;
    }
    [[nodiscard]] int line() const { return encoding_ == Encoding::text ? lines_.number() : 0; }

  private:
    std::string_view body_;
    Encoding encoding_;
    TokenLines lines_;
    std::size_t word_ = 0, at_ = 0;
};

/// One PLY file while it is read.
class PlyReader {
  public:
    PlyReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    TriangleSoup read() {
        read_header();
        Numbers numbers(body_, encoding_, body_line_);
        for (const Element& element : elements_) read_element(element, numbers);
        if (numbers.more_follows())
            throw fault(numbers.line(),
                        "the file goes on after the last " + elements_.back().shown() + " that its header states");
        return builder_.finish();
    }

  private:
    [[nodiscard]] InputError fault(int line, const std::string& problem) const {
        return {SourceLocation{file_, line, line > 0 ? 1 : 0}, problem, "export the surface again, as PLY"};
    }

    void read_header() {
        TokenLines lines(text_.substr(0, end_of_header()));
        if (!lines.next() || lines.words() != std::vector<std::string_view>{"ply"})
            throw fault(0, "'" + file_ + "' is no PLY file: it does not begin with 'ply'");
        bool has_format = false;
        while (lines.next_with_tokens()) {
            const auto& words = lines.words();
            const auto wrong = [&] { return fault(lines.number(), "cannot read " + in_quotes(lines.line())); };
            if (words[0] == "format") {
                if (words.size() != 3) throw wrong();
                encoding_ = encoding_called(words[1], lines.number());
                has_format = true;
            } else if (words[0] == "element") {
                const auto count = words.size() == 3 ? whole_number_in(words[2]) : std::nullopt;
                if (!count || *count < 0) throw wrong();
                elements_.push_back({std::string(words[1]), *count, {}});
            } else if (words[0] == "property") {
                const bool is_list = words.size() == 5 && words[1] == "list";
                const auto type = type_called(words.size() < 3 ? "" : words[is_list ? 3 : 1]);
                const auto length = is_list ? type_called(words[2]) : std::nullopt;
                if (!type || elements_.empty() || (is_list ? !length || length->is_float : words.size() != 3))
                    throw wrong();
                elements_.back().properties.push_back({std::string(words.back()), *type, length});
            } else if (words[0] != "comment" && words[0] != "obj_info" && words[0] != "end_header") {
                throw fault(lines.number(), in_quotes(words[0], '\'') + " is no word of a PLY header");
            }
        }
        body_line_ = lines.number() + 1;
        if (!has_format) throw fault(0, "the header of '" + file_ + "' names no format");
        check_elements();
    }

    /// Where the line after "end_header" begins.
    std::size_t end_of_header() {
        const std::size_t longest = 1U << 20U;
        const std::size_t word = text_.substr(0, longest).find("\nend_header");
        const std::size_t line_end = word == std::string_view::npos ? word : text_.find('\n', word + 1);
        if (line_end == std::string_view::npos)
            throw fault(0, "'" + file_ + "' is no PLY file, or one that was cut off: its header has no end");
        body_ = text_.substr(line_end + 1);
        return line_end;
    }

    [[nodiscard]] Encoding encoding_called(std::string_view word, int line) const {
        if (word == "ascii") return Encoding::text;
        if (word == "binary_little_endian") return Encoding::little_endian;
        if (word == "binary_big_endian") return Encoding::big_endian;
        throw fault(line, in_quotes(word, '\'') + " is no format of PLY files");
    }

    void check_elements() const {
        for (const char* name : {"vertex", "face"}) {
            const auto element = std::ranges::find(elements_, name, &Element::name);
            if (element == elements_.end()) throw fault(0, "'" + file_ + "' has no element '" + name + "'");
        }
        for (const Element& element : elements_) {
            std::size_t bytes = 0;  // the fewest that one takes; of a text at least a digit and a blank a number
            for (const Property& property : element.properties)
                bytes += encoding_ == Encoding::text ? 2
                         : property.length           ? property.length->bytes
                                                     : property.type.bytes;
            if (bytes == 0 && element.count > 0) throw fault(0, "element " + element.shown() + " has no properties");
            if (element.count == 0 || static_cast<std::size_t>(element.count) <= (body_.size() + 1) / bytes) continue;
            throw fault(0, "the header states " + std::to_string(element.count) + " of element " + element.shown() +
                               ", more than the file's " + std::to_string(body_.size()) + " bytes behind it can hold");
        }
    }

    void read_element(const Element& element, Numbers& numbers) {
        const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
        std::array<int, 3> axes{};
        for (std::size_t axis = 0; axis < 3; ++axis) axes.at(axis) = element.index_of(std::string(1, "xyz"[axis]));
        const int face_list = std::max(element.index_of("vertex_indices"), element.index_of("vertex_index"));
        if (is_vertex && *std::ranges::min_element(axes) < 0) throw fault(0, "element 'vertex' has no x, y and z");
        if (is_face && (face_list < 0 || !element.properties[static_cast<std::size_t>(face_list)].length))
            throw fault(0, "element 'face' has no list vertex_indices");
        for (long long k = 0; k < element.count; ++k) {
            Vec position = Vec::Zero();
            const auto next = [&](const NumberType& type) {
                const auto number = numbers.next(type);
                if (number) return *number;
                throw fault(numbers.line(), "the file ends, or has no number, in " + element.shown() + " " +
                                                std::to_string(k) + " of " + std::to_string(element.count));
            };
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const Property& property = element.properties[p];
                if (property.length) {
                    const bool kept = is_face && static_cast<int>(p) == face_list;
                    read_list(property, kept, k, next, numbers);
                    continue;
                }
                const double number = next(property.type);
                for (std::size_t axis = 0; is_vertex && axis < 3; ++axis)
                    if (axes.at(axis) == static_cast<int>(p)) position[static_cast<Eigen::Index>(axis)] = number;
            }
            if (!is_vertex) continue;
            if (!position.allFinite()) throw fault(numbers.line(), "vertex " + std::to_string(k) + " is not finite");
            corners_.push_back(builder_.corner(position));
        }
    }

    template <class Next>
    void read_list(const Property& property, bool is_corners, long long face, const Next& next,
                   const Numbers& numbers) {
        const double length = next(*property.length);
        if (!(length >= 0) || length != std::floor(length))
            throw fault(numbers.line(), "face " + std::to_string(face) + " has a list of a wrong length");
        face_.clear();
        for (double k = 0; k < length; ++k) {
            const double number = next(property.type);
            if (!is_corners) continue;
            if (!(number >= 0) || number >= static_cast<double>(corners_.size()) || number != std::floor(number))
                throw fault(numbers.line(), "face " + std::to_string(face) + " has a corner that is not among the " +
                                                std::to_string(corners_.size()) + " before it");
            face_.push_back(corners_[static_cast<std::size_t>(number)]);
        }
        if (!is_corners) return;
        if (face_.size() < 3)
            throw fault(numbers.line(),
                        "face " + std::to_string(face) + " has " + std::to_string(face_.size()) + " corners");
        if (!builder_.add_polygon(face_))
            throw fault(numbers.line(), "face " + std::to_string(face) + " has " + std::to_string(face_.size()) +
                                            " corners, too many to split it");
    }

    std::string_view text_, body_;
    const std::string& file_;
    Encoding encoding_ = Encoding::text;
    int body_line_ = 1;
    std::vector<Element> elements_;
    SoupBuilder builder_;
    std::vector<int> corners_;  ///< the builder's numbers by the file's
    std::vector<int> face_;
};

}  // namespace

TriangleSoup read_ply_text(std::string_view text, const std::string& file) { return PlyReader(text, file).read(); }

}  // namespace dmp::geometry
