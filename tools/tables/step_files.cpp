#include "tools/tables/step_files.hpp"

#include "tools/output/json_writer.hpp"

namespace tumble::tools {

std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char character : text) {
        if (character == '"') quoted += '"';
        quoted += character;
    }
    return quoted + '"';
}

namespace {

template <class Number>
void append_cell(std::string& line, Number number) {
    line += ',';
    append_number(line, number);
}

}  // namespace

void BodyFields::update(const SceneWorld& world) {
    for (; body_count_ < world.bodies.size(); ++body_count_) {
        const SceneInstance& body = world.bodies[body_count_];
        const std::string field = csv_field(output_name(body, body_count_));
        bodies_.set(body.id, field);
        if (!world.world.is_valid(body.id)) continue;
        for (const ShapeId shape : world.world.shapes(body.id)) shapes_.set(shape, field);
    }
}

TrajectoryFile::TrajectoryFile(const std::filesystem::path& file, bool force) : file_(file, force) {
    file_.write("step,time,body,x,y,angle,vx,vy,omega\n");
}

void TrajectoryFile::record(const SceneWorld& world) {
    std::string step = std::to_string(world.world.step_count()) + ",";
    append_number(step, world.world.time());
    lines_.clear();
    names_.update(world);
    for (const SceneInstance& body : world.bodies) {
        if (!world.world.is_valid(body.id)) continue;
        const BodyState state = world.world.state(body.id);
        lines_ += step;
        lines_ += ',';
        lines_ += names_[body.id];
        for (const double number : {state.pose.position.x, state.pose.position.y, angle(state.pose.rotation)})
            append_cell(lines_, number);
        for (const float number : {state.velocity.x, state.velocity.y, state.angular_velocity})
            append_cell(lines_, number);
        lines_ += '\n';
    }
    file_.write(lines_);
}

void ContactLines::append(std::string& lines, const SceneWorld& built) {
    const World& world = built.world;
    names_.update(built);
    const std::string step = std::to_string(world.step_count()) + ",";
    for (const ContactPoint& point : world.contacts()) {
        lines += step + names_[point.body_a] + "," + names_[point.body_b] + "," + std::to_string(point.feature);
        for (const double number : {point.point.x, point.point.y}) append_cell(lines, number);
        for (const float number :
             {point.normal.x, point.normal.y, point.separation, point.normal_impulse, point.tangent_impulse})
            append_cell(lines, number);
        lines += '\n';
    }
}

ContactsFile::ContactsFile(const std::filesystem::path& file, bool force) : file_(file, force) {
    file_.write(ContactLines::kHeader);
}

void ContactsFile::record(const SceneWorld& built) {
    lines_.clear();
    contacts_.append(lines_, built);
    file_.write(lines_);
}

EventLines::EventLines(const SceneWorld& world) {
    for (std::size_t i = 0; i < world.joints.size(); ++i)
        joints_.set(world.joints[i].id, csv_field(output_name(world.joints[i], i)));
}

void EventLines::append(std::string& lines, const SceneWorld& built) {
    const World& world = built.world;
    names_.update(built);
    const StepEvents& events = world.events();
    std::string step = std::to_string(world.step_count()) + ",";
    append_number(step, world.time());
    step += ',';
    const auto add = [&](const char* event, const std::string& a, const std::string& b) {
        lines += step + event + "," + a + "," + b + ",,,,,\n";
    };
    const auto add_contact = [&](const char* event, const auto& contact) {
        lines += step + event + "," + names_[contact.shape_a] + "," + names_[contact.shape_b];
        for (const double number : {contact.point.x, contact.point.y}) append_cell(lines, number);
        for (const float number : {contact.normal.x, contact.normal.y, contact.approach_speed})
            append_cell(lines, number);
        lines += '\n';
    };
    for (const ContactBegin& begin : events.contact_begins) add_contact("contact_begin", begin);
    for (const ContactEnd& end : events.contact_ends) add("contact_end", names_[end.shape_a], names_[end.shape_b]);
    for (const ContactHit& hit : events.contact_hits) add_contact("contact_hit", hit);
    for (const SensorEvent& event : events.sensor_begins)
        add("sensor_begin", names_[event.sensor], names_[event.visitor]);
    for (const SensorEvent& event : events.sensor_ends) add("sensor_end", names_[event.sensor], names_[event.visitor]);
    for (const JointId joint : events.broken_joints) add("joint_broke", joints_[joint], "");
    for (const BodyId body : events.fell_asleep) add("fell_asleep", names_[body], "");
}

EventsFile::EventsFile(const std::filesystem::path& file, bool force, const SceneWorld& world)
    : file_(file, force), events_(world) {
    file_.write(EventLines::kHeader);
}

void EventsFile::record(const SceneWorld& built) {
    lines_.clear();
    events_.append(lines_, built);
    file_.write(lines_);
}

HashFile::HashFile(const std::filesystem::path& file, bool force) : file_(file, force) { file_.write("step,hash\n"); }

void HashFile::record(const World& world) {
    file_.write(std::to_string(world.step_count()) + "," + to_hex(world.state_hash()) + "\n");
}

}  // namespace tumble::tools
