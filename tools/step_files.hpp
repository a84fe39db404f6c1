// The files of a run that get lines after each step: --trajectory and --hashes, as CSV (RFC 4180, but lines end in \n).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "output_path.hpp"
#include "tumble/scene.hpp"

namespace tumble::tools {

// The field as CSV has it: quoted if it holds a comma, a quote or a line break.
std::string csv_field(std::string_view text);

// The name of each body in output, in id order: its own, or body[i].
std::vector<std::string> body_names(const SceneWorld& world);

// Pose and velocity of every body: step,time,body,x,y,angle,vx,vy,omega.
class TrajectoryFile {
public:
    TrajectoryFile(const std::filesystem::path& file, bool force, const SceneWorld& world);
    void record(const SceneWorld& world);
    OutputFile& file() noexcept { return file_; }

private:
    OutputFile file_;
    std::vector<std::string> names_;  // [world.bodies.size()], as fields
    std::string lines_;
};

// The state hash: step,hash.
class HashFile {
public:
    HashFile(const std::filesystem::path& file, bool force);
    void record(const World& world);
    OutputFile& file() noexcept { return file_; }

private:
    OutputFile file_;
};

}  // namespace tumble::tools
