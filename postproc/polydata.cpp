// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/polydata.hpp"

#include <algorithm>
#include <stdexcept>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>

#include "postproc/uses.hpp"
#include "solver/results/frame_check.hpp"

namespace dmp::postproc {

namespace {

constexpr const char* units_prefix = "units:";

template <class VtkArray, class T>
vtkSmartPointer<VtkArray> named_array(const std::string& name, int components, const std::vector<T>& values) {
    auto array = vtkSmartPointer<VtkArray>::New();
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    // Component names and order of symmetric tensors as in ParaView.
    const std::vector<const char*> axes{"x", "y", "z"}, pairs{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
    if (components == 3 || components == 6)
        for (int c = 0; c < components; ++c) array->SetComponentName(c, (components == 3 ? axes : pairs)[c]);
    return array;
}

vtkSmartPointer<vtkStringArray> named_strings(const std::string& name, const std::vector<std::string>& values) {
    auto array = vtkSmartPointer<vtkStringArray>::New();
    array->SetName(name.c_str());
    for (const std::string& value : values) array->InsertNextValue(value);
    return array;
}

/// Cells of `corners` points each, with 32-bit numbers, which halves the size.
vtkSmartPointer<vtkCellArray> cells(const std::vector<std::int32_t>& points, int corners) {
    auto array = vtkSmartPointer<vtkCellArray>::New();
    array->SetData(corners, named_array<vtkTypeInt32Array>("connectivity", 1, points));
    return array;
}

bool bonded(const FrameGroup& group) {
    return group.name == "solid" || group.bonds() > 0 || !group.bond_fields.empty();
}

void add_bond_fields(vtkCellData& cell_data, const FrameGroup& group) {
    std::vector<std::int32_t> is_bond(group.size(), 0);
    is_bond.resize(group.size() + group.bonds(), 1);
    cell_data.AddArray(named_array<vtkTypeInt32Array>("is_bond", 1, is_bond));
    for (const FrameField& field : group.bond_fields) {
        std::vector<float> values(group.size() * static_cast<std::size_t>(field.components), 0.0F);
        values.insert(values.end(), field.values.begin(), field.values.end());
        cell_data.AddArray(named_array<vtkFloatArray>(field.name, field.components, values));
    }
}

void add_label(vtkFieldData& field_data, const Frame& frame, const FrameGroup& group, const RunLabel& label) {
    field_data.AddArray(named_array<vtkDoubleArray>("TimeValue", 1, std::vector<double>{frame.time}));
    field_data.AddArray(named_array<vtkTypeInt64Array>("Step", 1, std::vector<std::int64_t>{frame.step}));
    field_data.AddArray(named_array<vtkDoubleArray>("spacing", 1, std::vector<double>{frame.spacing}));
    field_data.AddArray(named_strings("part_names", frame.parts));
    field_data.AddArray(named_strings("title", {label.title}));
    field_data.AddArray(named_strings("scene_hash", {label.scene_hash}));
    field_data.AddArray(named_strings("dmp_version", {label.version}));
    const auto add_unit = [&](const std::string& name, const std::string& unit) {
        field_data.AddArray(named_strings(units_prefix + name, {unit}));
    };
    add_unit("TimeValue", "s");
    add_unit("position", "m");
    add_unit("spacing", "m");
    for (const FrameField& field : group.fields) add_unit(field.name, field.unit);
    for (const FrameField& field : group.bond_fields) add_unit(field.name, field.unit);
}

double number(vtkFieldData& field_data, const char* name) {
    vtkDataArray* array = field_data.GetArray(name);
    return array != nullptr && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : 0.0;
}

template <class T>
std::vector<T> values_of(vtkDataArray* array) {
    if (array == nullptr) return {};
    std::vector<T> values;
    values.reserve(static_cast<std::size_t>(array->GetNumberOfValues()));
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
        for (int component = 0; component < array->GetNumberOfComponents(); ++component)
            values.push_back(static_cast<T>(array->GetComponent(i, component)));
    return values;
}

/// The float arrays are the fields; id, part and is_bond are integers.
std::vector<FrameField> fields_of(vtkFieldData& arrays, vtkFieldData& label, vtkIdType skipped_tuples) {
    std::vector<FrameField> fields;
    for (int i = 0; i < arrays.GetNumberOfArrays(); ++i) {
        vtkDataArray* array = arrays.GetArray(i);
        if (array == nullptr || array->GetDataType() != VTK_FLOAT) continue;
        FrameField field{array->GetName(), "", array->GetNumberOfComponents(), values_of<float>(array)};
        field.values.erase(field.values.begin(), field.values.begin() + skipped_tuples * field.components);
        field.unit = text_of(label, units_prefix + field.name);
        fields.push_back(std::move(field));
    }
    return fields;
}

}  // namespace

std::string text_of(vtkFieldData& field_data, const std::string& name) {
    auto* array = vtkStringArray::SafeDownCast(field_data.GetAbstractArray(name.c_str()));
    return array != nullptr && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : std::string();
}

vtkSmartPointer<vtkPolyData> to_polydata(const Frame& frame, const FrameGroup& group, const RunLabel& label) {
    if (const std::string problem = problem_with(group); !problem.empty()) throw std::invalid_argument(problem);
    auto data = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetData(named_array<vtkFloatArray>("position", 3, group.position));
    data->SetPoints(points);

    std::vector<std::int32_t> vertices(group.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = static_cast<std::int32_t>(i);
    data->SetVerts(cells(vertices, 1));
    if (group.bonds() > 0) data->SetLines(cells(group.bond_ends, 2));
    if (!group.triangles.empty()) data->SetPolys(cells(group.triangles, 3));

    data->GetPointData()->AddArray(named_array<vtkTypeInt64Array>("id", 1, group.id));
    data->GetPointData()->AddArray(named_array<vtkTypeInt32Array>("part", 1, group.part));
    for (const FrameField& field : group.fields)
        data->GetPointData()->AddArray(named_array<vtkFloatArray>(field.name, field.components, field.values));
    if (bonded(group)) add_bond_fields(*data->GetCellData(), group);
    add_label(*data->GetFieldData(), frame, group, label);
    return data;
}

Frame to_frame(vtkPolyData& data, const std::string& group_name) {
    vtkFieldData& label = *data.GetFieldData();
    Frame frame;
    frame.time = number(label, "TimeValue");
    frame.step = static_cast<long>(number(label, "Step"));
    frame.spacing = number(label, "spacing");
    if (auto* names = vtkStringArray::SafeDownCast(label.GetAbstractArray("part_names")))
        for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i) frame.parts.push_back(names->GetValue(i));

    FrameGroup group;
    group.name = group_name;
    if (data.GetPoints() != nullptr) group.position = values_of<float>(data.GetPoints()->GetData());
    group.id = values_of<std::int64_t>(data.GetPointData()->GetArray("id"));
    group.part = values_of<std::int32_t>(data.GetPointData()->GetArray("part"));
    group.fields = fields_of(*data.GetPointData(), label, 0);
    if (data.GetNumberOfLines() > 0) group.bond_ends = values_of<std::int32_t>(data.GetLines()->GetConnectivityArray());
    if (data.GetNumberOfPolys() > 0) group.triangles = values_of<std::int32_t>(data.GetPolys()->GetConnectivityArray());
    group.bond_fields = fields_of(*data.GetCellData(), label, data.GetNumberOfVerts());
    frame.groups.push_back(std::move(group));
    return frame;
}

}  // namespace dmp::postproc
