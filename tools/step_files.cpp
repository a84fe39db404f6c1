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

std::vector<std::string> body_names(const SceneWorld& world) {
    std::vector<std::string> names;
    names.reserve(world.bodies.size());
    for (const SceneInstance& body : world.bodies)
        names.push_back(body.name.empty() ? "body[" + std::to_string(names.size()) + "]" : body.name);
    return names;
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
        for (const double number : {state.pose.position.x, state.pose.position.y, angle(state.pose.rotation)}) {
            lines_ += ',';
            append_number(lines_, number);
        }
        for (const float number : {state.velocity.x, state.velocity.y, state.angular_velocity}) {
            lines_ += ',';
            append_number(lines_, number);
        }
        lines_ += '\n';
    }
    file_.write(lines_);
}

HashFile::HashFile(const std::filesystem::path& file, bool force) : file_(open_output(file, force)) {
    file_.write("step,hash\n");
}

void HashFile::record(const World& world) {
    file_.write(std::to_string(world.step_count()) + "," + to_hex(world.state_hash()) + "\n");
}

}  // namespace tumble::tools
