// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/read_frames.hpp"

#include <cstring>

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUtilities.h>

#include "base/errors.hpp"
#include "postproc/polydata.hpp"
#include "postproc/vtk_messages.hpp"

namespace dmp::postproc {

namespace fs = std::filesystem;

std::vector<SeriesEntry> read_series(const fs::path& pvd) {
    if (!fs::exists(pvd)) return {};
    const VtkMessages messages;
    vtkSmartPointer<vtkXMLDataElement> root;
    root.TakeReference(vtkXMLUtilities::ReadElementFromFile(pvd.c_str()));
    vtkXMLDataElement* collection = root != nullptr ? root->FindNestedElementWithName("Collection") : nullptr;
    if (collection == nullptr)
        throw InputError(SourceLocation{pvd.string(), 0, 0}, "not a complete ParaView collection (.pvd)",
                         "Run the simulation again, or restore the file.");
    std::vector<SeriesEntry> series;
    for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
        vtkXMLDataElement* element = collection->GetNestedElement(i);
        SeriesEntry entry;
        const char* file = element->GetAttribute("file");
        if (file == nullptr || element->GetScalarAttribute("timestep", entry.time) != 1)
            throw InputError(SourceLocation{pvd.string(), 0, 0},
                             "entry " + std::to_string(i + 1) + " has no time or no file",
                             "Run the simulation again, or restore the file.");
        entry.file = pvd.parent_path() / file;
        series.push_back(std::move(entry));
    }
    return series;
}

FrameFile read_frame(const fs::path& vtp, const std::string& group_name) {
    const VtkMessages messages;
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(vtp.c_str());
    reader->Update();
    vtkPolyData* data = reader->GetOutput();
    if (!messages.text().empty() || reader->GetErrorCode() != 0 || data->GetNumberOfPoints() == 0)
        throw InputError(
            SourceLocation{vtp.string(), 0, 0},
            "cannot be read as VTK particle data" + (messages.text().empty() ? "" : ": " + messages.text()),
            "The file is missing or damaged; run the simulation again.");
    return {to_frame(*data, group_name), text_of(*data->GetFieldData(), "title")};
}

}  // namespace dmp::postproc
