// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "postproc/vtk_messages.hpp"

#include <string>

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace dmp::postproc {

namespace {

/// VTK's output "window": keeps errors and warnings, discards debug messages.
class KeepingWindow : public vtkOutputWindow {
  public:
    vtkTypeMacro(KeepingWindow, vtkOutputWindow) static KeepingWindow* New();

    void DisplayText(const char* text) override { keep(text); }
    void DisplayErrorText(const char* text) override { keep(text); }
    void DisplayWarningText(const char* text) override { keep(text); }
    void DisplayGenericWarningText(const char* text) override { keep(text); }
    void DisplayDebugText(const char* /*text*/) override {}

    [[nodiscard]] const std::string& kept() const { return kept_; }

  private:
    /// "ERROR: In file.cxx, line 12\nvtkClass (0x55..): words\n\n" -> "words"
    void keep(const char* text) {
        std::string words = text;
        if (const auto address = words.find("): "); address != std::string::npos) words.erase(0, address + 3);
        while (!words.empty() && (words.back() == '\n' || words.back() == ' ')) words.pop_back();
        if (words.empty()) return;
        if (!kept_.empty()) kept_ += '\n';
        kept_ += words;
    }

    std::string kept_;
};

vtkStandardNewMacro(KeepingWindow)

}  // namespace

struct VtkMessages::Keeper {
    vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
    vtkNew<KeepingWindow> window;
};

VtkMessages::VtkMessages() : keeper_(std::make_unique<Keeper>()) {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);  // VTK's second way to print to the terminal; stays off
    vtkOutputWindow::SetInstance(keeper_->window);
}

VtkMessages::~VtkMessages() { vtkOutputWindow::SetInstance(keeper_->before); }

std::string VtkMessages::text() const { return keeper_->window->kept(); }

}  // namespace dmp::postproc
