// The frames of a run without compression, for programs that read them from a pipe.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "tumble/file.hpp"
#include "tumble/render.hpp"

namespace tumble::tools {

// Frames one after the other, without header: rows from the top, three bytes (red, green, blue) for each pixel.
class RawVideo {
public:
    // The file, or /dev/stdout for standard output. Throws FileError, as all functions do.
    explicit RawVideo(const std::filesystem::path& file);

    // Appends a frame, and passes it on before it returns.
    void write(const Image& image);

    // Returns the size in bytes. To be called once, last.
    std::uint64_t finish() { return file_.commit(); }

private:
    OutputFile file_;
    std::string bytes_;  // of a frame
};

}  // namespace tumble::tools
