// One run of a sweep: its simulation, its line of the table, and the data that the plan asks for.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sweep/plan/plan.hpp"
#include "sweep/store/trajectory_array.hpp"
#include "tools/sweep/runs/frame_recorder.hpp"
#include "tools/sweep/runs/scene_texts.hpp"
#include "tumble/scene_file.hpp"

namespace tumble::tools {

struct RunRecord {
    std::uint64_t run = 0;
    // "ok"; "filtered": the filter drops its data; "diverged", "timed_out", "invalid", "failed", "crashed": it has no
    // end state.
    std::string outcome;
    std::string message{};                                       // why it has no end state
    std::string row{};                                           // its line of the table
    std::vector<std::pair<std::string, std::string>> members{};  // of the tar file: suffix and bytes
    sweep::TrajectoryArray trajectory{};                         // for the HDF5 file
    bool is_stopped = false;                                     // by an event of the scene
    std::uint64_t steps = 0;
};

// Thrown after SIGINT, SIGHUP or SIGTERM.
struct Interrupted {};

// Makes runs one after the other on one thread, which keeps what all of them need.
class RunMaker {
public:
    // The plan and the texts must outlive the object. Throws RenderError if the plan writes frames, and there is no
    // off-screen OpenGL.
    RunMaker(const sweep::Plan& plan, SceneTexts& texts);

    // The bytes of the record depend on the plan and the run alone, except for `timed_out` and `failed`. A run that
    // diverges, takes too long, has a scene or an image that is not valid, or finds no memory is recorded as such.
    // Throws FileError, RenderError and Interrupted.
    RunRecord make(std::uint64_t run);

    // The record of a run that ends its process by a signal, without simulating it.
    RunRecord record_crash(std::uint64_t run, const std::string& signal) const;

private:
    Scene load(const sweep::RunChoice& choice);
    void read_images(const Scene& scene);  // which copies them into the folder of the sweep, as the scene files

    const sweep::Plan& plan_;
    SceneTexts& texts_;
    std::map<std::size_t, SceneSource> sources_;  // of the scenes that have been simulated
    std::optional<FrameRecorder> pictures_;
};

}  // namespace tumble::tools
