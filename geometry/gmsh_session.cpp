// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/gmsh_session.hpp"

#include <algorithm>
#include <charconv>
#include <clocale>
#include <string_view>

#include <gmsh.h>
#include <omp.h>

#include "base/nearest_name.hpp"
#include "base/shell_word.hpp"
#include "geometry/geometry_file.hpp"

namespace dmp::geometry {

namespace {

std::mutex& gmsh_is_a_global() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace

GmshSession::GmshSession()
    : only_one_(gmsh_is_a_global()), threads_(omp_get_max_threads()), locale_(std::setlocale(LC_ALL, nullptr)) {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    throw_on_error(false);
    gmsh::onelab::clear();  // finalize leaves the constants of the last geometry
    gmsh::logger::start();
}

GmshSession::~GmshSession() {
    try {
        gmsh::logger::stop();
        gmsh::finalize();
    } catch (...) {  // a destructor must not throw, and there is nothing left to save
    }
    omp_set_num_threads(threads_);
    std::setlocale(LC_ALL, locale_.c_str());
}

void GmshSession::throw_on_error(bool yes) { gmsh::option::setNumber("General.AbortOnError", yes ? 2 : 0); }

std::vector<std::string> GmshSession::logged(const std::string& level) {
    std::vector<std::string> all;
    gmsh::logger::get(all);
    std::vector<std::string> chosen;
    for (const auto& line : all) {
        if (line.starts_with(level + ": ")) chosen.push_back(line.substr(level.size() + 2));
    }
    return chosen;
}

namespace {

/// One error of gmsh; the place is unknown for those that do not start with "'valve.geo', line 5: ".
struct GmshError {
    SourceLocation location;
    std::string text;
};

GmshError parsed(const std::string& message) {
    constexpr std::string_view before_line = "', line ";
    const std::size_t name_end = message.find(before_line);
    if (!message.starts_with('\'') || name_end == std::string::npos) return {.location = {}, .text = message};
    const std::size_t line_begin = name_end + before_line.size();
    const std::size_t colon = message.find(':', line_begin);
    const std::size_t text_begin = colon == std::string::npos ? colon : message.find_first_not_of(' ', colon + 1);
    if (text_begin == std::string::npos) return {.location = {}, .text = message};
    SourceLocation location{.file = message.substr(1, name_end - 1)};
    std::from_chars(message.data() + line_begin, message.data() + colon, location.line);
    return {.location = location, .text = message.substr(text_begin)};
}

/// Turns gmsh's errors into one of ours, at the first line they name.
void throw_logged_errors(const std::string& file, const GeometrySource& source) {
    constexpr std::size_t most_shown = 4;
    constexpr std::string_view syntax_error = "syntax error (";
    std::vector<GmshError> errors;
    for (const auto& message : GmshSession::logged("Error")) errors.push_back(parsed(source.in_users_words(message)));
    if (errors.empty()) return;

    const auto located = std::ranges::find_if(errors, [](const GmshError& error) { return error.location.line > 0; });
    const SourceLocation location = located == errors.end() ? SourceLocation{.file = file} : located->location;
    std::string problem;
    bool syntax = false;
    for (std::size_t i = 0; i < std::min(errors.size(), most_shown); ++i) {
        auto& [at, text] = errors[i];
        if (text.starts_with(syntax_error)) {
            syntax = true;
            const std::string word = text.substr(syntax_error.size(), text.rfind(')') - syntax_error.size());
            text = word.empty() ? "syntax error at the end" : "syntax error near '" + word + "'";
        }
        if (i > 0) problem += "; ";
        if (at.line > 0 && at.file != location.file) {
            problem += at.text() + ": ";
        } else if (at.line > 0 && at.line != location.line) {
            problem += "line " + std::to_string(at.line) + ": ";
        }
        problem += text;
    }
    if (errors.size() > most_shown) problem += "; and " + std::to_string(errors.size() - most_shown) + " more";
    throw InputError(location, "gmsh cannot read the geometry: " + problem,
                     syntax            ? "Look for a missing ';' or bracket on this line or the one before."
                     : is_script(file) ? "Correct the geometry; " + quoted_command("gmsh", file) + " shows it."
                                       : "Save or export it again: it may be cut off, or of a version that gmsh does "
                                         "not read; " +
                                             quoted_command("gmsh", file) + " may tell more.");
}

/// The numbers that the geometry offers for setting. (gmsh lists facts of its own and texts beside them.)
std::vector<std::string> offered_constants() {
    std::vector<std::string> names;
    gmsh::onelab::getNames(names);
    std::erase_if(names, [](const std::string& name) {
        std::vector<double> value;
        gmsh::onelab::getNumber(name, value);
        return value.empty() || name.starts_with("Gmsh/") || name.starts_with("ONELAB/");
    });
    std::ranges::sort(names);
    return names;
}

[[noreturn]] void throw_unknown_parameter(const std::string& name, const std::vector<std::string>& offered,
                                          const GeometryOptions& options, const GeometrySource& source,
                                          const SourceLocation& location) {
    const std::string problem = "the geometry '" + options.file + "' offers no constant '" + name + "' for setting";
    const std::string form = "DefineConstant[ " + name + " = {value, Name \"" + name + "\"} ];";
    if (const SourceLocation set = source.assignment_of(name); set.line > 0) {
        throw InputError(location, problem,
                         "Line " + std::to_string(set.line) + " of " +
                             (set.file == options.file ? "the geometry" : "'" + set.file + "'") +
                             " sets it, but not in the one form that can be set from outside: " + form);
    }
    std::string advice = "It offers " + quoted_list(offered) + ".";
    if (const auto near = nearest_name(name, offered); !near.empty()) advice = "Did you mean '" + near + "'? " + advice;
    if (offered.empty()) advice += " A constant is offered by " + form;
    throw InputError(location, problem, advice);
}

void check_parameters(const GeometryOptions& options, const GeometrySource& source,
                      const std::map<std::string, double>& known, const std::vector<std::string>& offered) {
    for (const auto& [name, value] : options.parameters) {
        const auto found = options.parameter_locations.find(name);
        const SourceLocation& location = found != options.parameter_locations.end() ? found->second : options.location;
        if (!known.contains(name)) throw_unknown_parameter(name, offered, options, source, location);
        std::vector<double> now;
        gmsh::onelab::getNumber(name, now);
        if (now.empty() || now.front() != value) {
            throw InputError(location, "the geometry '" + options.file + "' sets '" + name + "' itself",
                             "Remove ReadOnly or SetNumber for it from the geometry, or the parameter from the scene.");
        }
    }
}

/// In millimetres, whatever the file's unit: OpenCASCADE's tolerances (1e-7) are made for such numbers, and parts of a
/// millimetre in metres would come near them.
void prepare_for_cad(const std::string& file) {
    const bool loose = is_iges_file(file);
    // For IGES millimetres are OpenCASCADE's own choice, and gmsh 4.8 cannot set them.
    gmsh::option::setString("Geometry.OCCTargetUnit", loose ? "" : "MM");
    gmsh::option::setNumber("Geometry.OCCImportLabels", 1);
    // IGES files have loose faces, as a rule. Elsewhere sewing would make one body of several and lose their names.
    gmsh::option::setNumber("Geometry.OCCSewFaces", loose ? 1 : 0);
    gmsh::option::setNumber("Geometry.OCCMakeSolids", loose ? 1 : 0);
}

/// gmsh's own reading of BREP files moves points that lie beside the ends of their curves onto them.
void move_points_to_ends_of_curves() {
    double tolerance = 0;
    gmsh::option::getNumber("Geometry.Tolerance", tolerance);
    gmsh::vectorpair curves;
    gmsh::model::getEntities(curves, 1);
    for (const auto& [dimension, curve] : curves) {
        gmsh::vectorpair ends;
        gmsh::model::getBoundary({{1, curve}}, ends, false, true, false);  // its beginning, its end
        std::vector<double> lowest, highest;
        gmsh::model::getParametrizationBounds(1, curve, lowest, highest);
        for (std::size_t k = 0; k < std::min<std::size_t>(ends.size(), 2); ++k) {
            const int end = std::abs(ends[k].second);
            std::vector<double> point, at;
            gmsh::model::getValue(0, end, {}, point);
            gmsh::model::getValue(1, curve, k == 0 ? lowest : highest, at);
            if (point.size() != 3 || at.size() != 3) continue;
            const Vec from(point[0], point[1], point[2]), to(at[0], at[1], at[2]);
            if ((to - from).norm() > tolerance) gmsh::model::setCoordinates(end, at[0], at[1], at[2]);
        }
    }
}

/// By the reader for the format, whatever gmsh would take the file for.
void open_cad(const std::string& file, const GeometrySource& source) {
    prepare_for_cad(file);
    gmsh::vectorpair shapes;
    const std::string format = is_iges_file(file) ? "iges" : states_its_unit(file) ? "step" : "brep";
    gmsh::model::occ::importShapes(source.path(), shapes, false, format);
    gmsh::model::occ::synchronize();
    if (format == "brep") move_points_to_ends_of_curves();
    gmsh::merge(source.empty_script());
}

}  // namespace

// It takes as many goes as parameters bring others to light: setting one creates its name, so only a reading without it
// shows whether the geometry knows it, and a parameter may make the geometry offer others.
std::unique_ptr<GmshSession> open_geometry(const GeometryOptions& options, const GeometrySource& source) {
    std::map<std::string, double> known;
    std::vector<std::string> offered;
    std::unique_ptr<GmshSession> session;
    for (bool more = true; more;) {
        session.reset();
        session = std::make_unique<GmshSession>();
        for (const auto& [name, value] : known) gmsh::onelab::setNumber(name, {value});
        if (is_cad_file(options.file)) {
            open_cad(options.file, source);
        } else {
            gmsh::open(source.path());
        }
        offered = offered_constants();
        more = false;
        for (const auto& name : offered) {
            const auto asked = options.parameters.find(name);
            if (asked != options.parameters.end() && known.insert(*asked).second) more = true;
        }
    }
    throw_logged_errors(options.file, source);
    check_parameters(options, source, known, offered);
    GmshSession::throw_on_error(true);
    return session;
}

}  // namespace dmp::geometry
