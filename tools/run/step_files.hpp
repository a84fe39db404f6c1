// The files of a run that get lines after each step: events.csv, --trajectory, --contacts and --hashes, as CSV (RFC
// 4180, but lines end in \n).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/cli/output_path.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::tools {

// The field as CSV has it: quoted if it holds a comma, a quote or a line break.
std::string csv_field(std::string_view text);

// Texts by id; of an id that is stale by now too, until its place has been taken twice.
template <class Id>
class TextsById {
public:
    void set(Id id, std::string text) {
        if (id.index >= places_.size()) places_.resize(id.index + 1);
        Place& place = places_[id.index];
        place.before = std::exchange(place.text, std::move(text));
        place.id = id;
    }
    const std::string& operator[](Id id) const {
        const Place& place = places_[id.index];
        return place.id == id ? place.text : place.before;
    }

private:
    struct Place {
        Id id;
        std::string text, before;
    };
    std::vector<Place> places_;  // by index
};

// The names of bodies as CSV fields, found by body or shape; those of bodies that are gone too.
class BodyFields {
public:
    // Takes note of the bodies that came since the last call.
    void update(const SceneWorld& world);

    const std::string& operator[](BodyId id) const { return bodies_[id]; }
    const std::string& operator[](ShapeId id) const { return shapes_[id]; }

private:
    TextsById<BodyId> bodies_;
    TextsById<ShapeId> shapes_;  // of the body that has the shape
    std::size_t known_ = 0;      // of world.bodies
};

// Pose and velocity of every body: step,time,body,x,y,angle,vx,vy,omega.
class TrajectoryFile {
public:
    TrajectoryFile(const std::filesystem::path& file, bool force);
    void record(const SceneWorld& world);
    OutputFile& file() noexcept { return file_; }

private:
    OutputFile file_;
    BodyFields names_;
    std::string lines_;
};

// Every contact point: step,body_a,body_b,feature,x,y,nx,ny,separation,normal_impulse,tangent_impulse. Gaps and normals
// as the step found them, points carried along with the first body, impulses summed over the step.
class ContactsFile {
public:
    ContactsFile(const std::filesystem::path& file, bool force);
    void record(const SceneWorld& world);
    OutputFile& file() noexcept { return file_; }

private:
    OutputFile file_;
    BodyFields names_;
    std::string lines_;
};

// What begins and ends: step,time,event,a,b,x,y,nx,ny,speed. The events are contact_begin and contact_hit (with the
// place, the normal from a to b and the approach speed), contact_end, sensor_begin and sensor_end (a is the sensor),
// joint_broke (a is the joint's name or joint[i]) and fell_asleep.
class EventsFile {
public:
    EventsFile(const std::filesystem::path& file, bool force, const SceneWorld& world);
    void record(const SceneWorld& world);
    OutputFile& file() noexcept { return file_; }

private:
    void add(const std::string& event, const std::string& a, const std::string& b);

    OutputFile file_;
    BodyFields names_;
    TextsById<JointId> joints_;
    std::string step_;  // the first two cells of the present step
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
