#include "tools/scene/image_paths.hpp"

#include "tumble/file.hpp"

namespace tumble::tools {

namespace fs = std::filesystem;

std::vector<std::string> move_images(Scene& scene, const fs::path& from, const fs::path& to, bool allow_outside) {
    std::vector<std::string> removed;
    const fs::path old_folder = fs::absolute(from).lexically_normal(), folder = fs::absolute(to).lexically_normal();
    for (SceneBody& body : scene.bodies)
        std::erase_if(body.images, [&](SceneImage& image) {
            const fs::path moved = (old_folder / image.file).lexically_normal().lexically_proximate(folder);
            if (!allow_outside && leads_outside(to, moved)) {
                removed.push_back(image.file);
                return true;
            }
            image.file = moved.generic_string();
            return false;
        });
    return removed;
}

}  // namespace tumble::tools
