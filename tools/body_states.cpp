#define CSV_IO_NO_THREAD
#include "body_states.hpp"

#include <libfccp/csv.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>
#include <tuple>
#include <utility>

#include "input_error.hpp"
#include "json_writer.hpp"
#include "step_files.hpp"
#include "tumble/file.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

namespace {

template <unsigned Columns>
using Csv = io::CSVReader<Columns, io::trim_chars<>, io::double_quote_escape<',', '"'>>;

// What the reader throws ends as our kind of error, with file and line.
template <class Action>
auto with_input_errors(Action action) {
    try {
        return action();
    } catch (const io::error::base& error) {
        throw InputError(error.what());
    }
}

// A CSV file whose header is known.
template <unsigned Columns>
class CsvFile {
public:
    template <class... Names>
    CsvFile(const std::filesystem::path& file, Names... names) : name_(file.string()), stream_(opened(file)), csv_(name_, stream_) {
        with_input_errors([&] { csv_.read_header(io::ignore_no_column, names...); });
    }

    // The fields of the next line, which hold until the one after it; false at the end.
    bool read(std::array<char*, Columns>& fields) {
        const auto read_row = [this](auto&... field) { return csv_.read_row(field...); };
        return with_input_errors([&] { return std::apply(read_row, fields); });
    }

    template <class Number>
    Number number(const char* text) const {
        Number value{};
        const char* const end = text + std::strlen(text);
        const auto [stop, error] = std::from_chars(text, end, value);
        if (error == std::errc() && stop == end) return value;
        throw InputError(name_ + ":" + std::to_string(csv_.get_file_line()) + ": expected a number, got '" + text + "'");
    }

private:
    static std::ifstream opened(const std::filesystem::path& file) {
        std::ifstream stream(file);
        if (!stream) throw FileError(file, std::strerror(errno));
        return stream;
    }

    std::string name_;
    std::ifstream stream_;
    Csv<Columns> csv_;
};

// The contacts of one step after the other, as --contacts writes them.
class ContactFile {
public:
    explicit ContactFile(const std::filesystem::path& file)
        : csv_(file, "step", "body_a", "body_b", "feature", "x", "y", "nx", "ny", "separation", "normal_impulse",
               "tangent_impulse") {}

    std::vector<std::string> contacts_of(const std::string& body, std::uint64_t step) {
        while (!at_end_ && (!held_ || held_->step < step)) read();
        for (lines_.clear(); held_ && held_->step == step; read()) lines_.push_back(*held_);
        std::vector<std::string> found;
        for (const Line& line : lines_)
            if (line.body_a == body || line.body_b == body) found.push_back(line.text);
        return found;
    }

private:
    struct Line {
        std::uint64_t step = 0;
        std::string body_a, body_b, text;
    };

    void read() {
        std::array<char*, 11> fields{};
        held_.reset();
        at_end_ = !csv_.read(fields);
        if (at_end_) return;
        const auto& [step, a, b, feature, x, y, nx, ny, separation, normal_impulse, tangent_impulse] = fields;
        held_ = Line{csv_.number<std::uint64_t>(step), a, b,
                     std::string(a) + " and " + b + " at [" + x + ", " + y + "], normal [" + nx + ", " + ny + "], separation " +
                         separation + " m, impulse " + normal_impulse + " N s"};
    }

    CsvFile<11> csv_;
    std::optional<Line> held_;
    std::vector<Line> lines_;
    bool at_end_ = false;
};

class TrajectoryStates final : public StateSource {
public:
    explicit TrajectoryStates(const std::filesystem::path& file)
        : csv_(file, "step", "time", "body", "x", "y", "angle", "vx", "vy", "omega") {
        const std::filesystem::path contacts = file.parent_path() / "contacts.csv";
        if (std::filesystem::exists(contacts)) contacts_.emplace(contacts);
        read();
    }

    bool next(StepStates& states) override {
        if (at_end_) return false;
        states.bodies.clear();
        states.step = step_ = held_step_;
        states.time = held_time_;
        while (!at_end_ && held_step_ == step_) {
            states.bodies.push_back(held_);
            read();
        }
        return true;
    }

