// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace dmp::tests {

/// A geometry that does more than describe shapes. OUT stands for a folder outside its own, which has a secret.txt, an
/// other.geo and a part.step.
struct Hostile {
    std::string name;
    std::string file;      ///< what `dmp inspect` is given
    std::string contents;  ///< of it
    std::string says;      ///< stands in the error
};

inline std::ostream& operator<<(std::ostream& stream, const Hostile& hostile) { return stream << hostile.name; }

/// Words of gmsh that run, write, read or set something, and ways to hide them.
inline std::vector<Hostile> hostile_scripts() {
    const std::string run = "SystemCall \"touch OUT/ran\";\n", runs = "would run a program, which a geometry may not";
    const std::string reads = "would read", option = "set or read an option";
    const auto geo = [](std::string name, std::string text, std::string says) {
        return Hostile{std::move(name), "part.geo", std::move(text), std::move(says)};
    };
    const std::string use_secret = "Point(1) = {x(0), 0, 0};\nPhysical Point(Sprintf(\"read%g\", x(0))) = {1};\n";
    return {
        // What runs.
        geo("SystemCall", "a = 1;\n" + run, "part.geo:2:1: 'SystemCall' " + runs),
        geo("NonBlockingSystemCall", "NonBlockingSystemCall \"touch OUT/ran\";\n", "'NonBlockingSystemCall' " + runs),
        geo("System", "System \"touch OUT/ran\";\n", "'System' " + runs),
        geo("SystemInSingleQuotes", "SystemCall 'touch OUT/ran';\n", "'SystemCall' " + runs),
        geo("OnTheNextLine", "SystemCall\n\n\t\"touch OUT/ran\"\n;\n", "part.geo:1:1: 'SystemCall' " + runs),
        geo("CommentBetween", "SystemCall /* \" */ \"touch OUT/ran\" // \"\n;\n", "'SystemCall' " + runs),
        geo("CommentsThatLookClosed", "/* // */ SystemCall \"touch OUT/ran\"; /* */\n", "part.geo:1:10: 'SystemCall'"),
        geo("AfterAReturnCharacter", "a = 1; // \r\n\r" + run, "'SystemCall' " + runs),
        geo("CommandOfPieces", "SystemCall StrCat(\"touch \", \"OUT/ran\");\n", "'SystemCall' " + runs),
        geo("WordOfAText", "StringToName[\"SystemCall\"] \"touch OUT/ran\";\n", "'StringToName' would make a word"),
        geo("WordOfPieces", "S2N[StrCat(\"System\", \"Call\")] \"touch OUT/ran\";\n", "'S2N' would make a word"),
        geo("InAMacro", "Macro f\n" + run + "Return\nCall f;\n", "part.geo:2:1: 'SystemCall' " + runs),
        geo("InACalledText", "Macro \"f\"\n" + run + "Return\nCall StrCat(\"f\", \"\");\n",
            "part.geo:2:1: 'SystemCall'"),
        geo("InABranchNotTaken", "If (0)\n" + run + "EndIf\n", "part.geo:2:1: 'SystemCall' " + runs),
        geo("EndIfInAText", "If (0)\na = \" EndIf SystemCall 'touch OUT/ran'; \";\nEndIf\n", "holds the word 'EndIf'"),
        geo("EndForInAText", "For i In {1 : 0}\na = \" EndFor SystemCall 'touch OUT/ran'; \";\nEndFor\n",
            "holds the word 'EndFor'"),
        geo("ReturnInAText", "Macro f\na = \" Return SystemCall 'touch OUT/ran'; \";\nReturn\n",
            "holds the word 'Return'"),
        geo("EndForInAComment", "For i In {1 : 0}\n E// EndFor; SystemCall \"touch OUT/ran\";\nEndFor\n",
            "no named groups"),
        geo("EndForInAWord", "For i In {1 : 0}\na1EndFor1SystemCall \"touch OUT/ran\";\nEndFor\n",
            "holds the word 'EndFor'"),
        geo("TextOfTwoLines", "For i In {1 : 2} a = \"\nSystemCall 'touch OUT/ran';\n\";\nEndFor\n",
            "part.geo:1:22: a text without its closing quote on the same line"),
        geo("TextWithAReturnCharacter", "a = \"\rSystemCall 'touch OUT/ran';\r\";\n",
            "a text without its closing quote"),
        geo("TextPastTheBuffer", "a = \"" + std::string(1025, 'x') + ";SystemCall 'touch OUT/ran';\";\n",
            "a text of more than 1023"),
        geo("WordPastTheBuffer", std::string(5000, 'a') + " \"x\";\n", "a word of more than 200"),
        geo("CommentWithoutEnd", "For i In {1 : 0}\nE/* EndFor; SystemCall \"touch OUT/ran\";\n",
            "For' without its 'EndFor'"),
        geo("CommentNeverClosed", "a = 1;\n/* SystemCall \"touch OUT/ran\";\n",
            "part.geo:2:1: a comment without its end"),
        geo("AZeroByte", std::string("a = \"") + '\0' + "\"; SystemCall 'touch OUT/ran';\n", "a zero byte"),
        geo("OptionThatIsACommand", "DefineConstant[ a = {0,\nSystemCall \"touch OUT/ran\"} ];\n",
            "part.geo:2:1: 'SystemCall'"),
        geo("UnknownCommand", "RunThis \"touch OUT/ran\";\n",
            "'RunThis' would do what dmp does not know to be harmless"),
        geo("UnknownOptionOnItsOwnLine", "DefineConstant[ a = {0,\nRunThis Str(\"touch OUT/ran\")} ];\n",
            "part.geo:2:1: 'RunThis'"),
        geo("OnelabRun", "OnelabRun(\"x\", \"touch OUT/ran\");\n", "'OnelabRun' " + runs),
        geo("Plugin", "Plugin(Triangulate).Run;\n", "'Plugin' would run a plugin"),
        geo("FieldOfAProcess",
            "Field[1] = ExternalProcess;\nField[1].CommandLine = \"touch OUT/ran\";\nBackground Field = 1;\n",
            "'ExternalProcess' would be a field"),
        geo("FieldUnknown", "Field[1] = Structured;\nField[1].FileName = \"OUT/secret.txt\";\n",
            "'Structured' would be a field"),
        // What sets commands and files.
        geo("Solver", "Solver.Executable0 = \"touch OUT/ran\";\n", "'Solver.Executable0' would " + option),
        geo("SolverByNumber", "Solver[0].Executable = \"touch OUT/ran\";\n", "'Executable' would " + option),
        geo("OptionOverLines", "General\n.\nTextEditor = \"touch OUT/ran\";\n", "'General.TextEditor' would " + option),
        geo("ErrorFile", "General.ErrorFileName = \"OUT/ran\";\n", "'General.ErrorFileName' would " + option),
        geo("AbortOnError", "General.AbortOnError = 4;\n", "'General.AbortOnError' would " + option),
        geo("GraphPoint", "PostProcessing.GraphPointCommand = \"SystemCall 'touch OUT/ran';\";\n",
            "'PostProcessing.GraphPointCommand' would " + option),
        geo("ParameterCommand", "Print.ParameterCommand = \"SystemCall 'touch OUT/ran';\";\n",
            "'Print.ParameterCommand' would"),
        geo("DoubleClick", "Geometry.DoubleClickedPointCommand = \"touch OUT/ran\";\n",
            "'Geometry.DoubleClickedPointCommand' would " + option),
        geo("OptionOfAView", "View \"v\" {\nSP(0,0,0){1};\n};\nView[0].FileName = \"OUT/ran\";\n",
            "'View' would make a view"),
        geo("CategoryOfAnIndex", "General~{1}.TextEditor = \"x\";\n", "would " + option),
        geo("SetString", "SetString(\"Solver\", \"touch OUT/ran\");\n", "'SetString' would set a text"),
        geo("DeleteOptions", "Delete Options;\n", "'Delete Options' would undo"),
        geo("DeleteAll", "Delete All;\n", "'Delete All' would undo"),
        // What writes.
        geo("PrintfIntoAFile", "Printf(\"x\") > \"OUT/ran\";\n",
            "part.geo:1:1: 'Printf' would write what it says into a file"),
        geo("PrintfAtTheEndOfAFile", "Printf(\"%g\", (1)) >> \"OUT/secret.txt\";\n", "'Printf' would write"),
        geo("PrintfOverLines", "Printf(\"x\")\n// ;\n>\n\"OUT/ran\"\n;\n", "'Printf' would write"),
        geo("Save", "Point(1) = {0, 0, 0};\nSave \"OUT/ran.msh\";\n", "part.geo:2:1: 'Save' would write a file"),
        geo("SaveOverAFile", "Point(1) = {0, 0, 0};\nSave StrCat(\"OUT/\", \"secret.txt\");\n",
            "'Save' would write a file"),
        geo("SaveOfAView", "Save View[0] \"OUT/ran\";\n", "'Save' would write a file"),
        geo("Print", "Print \"OUT/ran.geo_unrolled\";\n", "'Print' would write a file"),
        geo("CreateDir", "CreateDir \"OUT/ran\";\n", "'CreateDir' would make a folder"),
        geo("Homology", "Homology {{1}};\n", "'Homology' would write a file"),
        // What reads.
        geo("Include", "Include \"OUT/other.geo\";\n",
            "'Include' would read 'OUT/other.geo', which lies outside the folder"),
        geo("IncludeFromAbove", "Include \"../outside/other.geo\";\n", "'Include' would read '../outside/other.geo'"),
        geo("IncludeOfALink", "Include \"link.geo\";\n",
            "'Include' would read 'link.geo', which lies outside the folder"),
        geo("IncludeOfADevice", "Include \"/dev/zero\";\n", "'Include' would read '/dev/zero'"),
        geo("IncludeOfAPipe", "Include \"pipe.geo\";\n", "'Include' would read 'pipe.geo', which is no ordinary file"),
        geo("IncludeOfAComputedName", "Include StrCat(\"OUT/\", \"other.geo\");\n",
            "'Include' would read another file"),
        geo("IncludeOfWhatRuns", "a = 1;\nInclude \"runs.geo\";\n", "runs.geo:3:1: 'SystemCall' " + runs),
        geo("IncludeOfHalfACommand", "Include \"half.geo\";\n\"OUT/ran.msh\";\n",
            "half.geo:1:1: 'Save' would write a file"),
        geo("IncludeOfItself", "Include \"part.geo\";\n", "'Include' of 'part.geo' has no end"),
        geo("IncludeOfThousands", "Include \"many1.geo\";\n", "too large to check"),
        geo("IncludeOfNothing", "Include \"none.geo\";\n",
            "'Include' names the file 'none.geo', which cannot be found"),
        geo("Merge", "Merge \"OUT/part.step\";\n", "'Merge' would read 'OUT/part.step', which lies outside"),
        geo("MergeOfAnotherReader", "Merge \"beside.pos\";\n",
            "'Merge' would read 'beside.pos' with another of gmsh's readers"),
        geo("MergeWithBoundingBox", "MergeWithBoundingBox \"OUT/other.geo\";\n", "'MergeWithBoundingBox' would read"),
        geo("ListFromFile", "x() = ListFromFile[\"OUT/secret.txt\"];\n" + use_secret,
            "part.geo:1:7: 'ListFromFile' would read"),
        geo("ShapeFromFile", "SetFactory(\"OpenCASCADE\");\nShapeFromFile(\"OUT/part.step\");\n",
            "'ShapeFromFile' would read"),
        geo("FileExists", "a = FileExists(\"OUT/secret.txt\");\n", "'FileExists' would look for other files"),
        geo("GetEnv", "a = GetEnv(\"HOME\");\n", "'GetEnv' would read the environment"),
        // What ends or holds up.
        geo("Exit", "Exit;\n", "'Exit' would end its process"),
        geo("Sleep", "Sleep 1000000;\n", "'Sleep' would wait"),
        geo("Window", "UnsplitWindow;\n", "'UnsplitWindow' would open a window"),
        // Files of another kind than they say.
        {"ScriptNamedMesh", "part.msh", run, "part.msh:1: this is no mesh of gmsh"},
        {"ScriptAfterABlankNamedMesh", "part.msh", "\n" + run, "part.msh:1: this is no mesh of gmsh"},
        {"ScriptAfterAWordOfMeshes", "part.msh", "$PhysicalNames\n;" + run, "part.msh:1: this is no mesh of gmsh"},
        {"ScriptNamedStep", "part.step", run, "part.step: "},
        {"ScriptNamedStepInMixedCase", "part.Step", run, "part.Step: "},
        {"ScriptNamedIges", "part.igs", run, "part.igs: "},
        {"ScriptNamedBrepInCapitals", "part.BREP", run, "part.BREP: "},
        {"MeshNamedScript", "part.geo", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", "part.geo:1:1: this is a mesh"},
        {"ScriptUnrolled", "part.geo_unrolled", run, "part.geo_unrolled:1:1: 'SystemCall' " + runs},
    };
}

}  // namespace dmp::tests
