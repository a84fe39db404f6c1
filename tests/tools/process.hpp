// Runs the tumble binary as a script does, and keeps its output.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tumble::test {

struct Answer {
    int code = -1;  // exit code, or 128 + the signal that ended the process
    std::string out;
    std::string err;
};

// A process that has been started.
class Process {
public:
    // `output` names a file that receives standard output instead of the pipe; `input` is standard input.
    explicit Process(const std::vector<std::string>& command, const std::filesystem::path& working_folder = ".",
                     const std::string& input = {}, const std::string& output = {});
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    int id() const { return id_; }
    void send_signal(int signal) const;
    bool is_running() const;
    Answer wait();

private:
    int id_ = -1;
    bool waited_ = false;
    std::filesystem::path folder_;  // input and output of the process
};

// Waits until the file exists or the process ends, a minute at most.
void wait_for(const std::filesystem::path& file, const Process& process);

Answer run(const std::vector<std::string>& command, const std::filesystem::path& working_folder = ".");

// The binary under test with these arguments.
Answer run_tumble(std::vector<std::string> arguments);
std::vector<std::string> tumble_command(std::vector<std::string> arguments);

// A new empty folder, removed with everything in it by the destructor.
class Folder {
public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    std::string write(const std::string& name, const std::string& text) const;  // returns the whole path

private:
    std::filesystem::path path_;
};

std::string read_text(const std::filesystem::path& file);

// Which of many slow cases a test runs: with the environment variable TUMBLE_ONE_OF=n each n-th, otherwise all. With
// sanitizers all would take minutes.
std::size_t case_stride();

// A scene of a few bodies over a ground.
std::string small_scene();

}  // namespace tumble::test
