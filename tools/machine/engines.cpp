#include "tools/machine/engines.hpp"

#include "reference/box2d/b2_build.hpp"
#include "tools/machine/build_info.hpp"
#include "tumble/instruction_set.hpp"

namespace tumble::tools {

std::array<EngineBuild, 2> compared_engines() {
    return {{{"tumble", version(),
              compiler_name() + " " + compiler_flags() + ", " + instruction_set() + " of this processor"},
             {"Box2D", reference::box2d_version(), reference::box2d_build()}}};
}

std::string engines_text() {
    std::string text;
    for (const EngineBuild& engine : compared_engines())
        text += engine.name + " " + engine.version + ": " + engine.build + "\n";
    return text;
}

void write_engines(JsonWriter& json) {
    json.key("engines").open_object();
    for (const EngineBuild& engine : compared_engines())
        json.key(engine.name == "Box2D" ? "box2d" : "tumble")
            .open_object()
            .member("version", engine.version)
            .member("build", engine.build)
            .close_object();
    json.close_object();
}

}  // namespace tumble::tools
