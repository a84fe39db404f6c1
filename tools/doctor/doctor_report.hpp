// What tumble finds on this machine: back ends of frames, fonts, encoders of videos, and the processor.
#pragma once

#include <string>
#include <vector>

#include "tools/output/json_writer.hpp"

namespace tumble::tools {

// One thing that tumble uses, if it is there.
struct Finding {
    std::string name;  // "osmesa", "text", "mp4"
    bool works = false;
    std::string detail{};   // what it is, or why it does not work
    std::string package{};  // of Debian, that has it; empty if none would help
    double seconds = 0.0;   // wall clock of the test
};

struct DoctorReport {
    std::vector<Finding> back_ends;  // each has drawn a triangle
    std::vector<Finding> fonts;      // of text in frames, and of further scripts
    std::vector<Finding> encoders;   // the formats of videos, each with an encoded frame

    // What works: frames with any back end; text with the first font; videos of every format.
    bool frames() const;
    bool text() const;
    bool videos() const;
};

// Tests everything; takes about a second. Writes temporary files, and removes them.
DoctorReport examine_machine();

std::string to_text(const DoctorReport& report);
void write_report(JsonWriter& json, const DoctorReport& report);

}  // namespace tumble::tools
