// The files of a run that get lines after each step: events.csv, --trajectory, --contacts and --hashes, as CSV (RFC 4180,
// but lines end in \n).
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

// The names as CSV fields, found by id; those of bodies that are gone too.
class BodyFields {
public:
    explicit BodyFields(const SceneWorld& world);
    const std::string& operator[](BodyId id) const { return fields_[id.index]; }

private:
    std::vector<std::string> fields_;  // by index
};

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

// Every contact point: step,body_a,body_b,feature,x,y,nx,ny,separation,normal_impulse,tangent_impulse. Gaps and places as
// the step found them, impulses of its last sub-step.
class ContactsFile {
public:
    ContactsFile(const std::filesystem::path& file, bool force, const SceneWorld& world);
    void record(const World& world);
    OutputFile& file() noexcept { return file_; }

private:
    OutputFile file_;
    BodyFields names_;
    std::string lines_;
};

// What begins and ends: step,time,event,a,b,x,y,nx,ny,speed. The events are contact_begin (with the place, the normal from
// a to b and the approach speed), contact_end, sensor_begin and sensor_end (a is the sensor), joint_broke (a is the joint's
// name or joint[i]) and fell_asleep.
class EventsFile {
public:
    EventsFile(const std::filesystem::path& file, bool force, const Scene& scene, const SceneWorld& world);
    void record(const World& world);
    OutputFile& file() noexcept { return file_; }

private:
    void add(const std::string& event, const std::string& a, const std::string& b);
    const std::string& body_of(const World& world, ShapeId shape) const;

    OutputFile file_;
    BodyFields names_;
    std::vector<std::string> joints_;         // by index
    std::vector<std::string> body_of_shape_;  // by index, as fields: shapes may be gone when their contacts end
    std::string step_;                        // the first two cells of the present step
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
