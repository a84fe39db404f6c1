#include "tools/diff/body_states.hpp"

#include <optional>

#include "tools/diff/scene_states.hpp"
#include "tools/output/csv_file.hpp"
#include "tools/output/standard_input.hpp"
#include "tumble/scene_file.hpp"
#include "tumble/scene_run.hpp"

namespace tumble::tools {

namespace {

// The contacts of a run, step by step, from a file that `run --contacts` wrote.
class ContactFile {
public:
    explicit ContactFile(const std::filesystem::path& file)
        : csv_(file, "step", "body_a", "body_b", "feature", "x", "y", "nx", "ny", "separation", "normal_impulse",
               "tangent_impulse") {}

    std::vector<std::string> contacts_of(const std::string& body, std::uint64_t step) {
        while (!at_end_ && (!next_line_ || next_line_->step < step)) read();
        for (lines_.clear(); next_line_ && next_line_->step == step; read()) lines_.push_back(*next_line_);
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
        next_line_.reset();
        at_end_ = !csv_.read(fields);
        if (at_end_) return;
        const auto& [step, a, b, feature, x, y, nx, ny, separation, normal_impulse, tangent_impulse] = fields;
        next_line_ = Line{csv_.number<std::uint64_t>(step), a, b,
                          contact_text(a, b, {x, y, nx, ny, separation, normal_impulse})};
    }

    CsvFile<11> csv_;
    std::optional<Line> next_line_;
    std::vector<Line> lines_;  // of the last step
    bool at_end_ = false;
};

// Whether the text is "body[" and digits and "]", the output name of a body without a name.
bool is_automatic(std::string_view name) {
    constexpr std::string_view kStart = "body[";
    if (!name.starts_with(kStart) || !name.ends_with(']')) return false;
    const std::string_view digits = name.substr(kStart.size(), name.size() - kStart.size() - 1);
    return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
}

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
        states.step = step_ = next_step_;
        states.time = next_time_;
        while (!at_end_ && next_step_ == step_) {
            states.bodies.push_back(next_);
            read();
        }
        return true;
    }

    std::vector<std::string> contacts_of(const std::string& body) override {
        return contacts_ ? contacts_->contacts_of(body, step_) : std::vector<std::string>{};
    }

private:
    void read() {
        std::array<char*, 9> fields{};
        at_end_ = !csv_.read(fields);
        if (at_end_) return;
        next_step_ = csv_.number<std::uint64_t>(fields[0]);
        next_time_ = csv_.number<double>(fields[1]);
        next_.body = fields[2];
        next_.has_name = !is_automatic(next_.body);
        for (std::size_t i = 0; i < kComponents.size(); ++i) {
            const char* const text = fields[3 + i];
            next_.values[i] = i < kDoubleComponents ? csv_.number<double>(text) : double{csv_.number<float>(text)};
        }
    }

    CsvFile<9> csv_;
    std::optional<ContactFile> contacts_;
    std::uint64_t step_ = 0;  // returned last
    NamedState next_;         // the first body of the step after it
    std::uint64_t next_step_ = 0;
    double next_time_ = 0.0;
    bool at_end_ = false;
};

// Simulates a scene one step per call.
class RunningStates final : public SceneStates {
public:
    RunningStates(const std::filesystem::path& file, const LoadOptions& changes)
        : SceneStates(load_scene_input(file, changes)), run_(*scene()), last_step_(count_steps(*scene())) {}

    bool next(StepStates& states) override {
        if (started_ && (run_.world().step_count() >= last_step_ || run_.is_stopped())) return false;
        if (started_) run_.step();
        started_ = true;
        list(states, run_.world().step_count(), run_.time());
        return true;
    }

    const SceneWorld* built() const override { return &run_.built(); }

private:
    SceneRun run_;
    std::uint64_t last_step_ = 0;
    bool started_ = false;
};

}  // namespace

bool is_scene_file(const std::filesystem::path& path) {
    if (is_standard_input(path)) return !standard_input().starts_with("step,");
    return !std::filesystem::is_directory(path) && path.extension() != ".csv";
}

std::unique_ptr<StateSource> open_states(const std::filesystem::path& path, const LoadOptions& changes) {
    if (std::filesystem::is_directory(path)) {
        const std::filesystem::path trajectory = path / "trajectory.csv";
        if (!std::filesystem::exists(trajectory))
            throw InputError(path.string() +
                             ": the folder contains no trajectory.csv; run the scene with --trajectory " +
                             trajectory.string());
        return std::make_unique<TrajectoryStates>(trajectory);
    }
    if (is_scene_file(path)) return std::make_unique<RunningStates>(path, changes);
    return std::make_unique<TrajectoryStates>(path);
}

}  // namespace tumble::tools
