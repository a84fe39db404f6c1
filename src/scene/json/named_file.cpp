#include "scene/json/named_file.hpp"

#include "tumble/file.hpp"

namespace tumble::scene {

void check_named_file(const std::filesystem::path& named, const std::filesystem::path& file, const std::string& pointer,
                      Diagnostics& diagnostics) {
    if (named.empty() || !leads_outside(file.parent_path(), named)) return;
    diagnostics.error(pointer, "leads out of the folder of this file", "--allow-outside permits it");
}

}  // namespace tumble::scene
