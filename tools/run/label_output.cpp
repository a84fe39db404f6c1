#include "tools/run/label_output.hpp"

#include <map>
#include <string>

#include "tools/cli/console.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/measure/stopwatch.hpp"
#include "tools/run/run_folder.hpp"

namespace tumble::tools {

namespace {

// The path in the folder of the run.
std::string name_in(const std::filesystem::path& folder, const std::filesystem::path& file) {
    return file.lexically_relative(folder).generic_string();
}

// The shapes of the order of drawing, each as [label, index of the shape on its body].
void write_order(JsonWriter& json, const World& world, const FrameLabels& labels) {
    json.key("order").open_array();
    std::map<BodyId, std::map<ShapeId, std::size_t>> numbers;
    for (const LabelledShape& drawn : labels.order) {
        const auto [own, is_new] = numbers.try_emplace(world.body(drawn.shape));
        if (is_new) {
            std::size_t number = 0;
            for (const ShapeId shape : world.shapes(own->first)) own->second[shape] = number++;
        }
        json.open_array().value(drawn.label).value(own->second.at(drawn.shape)).close_array();
    }
    json.close_array().key("covered").open_array();
    for (const CoveredPixels& pair : labels.covered)
        json.open_array().value(pair.above).value(pair.below).value(pair.pixels).close_array();
    json.close_array();
}

}  // namespace

LabelOutput::LabelOutput(const Scene& scene, const SceneWorld& world, const RunOptions& options,
                         const FrameSchedule& schedule)
    : scene_(scene),
      options_(options),
      schedule_(schedule),
      camera_(make_camera(scene, world, options.size.aspect_ratio())),
      labeller_(options.size.width, options.size.height),
      file_(open_output(labels_file(options.folder), options.force)) {
    if (options.boxes) boxes_.emplace(boxes_file(options.folder), options.force, scene, world);
    file_.write("{\"width\": " + std::to_string(options.size.width) +
                ", \"height\": " + std::to_string(options.size.height) + ", \"frames\": [");
}

void LabelOutput::label_due(const SceneWorld& world) {
    const Stopwatch watch;
    camera_ = move_camera(camera_, scene_, world);
    if (next_frame_ < schedule_.frame_count() && schedule_.step_of_frame(next_frame_) == world.world.step_count()) {
        const Camera shown = apply_camera_keys(camera_, scene_, world, options_.size.aspect_ratio());
        const FrameLabels& labels = labeller_.label(scene_, world, shown);
        do write_frame(world, shown, labels);
        while (++next_frame_ < schedule_.frame_count() &&
               schedule_.step_of_frame(next_frame_) == world.world.step_count());
    }
    seconds_ += watch.seconds();
}

void LabelOutput::write_frame(const SceneWorld& world, const Camera& camera, const FrameLabels& labels) {
    LabelledFrame frame{.frame = next_frame_,
                        .step = world.world.step_count(),
                        .time = world.world.time(),
                        .camera = camera,
                        .width = options_.size.width,
                        .height = options_.size.height,
                        .image = name_in(options_.folder, frame_file(options_.folder, next_frame_)),
                        .mask = {}};
    add_view(views_, view_of(camera, options_.size, next_frame_));
    if (options_.masks) {
        const std::filesystem::path mask = mask_file(options_.folder, next_frame_);
        mask_bytes_ += write_mask_png(labels.mask, mask);
        frame.mask = name_in(options_.folder, mask);
    }
    if (boxes_) boxes_->add(world, frame, labels);
    json_.clear();
    json_.open_object().member("frame", frame.frame);
    if (!options_.no_frames) json_.member("image", frame.image);
    write_frame_members(json_, frame);
    if (options_.depth_order) write_order(json_, world.world, labels);
    json_.close_object();
    file_.write((next_frame_ > 0 ? ",\n" : "\n") + json_.text());
}

void LabelOutput::write_bodies(const SceneWorld& world) {
    const char* separator = "\n";
    for (std::size_t i = 0; i < world.bodies.size() && i < kMostLabels; ++i) {
        json_.clear();
        json_.open_object().member("label", i + 1).member("name", output_name(world.bodies[i], i));
        json_.member("category_id", world.bodies[i].source + 1).close_object();
        file_.write(separator + json_.text());
        separator = ",\n";
    }
    if (world.bodies.size() > kMostLabels)
        report_warning("bodies after the first " + std::to_string(kMostLabels) +
                       " have no label: the labels leave them out");
}

std::vector<WrittenFiles> LabelOutput::finish(const SceneWorld& world) {
    std::vector<WrittenFiles> files;
    if (options_.masks) files.push_back({"masks", mask_file(options_.folder, 0), next_frame_, mask_bytes_});
    if (boxes_) files.push_back({"boxes", boxes_file(options_.folder), 1, boxes_->finish(world)});
    file_.write("],\n\"bodies\": [");
    write_bodies(world);
    file_.write("]}\n");
    files.push_back({"labels", labels_file(options_.folder), 1, file_.commit()});
    return files;
}

}  // namespace tumble::tools