    std::vector<std::string> contacts_of(const std::string& body) const override {
        return contacts_ ? contacts_->contacts_of(body, step_) : std::vector<std::string>{};
    }

private:
    void read() {
        std::array<char*, 9> fields{};
        at_end_ = !csv_.read(fields);
        if (at_end_) return;
        held_step_ = csv_.number<std::uint64_t>(fields[0]);
        held_time_ = csv_.number<double>(fields[1]);
        held_.body = fields[2];
        for (std::size_t i = 0; i < kComponents.size(); ++i) {
            const char* const text = fields[3 + i];
            held_.values[i] = i < kDoubleComponents ? csv_.number<double>(text) : double{csv_.number<float>(text)};
        }
    }

    CsvFile<9> csv_;
    mutable std::optional<ContactFile> contacts_;
    std::uint64_t step_ = 0, held_step_ = 0;  // `held` is the first body of the step after the one that was read last
    double held_time_ = 0.0;
    NamedState held_;
    bool at_end_ = false;
};

// A scene that runs while it is read.
class RunningStates final : public StateSource {
public:
    explicit RunningStates(const std::filesystem::path& file)
        : scene_(load_scene(file)), run_(scene_),
          last_step_(static_cast<std::uint64_t>(std::llround(scene_.world.duration * scene_.world.steps_per_second))) {}

    bool next(StepStates& states) override {
        if (started_ && run_.world().step_count() >= last_step_) return false;
        if (started_) run_.step();
        started_ = true;
        states.step = run_.world().step_count();
        states.time = run_.time();
        states.bodies.clear();
        names_ = body_names(run_.built());
        for (std::size_t i = 0; i < names_.size(); ++i) {
            if (!run_.world().is_valid(run_.built().bodies[i].id)) continue;
            const BodyState state = run_.world().state(run_.built().bodies[i].id);
            const DVec2 position = state.pose.position;
            states.bodies.push_back({names_[i], {position.x, position.y, angle(state.pose.rotation), double{state.velocity.x},
                                                 double{state.velocity.y}, double{state.angular_velocity}}});
        }
        return true;
    }

    std::vector<std::string> contacts_of(const std::string& body) const override {
        std::vector<std::string> found;
        for (const ContactPoint& contact : run_.world().contacts()) {
            const std::string& a = name_of(contact.body_a);
            const std::string& b = name_of(contact.body_b);
            if (a == body || b == body) found.push_back(text_of(contact, a, b));
        }
        return found;
    }

private:
    const std::string& name_of(BodyId id) const {
        const auto& bodies = run_.built().bodies;
        return names_[static_cast<std::size_t>(std::ranges::find(bodies, id, &SceneInstance::id) - bodies.begin())];
    }

    static std::string text_of(const ContactPoint& contact, const std::string& a, const std::string& b) {
        std::string text = a + " and " + b + " at [";
        append_number(text, contact.point.x);
        append_number(text += ", ", contact.point.y);
        append_number(text += "], normal [", contact.normal.x);
        append_number(text += ", ", contact.normal.y);
        append_number(text += "], separation ", contact.separation);
        append_number(text += " m, impulse ", contact.normal_impulse);
        return text + " N s";
    }

    Scene scene_;
    SceneRun run_;
    std::vector<std::string> names_;
    std::uint64_t last_step_ = 0;
    bool started_ = false;
};

}  // namespace

std::unique_ptr<StateSource> open_states(const std::filesystem::path& path) {
    if (std::filesystem::is_directory(path)) {
        const std::filesystem::path trajectory = path / "trajectory.csv";
        if (!std::filesystem::exists(trajectory))
            throw InputError(path.string() + ": holds no trajectory.csv; run the scene with --trajectory " + trajectory.string());
        return std::make_unique<TrajectoryStates>(trajectory);
    }
    if (path.extension() == ".csv") return std::make_unique<TrajectoryStates>(path);
    return std::make_unique<RunningStates>(path);
}

}  // namespace tumble::tools
