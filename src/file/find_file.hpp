// Files that other files name, such as the images of a scene.
#pragma once

#include <filesystem>
#include <string>

namespace tumble {

struct FoundFile {
    bool is_there = false;  // something has the path, though it may be no file
    std::string fault;      // why it cannot be read, as what follows its name; empty: it can, or nothing is there
};

// Looks, and does not open: a pipe would wait for its other end.
FoundFile find_file(const std::filesystem::path& file);

// Whether there is a file. Throws FileError if something is there that is no regular file or cannot be read.
bool is_file_there(const std::filesystem::path& file);

}  // namespace tumble
