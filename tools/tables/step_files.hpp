// The files of a run to which each step appends lines: events.csv, --trajectory, --contacts and --hashes. They are CSV
// as in RFC 4180, except that lines end in \n.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/tables/table_file.hpp"
#include "tumble/scene_world.hpp"

namespace tumble::tools {

// The text as a CSV field: quoted if it contains a comma, a quote or a line break.
std::string csv_field(std::string_view text);

// Texts by id. The text of a stale id is kept until its index is reused for the second time.
template <class Id>
class TextsById {
public:
    void set(Id id, std::string text) {
        if (id.index >= slots_.size()) slots_.resize(id.index + 1);
        Slot& slot = slots_[id.index];
        slot.previous_text = std::exchange(slot.text, std::move(text));
        slot.id = id;
    }
    const std::string& operator[](Id id) const {
        const Slot& slot = slots_[id.index];
        return slot.id == id ? slot.text : slot.previous_text;
    }

private:
    struct Slot {
        Id id;
        std::string text, previous_text;
    };
    std::vector<Slot> slots_;  // by index
};

// The names of bodies as CSV fields, by body or shape, including bodies that have been destroyed.
class BodyFields {
public:
    // Adds the bodies that were created since the last call.
    void update(const SceneWorld& world);

    const std::string& operator[](BodyId id) const { return bodies_[id]; }
    const std::string& operator[](ShapeId id) const { return shapes_[id]; }

private:
    TextsById<BodyId> bodies_;
    TextsById<ShapeId> shapes_;   // of the body that has the shape
    std::size_t body_count_ = 0;  // of world.bodies, added so far
};

// Pose and velocity of every body: step,time,body,x,y,angle,vx,vy,omega.
class TrajectoryFile {
public:
    TrajectoryFile(const std::filesystem::path& file, bool force);
    void record(const SceneWorld& world);
    TableFile& file() noexcept { return file_; }

private:
    TableFile file_;
    BodyFields names_;
    std::string lines_;
};

// Every contact point: step,body_a,body_b,feature,x,y,nx,ny,separation,normal_impulse,tangent_impulse. Separations and
// normals are those at the start of the step, points move with body_a to the end of the step, impulses are summed over
// the step.
class ContactLines {
public:
    static constexpr std::string_view kHeader =
        "step,body_a,body_b,feature,x,y,nx,ny,separation,normal_impulse,tangent_impulse\n";

    // Appends the lines of the last step.
    void append(std::string& lines, const SceneWorld& world);

private:
    BodyFields names_;
};

class ContactsFile {
public:
    ContactsFile(const std::filesystem::path& file, bool force);
    void record(const SceneWorld& world);
    TableFile& file() noexcept { return file_; }

private:
    TableFile file_;
    ContactLines contacts_;
    std::string lines_;
};

// Events: step,time,event,a,b,x,y,nx,ny,speed. The events are contact_begin and contact_hit (with the
// point, the normal from a to b and the approach speed), contact_end, sensor_begin and sensor_end (a is the sensor),
// joint_broke (a is the joint's name or joint[i]) and fell_asleep.
class EventLines {
public:
    static constexpr std::string_view kHeader = "step,time,event,a,b,x,y,nx,ny,speed\n";

    // `world` is that at the start of the run.
    explicit EventLines(const SceneWorld& world);

    // Appends the lines of the last step.
    void append(std::string& lines, const SceneWorld& world);

private:
    BodyFields names_;
    TextsById<JointId> joints_;
};

class EventsFile {
public:
    EventsFile(const std::filesystem::path& file, bool force, const SceneWorld& world);
    void record(const SceneWorld& world);
    TableFile& file() noexcept { return file_; }

private:
    TableFile file_;
    EventLines events_;
    std::string lines_;
};

// The state hash: step,hash.
class HashFile {
public:
    HashFile(const std::filesystem::path& file, bool force);
    void record(const World& world);
    TableFile& file() noexcept { return file_; }

private:
    TableFile file_;
};

}  // namespace tumble::tools
