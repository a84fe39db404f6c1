// The bodies of all frames as one JSON file in the format of COCO (cocodataset.org, "Data format"): boxes, outlines,
// visibility, and key points at joints.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/labels/labelled_frame.hpp"
#include "tools/output/json_writer.hpp"
#include "tumble/file.hpp"
#include "tumble/recording.hpp"

namespace tumble::tools {

class CocoFile {
public:
    // The world must be in its initial state, which has all joints that ever exist. Throws FileError.
    CocoFile(const std::filesystem::path& file, bool force, const Scene& scene, const SceneWorld& built);

    void add(const SceneWorld& built, const LabelledFrame& frame, const FrameLabels& labels);

    // Returns the size in bytes.
    std::uint64_t finish(const SceneWorld& built);

private:
    // The anchor of a joint on a body; its slot is that in the list of its category.
    struct KeyPoint {
        std::size_t joint = 0;  // in SceneWorld::joints
        bool is_b = false;
        std::size_t slot = 0;
    };

    void add_key_points(const SceneWorld& built);
    void add_annotation(const SceneWorld& built, const LabelledFrame& frame, const FrameLabels& labels,
                        const LabelledBody& body);
    void write_outlines(const SceneWorld& built, const LabelledFrame& frame, const LabelledBody& body);
    void write_key_points(const SceneWorld& built, const LabelledFrame& frame, const Mask& mask,
                          const LabelledBody& body, std::size_t category);

    const Scene& scene_;
    OutputFile file_;
    std::map<std::size_t, std::vector<KeyPoint>> key_points_;     // by index in SceneWorld::bodies
    std::map<std::size_t, std::vector<std::string>> categories_;  // names of key points, by source
    JsonWriter json_{JsonWriter::Layout::compact};
    std::string images_;
    std::uint64_t annotations_ = 0;
};

}  // namespace tumble::tools
