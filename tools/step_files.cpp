#include "step_files.hpp"

#include "json_writer.hpp"

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

std::vector<std::string> body_names(const SceneWorld& world) {
    std::vector<std::string> names;
    names.reserve(world.bodies.size());
    for (const SceneInstance& body : world.bodies)
        names.push_back(body.name.empty() ? "body[" + std::to_string(names.size()) + "]" : body.name);
    return names;
}

BodyFields::BodyFields(const SceneWorld& world) {
    const std::vector<std::string> names = body_names(world);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t index = world.bodies[i].id.index;
        if (index >= fields_.size()) fields_.resize(index + 1);
        fields_[index] = csv_field(names[i]);
    }
}

TrajectoryFile::TrajectoryFile(const std::filesystem::path& file, bool force, const SceneWorld& world)
    : file_(open_output(file, force)), names_(body_names(world)) {
    for (std::string& name : names_) name = csv_field(name);
    file_.write("step,time,body,x,y,angle,vx,vy,omega\n");
}

void TrajectoryFile::record(const SceneWorld& world) {
    const double time = static_cast<double>(world.world.step_count()) / world.world.def().steps_per_second;
    std::string step = std::to_string(world.world.step_count()) + ",";
    append_number(step, time);
    lines_.clear();
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
        const BodyState state = world.world.state(world.bodies[i].id);
        lines_ += step;
        lines_ += ',';
        lines_ += names_[i];
        for (const double number : {state.pose.position.x, state.pose.position.y, angle(state.pose.rotation)})
            append_cell(lines_, number);
        for (const float number : {state.velocity.x, state.velocity.y, state.angular_velocity})
            append_cell(lines_, number);
        lines_ += '\n';
    }
    file_.write(lines_);
}

ContactsFile::ContactsFile(const std::filesystem::path& file, bool force, const SceneWorld& world)
    : file_(open_output(file, force)), names_(world) {
    file_.write("step,body_a,body_b,feature,x,y,nx,ny,separation,normal_impulse,tangent_impulse\n");
}

void ContactsFile::record(const World& world) {
    const std::string step = std::to_string(world.step_count()) + ",";
    lines_.clear();
    for (const ContactPoint& point : world.contacts()) {
        lines_ += step + names_[point.body_a] + "," + names_[point.body_b] + "," + std::to_string(point.feature);
        for (const double number : {point.point.x, point.point.y}) append_cell(lines_, number);
        for (const float number : {point.normal.x, point.normal.y, point.separation, point.normal_impulse,
                                   point.tangent_impulse})
            append_cell(lines_, number);
        lines_ += '\n';
    }
    file_.write(lines_);
}

EventsFile::EventsFile(const std::filesystem::path& file, bool force, const Scene& scene, const SceneWorld& world)
    : file_(open_output(file, force)), names_(world) {
    file_.write("step,time,event,a,b,x,y,nx,ny,speed\n");
    for (std::size_t i = 0; i < world.joints.size(); ++i) {
        const std::size_t index = world.joints[i].index;
        if (index >= joints_.size()) joints_.resize(index + 1);
        const std::string& name = scene.joints[i].name;
        joints_[index] = csv_field(name.empty() ? "joint[" + std::to_string(i) + "]" : name);
    }
    for (const SceneInstance& body : world.bodies)
        for (const ShapeId shape : world.world.shapes(body.id)) {
            if (shape.index >= body_of_shape_.size()) body_of_shape_.resize(shape.index + 1);
            body_of_shape_[shape.index] = names_[body.id];
        }
}

const std::string& EventsFile::body_of(const World& world, ShapeId shape) const {
    return world.is_valid(shape) ? names_[world.body(shape)] : body_of_shape_[shape.index];
}

void EventsFile::add(const std::string& event, const std::string& a, const std::string& b) {
    lines_ += step_ + event + "," + a + "," + b + ",,,,,\n";
}

void EventsFile::record(const World& world) {
    const StepEvents& events = world.events();
    step_ = std::to_string(world.step_count()) + ",";
    append_number(step_, static_cast<double>(world.step_count()) / world.def().steps_per_second);
    step_ += ',';
    lines_.clear();
    for (const ContactBegin& begin : events.contact_begins) {
        lines_ += step_ + "contact_begin," + body_of(world, begin.shape_a) + "," + body_of(world, begin.shape_b);
        for (const double number : {begin.point.x, begin.point.y}) append_cell(lines_, number);
        for (const float number : {begin.normal.x, begin.normal.y, begin.approach_speed}) append_cell(lines_, number);
        lines_ += '\n';
    }
    for (const ContactEnd& end : events.contact_ends)
        add("contact_end", body_of(world, end.shape_a), body_of(world, end.shape_b));
    for (const SensorEvent& event : events.sensor_begins)
        add("sensor_begin", body_of(world, event.sensor), body_of(world, event.visitor));
    for (const SensorEvent& event : events.sensor_ends)
        add("sensor_end", body_of(world, event.sensor), body_of(world, event.visitor));
    for (const JointId joint : events.broken_joints) add("joint_broke", joints_[joint.index], "");
    for (const BodyId body : events.fell_asleep) add("fell_asleep", names_[body], "");
    file_.write(lines_);
}

HashFile::HashFile(const std::filesystem::path& file, bool force) : file_(open_output(file, force)) {
    file_.write("step,hash\n");
}

void HashFile::record(const World& world) {
    file_.write(std::to_string(world.step_count()) + "," + to_hex(world.state_hash()) + "\n");
}

}  // namespace tumble::tools
