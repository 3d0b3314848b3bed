// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/script_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace dmp::geometry {

namespace {

using Harm = std::pair<std::string_view, std::string_view>;

constexpr std::string_view harm_runs = "run a program", harm_reads = "read another file", harm_writes = "write a file",
                           harm_window = "open a window";

/// Words of gmsh's grammar (Gmsh.l and Gmsh.y of 4.8) that no variable is called.
constexpr auto harmful_words = std::to_array<Harm>({
    {"AdaptMesh", "refine a mesh for as long as it takes"},
    {"Betti", harm_writes},
    {"Cohomology", harm_writes},
    {"CreateDir", "make a folder"},
    {"Exit", "end its process"},
    {"ExternalProcess", harm_runs},
    {"FileExists", "look for other files"},
    {"GetEnv", "read the environment"},
    {"Homology", harm_writes},
    {"ListFromFile", harm_reads},
    {"MergeWithBoundingBox", harm_reads},
    {"NonBlockingSystemCall", harm_runs},
    {"OnelabRun", harm_runs},
    {"Plugin", "run a plugin, which may read and write files"},
    {"S2N", "make a word of a text, which hides it from this check"},
    {"SendToServer", "send data to another program"},
    {"SetCurrentWindow", harm_window},
    {"SetString", "set a text of its own, such as a command"},
    {"ShapeFromFile", harm_reads},
    {"Sleep", "wait"},
    {"SplitCurrentWindowHorizontal", harm_window},
    {"SplitCurrentWindowVertical", harm_window},
    {"StringToName", "make a word of a text, which hides it from this check"},
    {"SystemCall", harm_runs},
    {"UnsplitWindow", harm_window},
});

/// Words that are commands only before a text or another word.
constexpr auto harmful_commands = std::to_array<Harm>({
    {"Include", harm_reads},
    {"Merge", harm_reads},
    {"Open", harm_reads},
    {"Print", harm_writes},
    {"Save", harm_writes},
    {"System", harm_runs},
});

constexpr auto text_options = std::to_array<std::string_view>(
    {"AutoCheck", "Call",          "Choices", "Closed", "Function", "Graph", "Help",   "Highlight",
     "Kind",      "Label",         "Loop",    "Macro",  "Max",      "Min",   "Name",   "Range",
     "ReadOnly",  "ReadOnlyRange", "SetName", "Step",   "Units",    "Using", "Visible"});

constexpr auto text_functions = std::to_array<std::string_view>({"AbsolutePath",
                                                                 "CodeName",
                                                                 "CurrentDir",
                                                                 "CurrentDirectory",
                                                                 "CurrentFileName",
                                                                 "DefineString",
                                                                 "DirName",
                                                                 "GetForcedStr",
                                                                 "FixRelativePath",
                                                                 "GetString",
                                                                 "GetStringValue",
                                                                 "GmshExecutableName",
                                                                 "LowerCase",
                                                                 "LowerCaseIn",
                                                                 "N2S",
                                                                 "NameStruct",
                                                                 "NameToString",
                                                                 "OnelabAction",
                                                                 "Sprintf",
                                                                 "Str",
                                                                 "StrCat",
                                                                 "StrChoice",
                                                                 "StrPrefix",
                                                                 "StrRelative",
                                                                 "StrReplace",
                                                                 "StrSub",
                                                                 "Today",
                                                                 "UpperCase"});

constexpr auto option_categories = std::to_array<std::string_view>(
    {"Background", "General", "Geometry", "Mesh", "Parser", "PostProcessing", "Print", "Solver", "View"});

/// Options of General that only change what a picture looks like or how much is said, by how they begin.
constexpr auto general_options = std::to_array<std::string_view>(
    {"Axes",       "Background", "Camera",      "Clip",       "Color",     "DrawBoundingBoxes",
     "ExpertMode", "Light",      "Material",    "MaxX",       "MaxY",      "MaxZ",
     "MinX",       "MinY",       "MinZ",        "NumThreads", "Ortho",     "Point",
     "Polygon",    "Quadric",    "Rotation",    "Scale",      "Shininess", "SmallAxes",
     "Terminal",   "Trackball",  "Translation", "Verbosity",  "Zoom"});

/// Options with these in their names hold files, commands or addresses.
constexpr auto parts_of_harmful_names = std::to_array<std::string_view>(
    {"Browser", "Command", "DoubleClicked", "Editor", "Executable", "FileName", "Path", "Python", "Socket"});

constexpr auto harmless_fields = std::to_array<std::string_view>({"Attractor",
                                                                  "AttractorAnisoCurve",
                                                                  "Ball",
                                                                  "BoundaryLayer",
                                                                  "Box",
                                                                  "Constant",
                                                                  "Curvature",
                                                                  "Cylinder",
                                                                  "Distance",
                                                                  "Extend",
                                                                  "Frustum",
                                                                  "Gradient",
                                                                  "IntersectAniso",
                                                                  "Laplacian",
                                                                  "LonLat",
                                                                  "MathEval",
                                                                  "MathEvalAniso",
                                                                  "Max",
                                                                  "MaxEigenHessian",
                                                                  "Mean",
                                                                  "Min",
                                                                  "MinAniso",
                                                                  "Octree",
                                                                  "Param",
                                                                  "Restrict",
                                                                  "Sphere",
                                                                  "Threshold"});

constexpr auto block_words = std::to_array<std::string_view>({"EndFor", "EndIf", "ElseIf", "Else", "Return"});

template <class Words>
bool holds(const Words& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

template <class Harms>
std::string_view harm_in(const Harms& harms, std::string_view word) {
    const auto found = std::ranges::find(harms, word, &Harm::first);
    return found == harms.end() ? std::string_view() : found->second;
}

}  // namespace

std::string_view harm_of_word(std::string_view word) { return harm_in(harmful_words, word); }

std::string_view harm_of_command(std::string_view word) { return harm_in(harmful_commands, word); }

bool takes_a_text(std::string_view word) { return holds(text_options, word); }

bool begins_a_text(std::string_view word) { return holds(text_functions, word); }

bool is_harmless_option(std::string_view category, std::string_view name) {
    const auto is_in_the_name = [&](std::string_view part) { return name.find(part) != std::string_view::npos; };
    if (std::ranges::any_of(parts_of_harmful_names, is_in_the_name)) return false;
    if (category == "Mesh" || category == "Geometry") return true;
    return category == "General" &&
           std::ranges::any_of(general_options, [&](std::string_view part) { return name.starts_with(part); });
}

bool is_option_category(std::string_view word) { return holds(option_categories, word); }

bool is_harmless_field(std::string_view type) { return holds(harmless_fields, type); }

std::string_view block_word_within(std::string_view text) {
    const auto is_letter = [&](std::size_t at) {
        return at < text.size() && (std::isalpha(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
    };
    for (const std::string_view word : block_words) {
        for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1))
            if ((at == 0 || !is_letter(at - 1)) && !is_letter(at + word.size())) return word;
    }
    return {};
}

}  // namespace dmp::geometry
