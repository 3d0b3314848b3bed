// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/safe_file.hpp"
#include "report/run_files.hpp"
#include "tests/modules.hpp"
#include "tests/unit/report/made_frames.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests {

/// A PNG file of this size, as far as anybody looks.
inline std::string png_file(unsigned char width = 7, unsigned char height = 5, std::size_t more = 0) {
    std::string bytes("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0", 19);
    bytes += static_cast<char>(width);
    bytes += std::string(3, '\0') + static_cast<char>(height);
    return bytes + std::string(9 + more, '\1') + "IEND";
}

/// The folder of a run in which everything has a mark-up character in it.
class RunFolder {
  public:
    RunFolder() {
        make_folder(path());
        write("summary.json", R"json({
  "title": "Valve <script>alert('title')</script>", "version": "0.1.0", "scene_hash": "0123456789abcdef",
  "interrupted": false, "warnings": ["too <fast> at the end"],
  "particles": {"fluid": 100, "elastic": 8}, "steps": 400, "simulated_s": 0.5, "wall_s": 10.0,
  "particle_steps_per_s": 4000.0, "threads": 2, "ranks": 1, "vector_unit": "avx2",
  "dt_limits": {"sound": 0.001, "viscosity": 0.5}, "dt_formulas": {"sound": "a < b", "viscosity": "c"},
  "ruling_limit": "sound", "sound_speed": 3.0, "largest_speed": 0.25, "density_low": 999.0, "density_high": null,
  "density_drift": 0.001, "lost": 0,
  "conserved": {"start": {"mass": 2.0, "momentum": [0, 0, 0]}, "end": {"mass": 2.0, "momentum": [1.5, 0, 0]},
    "impulse_of_body_forces": [2.5, 0, 0], "impulse_of_fixed": [-1, 0, 0], "impulse_of_drag": [0, 0, 0],
    "momentum_residual": 1e-15},
  "species": {"drug": {"unit": "mol", "start": 4.0, "end": 3.0, "from_walls": 0.5, "taken_up": 1.5, "residual": 1e-14}},
  "energy": {"start": {"translation": 1.0, "rotation": 0.5, "contacts": 0.0},
    "end": {"translation": 0.25, "rotation": 0.5, "contacts": 0.125}},
  "measures": {"flux": {"unit": "m^3/s", "last": 2.0, "min": 1.0, "max": 2.0, "mean": 1.5, "missing": 0}},
  "state_hash": "fedcba9876543210", "seconds_by_stage": {"kick": 2.0, "forces": 7.0},
  "chosen": [{"name": "walls", "value": "extrapolated <numerics.walls>"}, {"name": "", "value": "and more"}],
  "models": [{"model": "Tait", "source": "Tait (1888)", "why": "default"}],
  "files": ["fluid.pvd", "last_frame.png", "measures.png", "../secret.png", "measures.csv"]
})json");
        write("measures.csv", "time [s],flux [m^3/s]\n0,1\n0.5,2\n");
        write("run.log",
              "2026-11-26 23:34:03 UTC  dmp 0.1.0\ndmp run valve --set 'a=<b>'\n\nwarning: leaflets: EA <lowered>\n"
              "warning at 0.1 s: too <fast>\nDone\n"
              "2026-11-27 08:00:00 UTC  dmp 0.1.1\ndmp run valve --resume\n\nwarning: leaflets: EA <lowered>\n");
        write("scene.resolved.toml", "title = \"</code><script>alert('scene')</script>\"\n");
        write("fluid.pvd", "<Collection>\n<DataSet a/>\n<DataSet b/>\n</Collection>\n");
        write("last_frame.png", png_file());
        write("measures.png", png_file());
        write_file(folder_.path() / "secret.png", png_file());
    }

    void write(const std::string& name, const std::string& text) const { write_file(path() / name, text); }
    void remove(const std::string& name) const { std::filesystem::remove(path() / name); }
    [[nodiscard]] std::filesystem::path path() const { return folder_.path() / "out"; }
    [[nodiscard]] RunFiles read() const { return read_run_files(path(), made_frames); }
    /// In place of ParaView's.
    [[nodiscard]] static std::unique_ptr<FrameSource> made_frames(const std::filesystem::path& /*folder*/) {
        return std::make_unique<MadeFrames>(two_frames());
    }

  private:
    TemporaryFolder folder_;
};

}  // namespace dmp::tests
