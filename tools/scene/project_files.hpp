// The files of a new project, as `tumble init` writes them.
#pragma once

#include <string>
#include <vector>

namespace tumble::tools {

struct ProjectFile {
    std::string path;  // relative to the folder of the project
    std::string text;
};

// Scenes with claims, the schema, a Makefile, and the workflow files of CI services. The `state_hash` claims of the
// scenes are still "0000000000000000".
std::vector<ProjectFile> project_files(const std::string& name);

}  // namespace tumble::tools
