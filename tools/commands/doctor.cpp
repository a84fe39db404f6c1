// `tumble doctor`: what works on this machine, and what to install.
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "tools/cli/console.hpp"
#include "tools/commands/commands.hpp"
#include "tools/doctor/doctor_report.hpp"
#include "tools/output/json_writer.hpp"

namespace tumble::tools {

namespace {

struct Part {
    const char* name;
    bool (DoctorReport::*works)() const;
};
constexpr Part kParts[] = {
    {"frames", &DoctorReport::frames}, {"text", &DoctorReport::text}, {"videos", &DoctorReport::videos}};

// The parts of a list; all of an empty one.
std::vector<Part> parts_of(const std::string& list) {
    if (list.empty()) return {std::begin(kParts), std::end(kParts)};
    std::vector<Part> parts;
    std::istringstream names(list);
    for (std::string name; std::getline(names, name, ',');) {
        const auto part = std::ranges::find(kParts, name, [](const Part& known) { return std::string(known.name); });
        if (part == std::end(kParts))
            throw CLI::ValidationError("--need", "expected frames, text or videos, separated by commas, got " + name);
        parts.push_back(*part);
    }
    return parts;
}

ExitCode examine(const Command& command, const std::string& needed) {
    const std::vector<Part> parts = parts_of(needed);
    const DoctorReport report = examine_machine();
    if (command.json) {
        JsonWriter json;
        write_report(json, report);
        write_output(json.text() + "\n");
    } else {
        write_output(to_text(report));
    }
    const bool works = std::ranges::all_of(parts, [&](const Part& part) { return (report.*part.works)(); });
    return works ? ExitCode::ok : ExitCode::rendering;
}

}  // namespace

void add_doctor(CLI::App& app, Command& command) {
    const auto needed = std::make_shared<std::string>();
    CLI::App& doctor = add_subcommand(app, command, "doctor", "Tell what works on this machine, and what to install");
    doctor
        .add_option("--need", *needed,
                    "What must work for exit code 0: frames, text, videos, separated by commas; default: all")
        ->type_name("LIST");
    doctor.callback([&command, needed] { command.action = [&command, needed] { return examine(command, *needed); }; });
}

}  // namespace tumble::tools
