#include "scene/load/named_files.hpp"

#include <string>

#include "tumble/file.hpp"

namespace tumble::scene {

void check_named_file(const std::filesystem::path& named, const std::filesystem::path& file, const std::string& pointer,
                      Diagnostics& diagnostics) {
    if (named.empty() || !leads_outside(file.parent_path(), named)) return;
    diagnostics.error(pointer, "leads out of the folder of this file", "--allow-outside permits it");
}

void check_named_files(const Scene& scene, const std::filesystem::path& file, Diagnostics& diagnostics) {
    for (std::size_t i = 0; i < scene.include.size(); ++i)
        check_named_file(scene.include[i].file, file, "/include/" + std::to_string(i) + "/file", diagnostics);
    for (std::size_t i = 0; i < scene.expect.size(); ++i) {
        const std::string claim = "/expect/" + std::to_string(i);
        check_named_file(scene.expect[i].picture, file, claim + "/picture", diagnostics);
        check_named_file(scene.expect[i].reference, file, claim + "/reference", diagnostics);
    }
}

}  // namespace tumble::scene
