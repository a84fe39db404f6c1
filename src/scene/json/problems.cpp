// The pages of all codes. Every example of a warning or an error is a scene that has it; a test reads them all.
#include "tumble/scene_file.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "scene/json/problem_codes.hpp"

namespace tumble {
namespace {

constexpr auto kWarning = ProblemPage::Kind::warning, kError = ProblemPage::Kind::error,
               kExitCode = ProblemPage::Kind::exit_code;
namespace codes = scene::codes;

constexpr ProblemPage kPages[] = {
    {kWarning, codes::no_mass, "a body without mass",
     "A dynamic body whose shapes are segments, chains or sensors has no area, so that its density gives no "
     "mass. It gets 1 kg and does not rotate.",
     R"({"format": 1, "bodies": [{"shapes": [{"segment": {"from": [0, 0], "to": [1, 0]}}]}]})",
     R"(Give the body a "mass" with mass and inertia, or a shape with an area.)"},
    {kWarning, codes::static_velocity, "a static body with a velocity",
     "A static body never moves. Its velocity has no effect on it, nor on the bodies that touch it.",
     R"({"format": 1, "bodies": [{"type": "static", "velocity": [1, 0], "shapes": [{"box": {"size": [2, 1]}}]}]})",
     R"(Set "type": "kinematic" for a body that moves at the velocity it is given, or a "tangent_speed" in the )"
     "material of a conveyor belt."},
    {kWarning, codes::unused_mass, "a mass of a body that is not dynamic",
     "Nothing pushes a static or kinematic body, so that its mass has no effect.",
     R"({"format": 1, "bodies": [{"type": "static", "mass": {"mass": 3, "inertia": 1}, "shapes": [{"box": {"size": [2, 1]}}]}]})",
     R"(Leave "mass" out, or make the body dynamic.)"},
    {kWarning, codes::missing_image, "an image without its file",
     "The body has an image whose file does not exist or cannot be read. If there is no file, frames show the outline "
     "of the image instead. If there is a folder, a pipe or a file that cannot be read, a command that draws frames "
     "ends with an error.",
     R"({"format": 1, "bodies": [{"shapes": [{"circle": {"radius": 0.5}}], "images": [{"file": "no.png", "height": 1}]}]})",
     "Correct the path, which is relative to the folder of the scene's file, or add the file. If it exists, allow its "
     "reading."},
    {kWarning, codes::radians, "an angle that seems to be in radians",
     "Angles in scene files are in degrees. The number is 30, 45, 60, 90, 120, 135, 150, 180, 270 or 360 degrees in "
     "radians, "
     "up to a factor of 1.0006 if it has at most four decimals, and of 1.000001 if it has more.",
     R"({"format": 1, "bodies": [{"angle": 1.5708, "shapes": [{"box": {"size": [2, 1]}}]}]})",
     "Write the degrees: 90 in place of 1.5708. If the number is meant in degrees, ignore the warning."},
    {kWarning, codes::outside_limits, "a joint that starts outside of its limits",
     "The angle of the joint is out of its range when the run starts. The joint turns its bodies into the range at "
     "once.",
     R"({"format": 1, "bodies": [{"name": "a", "type": "static"}, {"name": "b", "shapes": [{"box": {"size": [2, 1]}}]}],
 "joints": [{"type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0], "limits": [10, 50]}]})",
     R"(The angle is 0 at load, unless a "reference_angle" is stated: shift the "limits", or turn the bodies.)"},
    {kWarning, codes::sliver, "a thin shape",
     "The shape is over 100 times longer than thick. Its inertia about its length is almost zero, and "
     "contacts on it jitter.",
     R"({"format": 1, "bodies": [{"position": [0, 5], "shapes": [{"polygon": {"vertices": [[0, 0], [3, 1], [3, )"
     "1.02]]}}]}]}",
     "Make the shape thicker, or use a capsule, whose ends are round."},
    {kWarning, codes::unusual_size, "a size outside the tested range",
     R"(The margins and tolerances of the solver are lengths that suit bodies of about the "scale" of the )"
     "world. Much smaller bodies rest visibly above the ground, much larger ones sink in.",
     R"({"format": 1, "bodies": [{"shapes": [{"circle": {"radius": 0.002}}]}]})",
     R"(Set the "scale" of the world to the size of a typical body, and multiply "steps_per_second" by 1 / )"
     "sqrt(scale)."},
    {kWarning, codes::ignored_vertices, "vertices of a polygon that have no effect",
     "A polygon is the convex hull of its vertices. Those inside it, on an edge or twice in the list are "
     "ignored.",
     R"({"format": 1, "bodies": [{"shapes": [{"polygon": {"vertices": [[0, 0], [2, 0], [2, 2], [1, 0.5]]}}]}]})",
     R"(Remove these vertices, or use an "outline", which may be concave.)"},
    {kWarning, codes::fast_body, "a body that may pass through others",
     "The body moves farther in one step than it is thick. Fast bodies are swept against all others by default. "
     R"(With "impacts": "at_step_end", only bullets are swept against dynamic bodies; with "continuous": false, )"
     "no body is swept.",
     R"({"format": 1, "world": {"impacts": "at_step_end"}, "bodies": [{"position": [50, 0], "shapes": [{"box": )"
     R"({"size": [1, 1]}}]}, {"velocity": [60, 0], "shapes": [{"circle": {"radius": 0.25}}]}]})",
     R"(Remove "impacts" or "continuous" from the world, set "bullet": true on the body, or use more )"
     R"("steps_per_second".)"},
    {kWarning, codes::behind_chain, "a body on the solid side of a chain",
     "A chain is one-sided: its solid side is on the left, seen along its points, and it stops only bodies that "
     "come from the right. This body starts on the left and falls through.",
     R"({"format": 1, "bodies": [{"name": "hills", "type": "static", "shapes": [{"chain": {"points": [[0, 0], )"
     R"([1, 0], [3, 0], [4, 0]]}}]}, {"name": "car", "position": [2, 3], "shapes": [{"circle": {"radius": )"
     "0.5}}]}]}",
     R"(Reverse the order of the points, or set "two_sided": true.)"},
    {kWarning, codes::overlap, "bodies that start inside each other",
     "Two bodies overlap by more than resting contacts do. The solver pushes them apart, which looks like an "
     "explosion if they are deep.",
     R"({"format": 1, "bodies": [{"type": "static", "position": [0, -0.5], "shapes": [{"box": {"size": [90, )"
     R"(1]}}]}, {"position": [0, 0.3], "shapes": [{"box": {"size": [1, 1]}}]}]})",
     R"(Move one of the bodies, or let a "filter" exclude their contact.)"},
    {kWarning, codes::contact_mass_ratio, "contact of bodies of very different mass",
     "A body that carries one over 100 times heavier is squeezed: the iterations of the solver do not carry "
     "the weight through it in one step.",
     R"({"format": 1, "bodies": [{"type": "static", "position": [0, -0.5], "shapes": [{"box": {"size": [90, )"
     R"(1]}}]}, {"position": [0, 0.25], "shapes": [{"box": {"size": [0.5, 0.5]}}]}, {"position": [0, 1], )"
     R"("shapes": [{"box": {"size": [1, 1]}, "material": "lead"}]}], "materials": {"lead": {"density": 900}}})",
     R"(Bring the densities closer together, or give the world more "substeps".)"},
    {kWarning, codes::asleep_in_the_air, "a sleeping body without support",
     R"(A body with "awake": false stays where it is until something touches it, also in the air.)",
     R"({"format": 1, "bodies": [{"position": [0, 5], "awake": false, "shapes": [{"box": {"size": [1, 1]}}]}]})",
     R"(Remove "awake": false, or place the body on its support.)"},
    {kWarning, codes::sinking_stack, "a stack that sinks",
     "Contacts are springs: each one yields a little under load. In a high or heavy stack, or under strong "
     "gravity, this adds up to a visible length.",
     R"({"format": 1, "bodies": [{"type": "static", "position": [0, -0.5], "shapes": [{"box": {"size": [90, )"
     R"(1]}}]}, {"position": [0, 0.5], "repeat": {"grid": {"columns": 1, "rows": 60, "spacing": [1, 1]}}, )"
     R"("shapes": [{"box": {"size": [1, 1]}}]}], "world": {"gravity": [0, -100]}})",
     R"(Stack fewer or lighter bodies, lower the gravity, or use more "substeps".)"},
    {kWarning, codes::spread_impact, "an impact that spreads over bodies that touch",
     "With \"impacts\": \"at_step_end\" all contacts of a row of bodies that touch are solved at once: a hit on the "
     "first moves several, where one after the other would leave all but the last at rest.",
     R"({"format": 1, "world": {"impacts": "at_step_end"}, "bodies": [{"repeat": {"grid": {"columns": 3, )"
     R"("spacing": [1, 0]}}, "shapes": [{"circle": {"radius": 0.5}, "material": "steel"}]}], "materials": )"
     R"({"steel": {"restitution": 1}}})",
     R"(Set "impacts": "in_order" for the world, or leave a gap between the bodies that one step does not close.)"},
    {kWarning, codes::joint_mass_ratio, "a joint between bodies of very different mass",
     "A joint stretches if one of its bodies is over 100 times heavier than the other.",
     R"({"format": 1, "bodies": [{"name": "a", "shapes": [{"circle": {"radius": 0.1}}]}, {"name": "b", )"
     R"("position": [0, -6], "shapes": [{"circle": {"radius": 2}}]}], "joints": [{"type": "revolute", "bodies": )"
     R"(["a", "b"], "anchor": [0, -2]}]})",
     R"(Bring the densities closer together, use more "substeps", or set "joints": "direct" for the world.)"},
    {kWarning, codes::open_joint, "a joint that starts apart",
     "The bodies start at poses that the joint does not allow. The first steps pull them together, at high "
     "speed.",
     R"({"format": 1, "bodies": [{"name": "a", "shapes": [{"box": {"size": [1, 1]}}]}, {"name": "b", )"
     R"("position": [8, 0], "shapes": [{"box": {"size": [1, 1]}}]}], "world": {"gravity": [0, 0]}, "joints": )"
     R"([{"type": "distance", "bodies": ["a", "b"], "anchors": [[0, 0], [0, 0]], "length": 30}]})",
     R"(Correct the anchors, the "length" or the "limits", or move the bodies.)"},
    {kWarning, codes::far_anchor, "a joint far from its bodies",
     "The lever arm of the joint is over 10 times the size of its bodies. Most often, a point in the "
     "coordinates of a body was written as a point of the world.",
     R"({"format": 1, "bodies": [{"name": "a", "shapes": [{"box": {"size": [1, 1]}}]}, {"name": "b", )"
     R"("position": [8, 0], "shapes": [{"box": {"size": [1, 1]}}]}], "world": {"gravity": [0, 0]}, "joints": )"
     R"([{"type": "revolute", "bodies": ["a", "b"], "anchor": [50, 50]}]})",
     R"(Check the point: "anchor" is a point of the world, "anchors" are points in the coordinates of each body.)"},
    {kWarning, codes::stiff_spring, "a spring that the steps cannot follow",
     "A spring needs a few sub-steps in each of its periods. This one is stiffer and is limited to the stated "
     "frequency.",
     R"({"format": 1, "bodies": [{"name": "a", "shapes": [{"box": {"size": [1, 1]}}]}, {"name": "b", )"
     R"("position": [8, 0], "shapes": [{"box": {"size": [1, 1]}}]}], "world": {"gravity": [0, 0]}, "joints": )"
     R"([{"type": "distance", "bodies": ["a", "b"], "anchors": [[0, 0], [0, 0]], "spring": {"hertz": 500}}]})",
     R"(Use more "substeps" or "steps_per_second", a softer spring, or a rigid joint.)"},
    {kWarning, codes::joined_copies, "copies of a joint that share one point",
     "The joint is repeated, and one of its bodies is not: all copies act at the same point of that body, and "
     "have different lengths.",
     R"({"format": 1, "bodies": [{"name": "beam", "type": "static", "position": [0, 4], "shapes": [{"box": )"
     R"({"size": [9, 1]}}]}, {"name": "ball", "repeat": {"grid": {"columns": 3}}, "shapes": [{"circle": )"
     R"({"radius": 0.4}}]}], "joints": [{"type": "distance", "bodies": ["beam", "ball[0]"], "anchors": [[0, 0], )"
     R"([0, 0]], "repeat": {"columns": 3}}]})",
     R"(Give "repeat" a "spacing": it moves the point on that body from copy to copy. Or repeat that body too.)"},
    {kWarning, codes::after_the_end, "an event or a claim after the end of the run",
     "The run ends before this time. The event never happens, and the claim cannot hold.",
     R"({"format": 1, "bodies": [{"name": "ball", "position": [0, 1], "shapes": [{"circle": {"radius": )"
     R"(0.5}}]}], "world": {"duration": 3}, "timeline": [{"at": 9, "gravity": [0, 0]}]})",
     R"(Choose an earlier time, or a longer "duration" of the world.)"},
    {kWarning, codes::useless_force, "a force on a body that it does not move",
     "Forces and impulses move dynamic bodies only.",
     R"({"format": 1, "bodies": [{"name": "wall", "type": "static", "shapes": [{"box": {"size": [1, 9]}}]}], )"
     R"("timeline": [{"at": 1, "body": "wall", "impulse": [1, 0]}]})",
     R"(Make the body "dynamic", or set the "velocity" of a kinematic body.)"},
    {kWarning, codes::event_after_removal, "an event for what is gone",
     "An earlier event removes the body or the joint that this event acts on.",
     R"({"format": 1, "bodies": [{"name": "ball", "position": [0, 1], "shapes": [{"circle": {"radius": )"
     R"(0.5}}]}], "timeline": [{"at": 2, "body": "ball", "impulse": [1, 0]}, {"at": 1, "despawn": "ball"}]})",
     "Choose an earlier time for the event, or remove the body later."},
    {kError, codes::json, "text that is not JSON",
     "The file is not a JSON document: a comma or a bracket is missing, or the text is cut off. Comments are "
     "allowed.",
     R"({"format": 1,, "bodies": []})",
     "Correct the text at the caret. An editor with JSON support shows the place while you type."},
    {kError, codes::drawing, "a drawing that cannot be imported",
     "The file is not XML, has no <svg> element, or an element of it is not valid SVG.",
     R"(<svg xmlns="http://www.w3.org/2000/svg"><circle r="-1"/></svg>)",
     "Correct the element at the caret, or save the drawing again as plain SVG."},
    {kError, codes::scene, "an error outside of all lists",
     "A key of the scene itself is missing, unknown, there twice, or of another type. Every scene states "
     R"("format": 1.)",
     R"({"bodies": []})",
     R"(Add "format": 1, and compare the keys with the table of the scene format: scenes/README.md.)"},
    {kError, codes::world, "an error in the settings of the world",
     "A setting is unknown, of another type or out of its range.",
     R"({"format": 1, "world": {"steps_per_second": -60}})",
     R"(The table "world" of scenes/README.md has the unit and the range of each setting.)"},
    {kError, codes::camera, "an error in the camera",
     R"(A key is unknown or out of its range, "follow" or a note names a body that the scene does not have, or the key )"
     "frames are not in the order of time.",
     R"({"format": 1, "camera": {"follow": "x"}})",
     "Give the center in metres and the height above 0, and follow a body by its name."},
    {kError, codes::include, "a part that cannot be included",
     "The included file is missing, is not a scene, or includes itself.",
     R"({"format": 1, "include": [{"position": [1, 2]}]})",
     R"("file" is a path relative to the scene that includes it.)"},
    {kError, codes::material, "an error in a material",
     "A property is unknown or out of its range. Density, friction and restitution are not negative.",
     R"({"format": 1, "materials": {"ice": {"friction": -1}}})",
     R"(The table "materials" of scenes/README.md has the range of each property.)"},
    {kError, codes::body, "an error in a body",
     "A key is unknown, of another type or out of its range, or a name occurs twice.",
     R"({"format": 1, "bodies": [{"type": "dynamicc"}]})",
     R"(The table "bodies" of scenes/README.md lists the keys. Angles are in degrees, lengths in metres.)"},
    {kError, codes::shape, "an error in a shape",
     R"(A shape needs exactly one geometry, such as "box" or "circle", with sizes above 0, and materials that )"
     "the scene declares.",
     R"({"format": 1, "bodies": [{"shapes": [{"circle": {"radius": 0}}]}]})",
     "Give a size above 0. Vertices of a polygon must enclose an area, and an outline must not cross itself."},
    {kError, codes::joint, "an error in a joint",
     "The bodies are missing or unknown, or the type of the joint lacks a key that it needs or has one that "
     "belongs to another type.",
     R"({"format": 1, "joints": [{"type": "revolute", "bodies": ["a", "b"], "anchor": [0, 0]}]})",
     R"(Name two bodies of the scene. The table "joints" of scenes/README.md states which keys a type has.)"},
    {kError, codes::event, "an error in the timeline",
     "The event has no time or no action, has two actions, or names what the scene does not have.",
     R"({"format": 1, "timeline": [{"at": 1, "body": "ball", "impulse": [1, 0]}]})",
     R"(Give one of "at", "every" and "when", and one action on a body or a joint of the scene.)"},
    {kError, codes::claim, "an error in a claim",
     "The claim is incomplete, mixes two claims, or names what the scene does not have.",
     R"({"format": 1, "expect": [{"body": "ball", "height": [0, 1]}]})",
     R"(The table "expect" of scenes/README.md has the form of each claim.)"},
    {kExitCode, "exit-1", "a bug or no memory",
     "tumble failed in a manner that it does not expect: it has a bug, or there is too little memory.",
     "tumble run scene.json --threads 256",
     "Report the message and the scene. With too little memory, run a smaller scene."},
    {kExitCode, "exit-2", "wrong arguments",
     "An option or an argument is unknown, missing or out of its range. Nothing was read or written.",
     "tumble run scene.json --fps fast", R"("tumble COMMAND --help" lists the options with their ranges.)"},
    {kExitCode, "exit-3", "invalid input",
     "A scene, a query or a table has errors. Their lines and columns are listed.", "tumble run broken.json",
     R"(Correct the file. "tumble validate" lists all errors at once, "tumble explain CODE" tells of one kind.)"},
    {kExitCode, "exit-4", "a file cannot be read or written",
     "The file is missing, unreadable, or exists already; or the disk is full; or another run uses the folder.",
     "tumble shot scene.json -o exists.png", "Check the path. --force replaces files that exist."},
    {kExitCode, "exit-5", "frames cannot be drawn",
     "OSMesa and EGL or the font are missing, or ffmpeg failed to encode.", "tumble run scene.json --video run.mp4",
     "\"tumble doctor\" tells what is missing and which package has it. --no-frames runs without drawing."},
    {kExitCode, "exit-6", "the simulation diverged",
     "The position or the velocity of a body is not finite any more. The message names the body.",
     "tumble run explosion.json",
     R"(Look for overlapping bodies, springs that are too stiff and joints that start apart: "tumble validate" )"
     R"(warns of them. Use more "substeps".)"},
    {kExitCode, "exit-7", "a claim does not hold or a comparison differs",
     R"("check" found a claim that does not hold, or "diff", "parity", "physics" or "import --check" found a )"
     R"(difference, or "run --fail-on-findings" a fault, or shards of a "sweep" are missing or damaged.)",
     "tumble check scene.json",
     R"("tumble check" states the time and the distance by which the claim failed, and --shots draws the state. )"
     "The other commands list what they found."},
    {kExitCode, "exit-130", "interrupted",
     "The command was ended by SIGINT (Ctrl-C) or SIGHUP. What was complete is kept.", "tumble watch scene.json",
     R"(None is needed. "run --resume" continues a run that has a checkpoint.)"},
    {kExitCode, "exit-143", "terminated", "The command was ended by SIGTERM, as services and schedulers do.",
     "timeout 5 tumble run scene.json --checkpoint 1", R"("run --resume" continues a run that has a checkpoint.)"},
};

// The kinds of objects by the first key of a pointer.
struct KeyCode {
    std::string_view key, code;
};
constexpr std::array<KeyCode, 8> kCodesOfKeys{{{"/world", codes::world},
                                               {"/camera", codes::camera},
                                               {"/include", codes::include},
                                               {"/materials", codes::material},
                                               {"/joints", codes::joint},
                                               {"/timeline", codes::event},
                                               {"/expect", codes::claim},
                                               {"/bodies", codes::body}}};

}  // namespace

std::span<const ProblemPage> problems() { return kPages; }

const ProblemPage* find_problem(std::string_view code) {
    const auto page = std::ranges::find(kPages, code, &ProblemPage::code);
    return page == std::end(kPages) ? nullptr : &*page;
}

namespace scene {

std::string_view code_of_error(std::string_view pointer) {
    const auto begins = [&](std::string_view key) {
        return pointer.starts_with(key) && (pointer.size() == key.size() || pointer[key.size()] == '/');
    };
    const auto key = std::ranges::find_if(kCodesOfKeys, [&](const KeyCode& entry) { return begins(entry.key); });
    if (key == kCodesOfKeys.end()) return codes::scene;
    const bool is_shape = key->code == codes::body && pointer.find("/shapes/") != std::string_view::npos;
    return is_shape ? codes::shape : key->code;
}

}  // namespace scene

}  // namespace tumble
