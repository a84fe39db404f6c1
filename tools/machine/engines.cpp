#include "tools/machine/engines.hpp"

#include "reference/box2d/b2_build.hpp"
#include "reference/box2d_v3/v3_queries.hpp"
#include "tools/machine/build_info.hpp"
#include "tumble/instruction_set.hpp"

namespace tumble::tools {

std::array<EngineBuild, 2> compared_engines() {
    return {{{"tumble", version(),
              compiler_name() + " " + compiler_flags() + ", " + instruction_set() + " of this processor"},
             {"Box2D", reference::box2d_version(), reference::box2d_build()}}};
}

EngineBuild box2d_v3_engine() { return {"Box2D v3", reference::box2d_v3_version(), reference::box2d_v3_build()}; }

std::string engines_text(bool with_v3) {
    const auto line = [](const EngineBuild& engine) {
        return engine.name + " " + engine.version + ": " + engine.build + "\n";
    };
    const auto [tumble, box2d] = compared_engines();
    return line(tumble) + line(box2d) + (with_v3 ? line(box2d_v3_engine()) : "");
}

void write_engines(JsonWriter& json, bool with_v3) {
    const auto write = [&](const char* key, const EngineBuild& engine) {
        json.key(key).open_object().member("version", engine.version).member("build", engine.build).close_object();
    };
    const auto [tumble, box2d] = compared_engines();
    json.key("engines").open_object();
    write("tumble", tumble);
    write("box2d", box2d);
    if (with_v3) write("box2d_v3", box2d_v3_engine());
    json.close_object();
}

}  // namespace tumble::tools
